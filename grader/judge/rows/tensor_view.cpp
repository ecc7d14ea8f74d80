#include "judge/rows/tensor_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <umbral/record/not_finite.hpp>

namespace umbral::grader {
namespace {

template <class Value>
void read(const Tensor& tensor, std::vector<double>& values)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        Value value;
        std::memcpy(&value, tensor.bytes.data() + i * sizeof(Value), sizeof(Value));
        values[i] = static_cast<double>(value);
    }
}

template <class Value>
void write(Tensor& tensor, std::span<const double> values)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        Value value;
        if constexpr (std::numeric_limits<Value>::is_integer) {
            const double low = static_cast<double>(std::numeric_limits<Value>::min());
            const double high = static_cast<double>(std::numeric_limits<Value>::max());
            value = static_cast<Value>(std::isnan(values[i]) ? 0.0 : std::clamp(std::round(values[i]), low, high));
        } else {
            value = static_cast<Value>(values[i]);
        }
        std::memcpy(tensor.bytes.data() + i * sizeof(Value), &value, sizeof(Value));
    }
}

const char* element_text(Element element)
{
    switch (element) {
        case Element::float32: return "float";
        case Element::float64: return "double";
        case Element::int32: return "int";
        case Element::uint32: return "unsigned";
        case Element::uint8: return "byte";
    }
    return "unknown";
}

std::string shape_text(const Tensor& tensor)
{
    if (tensor.columns == 1)
        return fmt::format("{} row{} of {} {}", tensor.rows, tensor.rows == 1 ? "" : "s", tensor.components,
                           element_text(tensor.element));
    return fmt::format("{} x {} cells (width x height) of {} {}", tensor.columns, tensor.rows, tensor.components,
                       element_text(tensor.element));
}

}

std::vector<double> to_doubles(const Tensor& tensor)
{
    std::vector<double> values(tensor.count());
    switch (tensor.element) {
        case Element::float32: read<float>(tensor, values); break;
        case Element::float64: read<double>(tensor, values); break;
        case Element::int32: read<std::int32_t>(tensor, values); break;
        case Element::uint32: read<std::uint32_t>(tensor, values); break;
        case Element::uint8: read<std::uint8_t>(tensor, values); break;
    }
    return values;
}

std::vector<double> numbers_or_nan(const Tensor& tensor)
{
    std::vector<double> values = to_doubles(tensor);
    for (std::size_t i = 0; i < values.size() && !tensor.present.empty(); ++i)
        if (tensor.present.at(i / tensor.components) == 0) values[i] = std::nan("");
    return values;
}

Tensor with_values(const Tensor& like, std::span<const double> values)
{
    Tensor tensor = like;
    switch (like.element) {
        case Element::float32: write<float>(tensor, values); break;
        case Element::float64: write<double>(tensor, values); break;
        case Element::int32: write<std::int32_t>(tensor, values); break;
        case Element::uint32: write<std::uint32_t>(tensor, values); break;
        case Element::uint8: write<std::uint8_t>(tensor, values); break;
    }
    return tensor;
}

Tensor made_finite(const Tensor& tensor)
{
    std::vector<double> values = to_doubles(tensor);
    for (double& value : values)
        if (!std::isfinite(value)) value = 3e38;
    return with_values(tensor, values);
}

TensorView::TensorView(const Tensor& tensor)
    : cells_(tensor.cells()), components_(tensor.components), values_(to_doubles(tensor)), present_(tensor.present)
{
}

bool well_formed(const Tensor& tensor)
{
    const std::size_t size = size_of(tensor.element);
    return size > 0 && tensor.components > 0 && tensor.bytes.size() % size == 0 &&
           tensor.bytes.size() / size == tensor.count() &&
           (tensor.present.empty() || tensor.present.size() == tensor.cells());
}

std::optional<std::string> shape_error(const Tensor& student, const Tensor& expected)
{
    if (!well_formed(student)) return "What was recorded is damaged: its size does not fit its shape.";
    if (student.element == expected.element && student.rows == expected.rows && student.columns == expected.columns &&
        student.components == expected.components)
        return std::nullopt;
    return fmt::format("Yours has {}; expected {}.", shape_text(student), shape_text(expected));
}

std::optional<std::string> row_shape_error(const Tensor& student, const Tensor& expected)
{
    if (!well_formed(student)) return "What was recorded is damaged: its size does not fit its shape.";
    if (student.cells() == 0 || (student.element == expected.element && student.columns == expected.columns &&
                                 student.components == expected.components))
        return std::nullopt;
    return fmt::format("Yours has rows of {} {}; expected rows of {} {}.",
                       student.columns * std::size_t{student.components}, element_text(student.element),
                       expected.components, element_text(expected.element));
}

std::string_view text_of(const Tensor* tensor)
{
    if (tensor == nullptr || tensor->element != Element::uint8 || tensor->bytes.empty()) return {};
    return {reinterpret_cast<const char*>(tensor->bytes.data()), tensor->bytes.size()};
}

bool all_finite(std::span<const double> values)
{
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

bool equal_or_both_nan(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

std::string number_text(double recorded, int digits)
{
    const double value = recorded_number(recorded);
    // What is no number has no sign, and only where nothing else tells two values apart it matters that 0 has one.
    if (std::isnan(value)) return "nan";
    if (value == 0 && digits < most_digits) return "0";
    // Ids, indices, counts and codes are told digit by digit, as far as 32 bits count.
    constexpr double last_whole = 4294967296;
    // Beyond, counts of bytes, say: those that only a double holds.
    constexpr double last_of_doubles = 1099511627776;
    const bool is_a_count =
        std::abs(value) <= last_whole || (std::abs(value) <= last_of_doubles && static_cast<float>(value) != value);
    if (value == std::trunc(value) && is_a_count) return fmt::format("{:.0f}", value);
    // Nor do its neighbours change to powers of ten.
    const int whole_digits =
        std::abs(value) < last_whole ? static_cast<int>(fmt::formatted_size("{:.0f}", std::abs(value))) : 0;
    return fmt::format("{:.{}g}", value, std::max(digits, whole_digits));
}

std::string count_text(double count)
{
    std::string digits = fmt::format("{:.0f}", count);
    for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
    return digits;
}

std::string row_text(std::span<const double> row, int digits)
{
    if (row.size() == 1) return number_text(row[0], digits);
    std::string text = "(";
    for (const double value : row) text += (text.size() > 1 ? ", " : "") + number_text(value, digits);
    return text + ")";
}

std::string cell_text(const TensorView& view, std::size_t cell, int digits)
{
    return view.present(cell) ? row_text(view.cell(cell), digits) : "nothing";
}

}
