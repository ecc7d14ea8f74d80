#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <umbral/record/tensor.hpp>
#include <vector>

namespace umbral::grader {

/// A tensor's values as doubles (exact for every element type), cell by cell.
///
/// Needs a well-formed tensor; copies its values, so the tensor may go away.
class TensorView {
public:
    explicit TensorView(const Tensor& tensor);

    [[nodiscard]] std::size_t cells() const noexcept { return cells_; }
    [[nodiscard]] std::size_t components() const noexcept { return components_; }
    [[nodiscard]] bool present(std::size_t cell) const { return present_.empty() || present_[cell] != 0; }
    [[nodiscard]] bool optional() const noexcept { return !present_.empty(); }
    [[nodiscard]] std::span<const double> cell(std::size_t index) const
    {
        return {values_.data() + index * components_, components_};
    }
    [[nodiscard]] std::span<const double> values() const noexcept { return values_; }

private:
    std::size_t cells_;
    std::size_t components_;
    std::vector<double> values_;
    std::vector<std::uint8_t> present_;
};

/// Are its values measured, and not counted or names?
[[nodiscard]] constexpr bool is_real(Element element)
{
    return element == Element::float32 || element == Element::float64;
}

/// All values of a well-formed tensor.
[[nodiscard]] std::vector<double> to_doubles(const Tensor& tensor);
/// The same; NaN in rows without an answer.
[[nodiscard]] std::vector<double> numbers_or_nan(const Tensor& tensor);

/// A tensor of the shape, type and presence of `like` with these values; integers are rounded and clamped to their
/// range.
[[nodiscard]] Tensor with_values(const Tensor& like, std::span<const double> values);

/// The tensor with one value, which no right answer has, for all that are not finite: two results that are both not
/// finite went wrong alike.
[[nodiscard]] Tensor made_finite(const Tensor& tensor);

/// Does the tensor hold as many bytes, and as much presence, as its shape says?
[[nodiscard]] bool well_formed(const Tensor& tensor);

/// What is wrong with the student's type or shape, as a sentence; nothing if it is the expected one.
[[nodiscard]] std::optional<std::string> shape_error(const Tensor& student, const Tensor& expected);

/// The same where the number of rows is free: type and components must be the expected ones, and an empty table fits
/// any.
[[nodiscard]] std::optional<std::string> row_shape_error(const Tensor& student, const Tensor& expected);

/// A recorded text (bytes); empty for a null pointer and for what is no text.
[[nodiscard]] std::string_view text_of(const Tensor* tensor);

[[nodiscard]] bool all_finite(std::span<const double> values);

/// Equal, or both no number.
[[nodiscard]] bool equal_or_both_nan(double a, double b);

/// "3.25", "1.6e+06", "nan", "inf", also of what drivers record for these (record/not_finite.hpp): in six significant
/// digits unless said otherwise. In the most digits, 0 keeps its sign.
inline constexpr int usual_digits = 6;
inline constexpr int most_digits = 17;  ///< of a double
[[nodiscard]] std::string number_text(double value, int digits = usual_digits);

/// Two texts in as few digits, six or more, as tell them apart: `write(digits)` gives both. So two values that differ
/// never look alike.
template <class Write>
[[nodiscard]] auto telling_apart(const Write& write)
{
    for (int digits = usual_digits; digits <= most_digits; ++digits)
        if (auto both = write(digits); both.first != both.second) return both;
    return write(usual_digits);
}

/// "1,536": a count of things, not negative, rounded.
[[nodiscard]] std::string count_text(double count);

/// One number, or "(1, 2, 3)".
[[nodiscard]] std::string row_text(std::span<const double> row, int digits = usual_digits);

/// The same; "nothing" for an absent cell.
[[nodiscard]] std::string cell_text(const TensorView& view, std::size_t cell, int digits = usual_digits);

}
