#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/evidence/evidence.hpp"
#include "judge/explain/explain.hpp"
#include "judge/rows/columns.hpp"
#include "judge/rows/tensor_view.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

/// The pixel of a primitive. Ordered by primitive, then as a picture is read.
struct Place {
    std::int32_t primitive = 0;
    std::int32_t y = 0;
    std::int32_t x = 0;
    friend auto operator<=>(const Place&, const Place&) = default;
};

struct Fragment {
    Place place;
    std::uint32_t row = 0;
    friend auto operator<=>(const Fragment&, const Fragment&) = default;
};
using Fragments = std::span<const Fragment>;

/// A recorded table of rows [primitive, x, y, attributes...], sorted by place. Needs at least three components.
class FragmentTable {
public:
    explicit FragmentTable(const Tensor& tensor);

    [[nodiscard]] Fragments sorted() const noexcept { return sorted_; }
    /// Those of one primitive.
    [[nodiscard]] Fragments of(std::int32_t primitive) const;
    /// How many rows name no pixel: a primitive or coordinate that is no whole number.
    [[nodiscard]] std::size_t unplaced() const noexcept { return view_.cells() - sorted_.size(); }
    [[nodiscard]] std::span<const double> attributes(const Fragment& fragment) const
    {
        return view_.cell(fragment.row).subspan(3);
    }
    [[nodiscard]] const TensorView& view() const noexcept { return view_; }

private:
    TensorView view_;
    std::vector<Fragment> sorted_;
};

/// Visits every place that either of two sorted lists has, in order: visit(place, fragments of a, fragments of b).
template <class Visit>
void for_each_place(Fragments a, Fragments b, Visit&& visit)
{
    const auto take = [](Fragments& list, const Place& place) {
        std::size_t size = 0;
        while (size < list.size() && list[size].place == place) ++size;
        const Fragments taken = list.first(size);
        list = list.subspan(size);
        return taken;
    };
    while (!a.empty() || !b.empty()) {
        const Place place =
            b.empty() || (!a.empty() && a.front().place < b.front().place) ? a.front().place : b.front().place;
        const Fragments of_a = take(a, place);
        visit(place, of_a, take(b, place));
    }
}

/// What became of one place, or of all.
struct FragmentTally {
    std::size_t matched = 0;
    std::size_t wrong_value = 0;
    std::size_t missing = 0;
    std::size_t extra = 0;
    std::size_t duplicated = 0;

    [[nodiscard]] bool all_right() const noexcept { return wrong_value + missing + extra + duplicated == 0; }
    FragmentTally& operator+=(const FragmentTally& other);
};

/// Compares the fragments of one place, attributes by the check's tolerance (none: equal).
class FragmentMatcher {
public:
    FragmentMatcher(const Check& check, const FragmentTable& yours, const FragmentTable& expected)
        : check_(check), yours_(yours), expected_(expected)
    {
    }

    /// One expected fragment may be matched by any of several, which are duplicates then; several are matched in the
    /// order of their rows.
    [[nodiscard]] FragmentTally at_place(Fragments yours, Fragments expected) const;
    /// The largest deviation of the attributes in the unit of the tolerance; infinite if one is not finite.
    [[nodiscard]] double error(const Fragment& yours, const Fragment& expected) const
    {
        return compare(yours, expected).error;
    }

private:
    struct Comparison {
        bool right = true;
        double error = 0;
    };
    [[nodiscard]] Comparison compare(const Fragment& yours, const Fragment& expected) const;

    const Check& check_;
    const FragmentTable& yours_;
    const FragmentTable& expected_;
};

/// One step between neighbouring pixels, y downwards; {0, 0} is none.
struct PixelStep {
    int dx = 0;
    int dy = 0;
    friend auto operator<=>(const PixelStep&, const PixelStep&) = default;
};

/// A primitive that lies one pixel aside: how far, and how many fragments are missing (and extra) for that.
struct MovedPrimitive {
    std::int32_t primitive = 0;
    PixelStep step;
    std::size_t fragments = 0;
};

/// The primitives of which one common step of a pixel explains at least nine tenths of what is missing and extra.
[[nodiscard]] std::vector<MovedPrimitive> moved_primitives(const FragmentTable& yours, const FragmentTable& expected);

/// What rows are called. A driver says the word for a primitive ("segment"; without one, "triangle"), or, where the
/// rows are no fragments, what x and y count in it as well: "polygon: corner, -" (- counts nothing).
class FragmentWords {
public:
    explicit FragmentWords(std::string_view text);

    [[nodiscard]] const std::string& primitive() const { return primitive_; }
    /// "fragment", or the last of what is counted: "corner".
    [[nodiscard]] const std::string& row() const { return row_; }
    [[nodiscard]] bool are_pixels() const { return counted_.empty(); }
    /// "pixel (3, 4) of triangle 0", "corner 3 of polygon 0", "window 12, corner 3 of task 0".
    [[nodiscard]] std::string where(const Place& place) const;

private:
    std::string primitive_ = "triangle";
    std::string row_ = "fragment";
    std::vector<ColumnGroup> counted_;  // of x and y
};

/// "all fragments of triangle 3 lie one pixel to the right".
[[nodiscard]] std::string moved_sentence(const std::vector<MovedPrimitive>& moved, const FragmentWords& words);

/// The pixels round `centre` of its primitive, at most 15 x 15, one character each, with a line that says where and
/// what they mean.
[[nodiscard]] std::string fragment_sketch(const FragmentMatcher& matcher, const FragmentTable& yours,
                                          const FragmentTable& expected, const Place& centre);

/// Wrong as a mistake is: the same fragments at 95 % of the places where either deviates.
[[nodiscard]] Resemblance same_fragments(const FailingCheck& failing, const Tensor& mistake);

/// The share of the places in either table that are in both; nothing if the reference has fewer than 32.
[[nodiscard]] std::optional<double> common_places(const Tensor& student, const Tensor& reference);

/// What a page shows of fragments; nothing if they are right.
[[nodiscard]] Evidence fragments_evidence(const Check& check, const Observation& observation, bool right);

/// Every pixel of each primitive's bounding box once, with the attributes of `row` (its first three numbers are left
/// out): what one draws who has forgotten to look inside. Nothing where that is more than 16 times what was expected:
/// it would earn a sixteenth at most.
[[nodiscard]] std::optional<Tensor> bounding_boxes(const Tensor& expected, std::span<const double> row);

}
