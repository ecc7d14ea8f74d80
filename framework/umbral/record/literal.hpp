#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <umbral/core/grid.hpp>
#include <umbral/record/reflect.hpp>
#include <vector>

/// Values as C++ code that gives exactly these values back: the digits are the fewest that do.
namespace umbral::literal {

/// How long lists are written: in full, or their first elements and how many there are.
struct Style {
    std::size_t most_elements = 12;
    std::size_t most_letters = 60;  ///< of texts in one line
    std::size_t most_lines = 40;    ///< of texts in several: shaders, files
};
inline constexpr std::size_t unlimited = static_cast<std::size_t>(-1);
inline constexpr Style in_full{unlimited, unlimited, unlimited};

/// "8", "0.1F", "-0.0F", "INFINITY"; of a double "0.1".
[[nodiscard]] std::string of(float value);
[[nodiscard]] std::string of(double value);
/// "8", "4294967295U".
[[nodiscard]] std::string of_integer(std::int64_t value);
[[nodiscard]] std::string of_integer(std::uint64_t value);
/// In quotes, with escapes; cut behind style.most_letters. What people write in several lines, a shader say, stands as
/// it is, R"(…)", cut behind style.most_lines.
[[nodiscard]] std::string of_text(std::string_view text, const Style& style);
/// "glm::mat4(1)", "glm::translate(glm::mat4(1), glm::vec3{1, 2, 3})", "glm::scale(…)": a square matrix as the short
/// call that gives exactly these numbers, column by column; empty if there is none.
[[nodiscard]] std::string of_simple_matrix(std::span<const float> numbers, std::size_t side, std::string_view type);
[[nodiscard]] std::string of_simple_matrix(std::span<const double> numbers, std::size_t side, std::string_view type);
/// "Ray" of "umbral::raytracing::Ray", "glm::vec3" of GLM's long name, "std::vector<glm::vec3>".
[[nodiscard]] std::string short_type(std::string_view type);
/// "ray" of "umbral::raytracing::Ray": what a value of this type is called that cannot be written as code.
[[nodiscard]] std::string object_name(std::string_view type);

/// One value after the other as code. A typed value can stand where its type is not known: "Ray{{8, -3, 4}, …}"; one
/// that is not, within braces: "{8, -3, 4}".
template <class Value>
[[nodiscard]] std::string of_value(const Value& value, bool typed, const Style& style);

namespace detail {

template <class Type>
inline constexpr bool is_optional = false;
template <class Type>
inline constexpr bool is_optional<std::optional<Type>> = true;

template <class Type>
inline constexpr bool is_vector = false;
template <glm::length_t Size, class Number, glm::qualifier Precision>
inline constexpr bool is_vector<glm::vec<Size, Number, Precision>> = true;

template <class Type>
inline constexpr bool is_matrix = false;
template <glm::length_t Columns, glm::length_t Rows, class Number, glm::qualifier Precision>
inline constexpr bool is_matrix<glm::mat<Columns, Rows, Number, Precision>> = true;

/// An array within a struct: braces of its own stand round elements that have some.
template <class Type>
inline constexpr bool has_more_braces = false;
template <class Element, std::size_t Size>
inline constexpr bool has_more_braces<std::array<Element, Size>> = !std::is_scalar_v<Element>;

template <class Type>
inline constexpr bool is_grid = false;
template <class Cell>
inline constexpr bool is_grid<Grid<Cell>> = true;

/// Lists whose elements lie one after the other: vectors, spans, arrays.
template <class Type>
concept List = std::ranges::contiguous_range<Type> && std::ranges::sized_range<Type>;

/// Pointers of all kinds.
template <class Type>
concept MayBeNull = std::is_pointer_v<Type> || requires(const Type& value)
{
    typename Type::element_type;
    {
        value == nullptr
        } -> std::convertible_to<bool>;
};

/// Texts of all kinds.
template <class Type>
concept Text = std::is_convertible_v<const Type&, std::string_view>;

/// The enumerator's name, "Culling::back"; empty for a value without one.
template <class Enum, int Value = 0>
std::string enumerator(Enum value)
{
    if constexpr (Value == reflect::most_enumerators) {
        return "";
    } else {
        if (static_cast<int>(value) != Value) return enumerator<Enum, Value + 1>(value);
        constexpr std::string_view name = reflect::value_name<static_cast<Enum>(Value)>();
        if (name.find(')') != std::string_view::npos) return "";
        return short_type(reflect::type_name<Enum>()) + "::" + std::string(reflect::last_name(name));
    }
}

/// The type that a list is written as: what a span looks at is written as a vector.
template <class Type>
std::string list_type()
{
    using Element = std::remove_const_t<std::ranges::range_value_t<Type>>;
    const std::string whole = short_type(reflect::type_name<Type>());
    return whole.starts_with("std::span") ? "std::vector<" + short_type(reflect::type_name<Element>()) + ">" : whole;
}

/// "{a, b, c}"; "{a, b, … 798 more}".
template <class Elements>
std::string in_braces(const Elements& elements, const Style& style)
{
    const std::size_t count = std::ranges::size(elements);
    const std::size_t shown = count <= style.most_elements ? count : std::min<std::size_t>(3, style.most_elements);
    std::string text = "{";
    std::size_t i = 0;
    for (const auto& element : elements) {
        if (i == shown) break;
        if (i++ > 0) text += ", ";
        text += of_value(element, false, style);
    }
    if (shown < count) text += ", … " + std::to_string(count - shown) + " more";
    return text + "}";
}

template <class Struct>
std::string struct_in_braces(const Struct& value, const Style& style)
{
    std::string text = "{";
    std::size_t fields = 0;
    reflect::for_each_field(value, [&](std::string_view, const auto& field) {
        if (fields++ > 0) text += ", ";
        text += of_value(field, false, style);
    });
    return text + "}";
}

/// As a short call if there is one that says as much; else in braces.
template <class Matrix>
std::string of_matrix(const Matrix& matrix, bool typed, const Style& style)
{
    using Number = typename Matrix::value_type;
    constexpr auto columns = static_cast<std::size_t>(Matrix::length());
    const std::string type = short_type(reflect::type_name<Matrix>());
    if constexpr (Matrix::length() == Matrix::col_type::length() && std::is_floating_point_v<Number>) {
        const std::span<const Number> numbers(&matrix[0][0], columns * columns);
        if (std::string call = of_simple_matrix(numbers, columns, type); !call.empty()) return call;
    }
    std::string text = typed ? type + "{" : "{";
    for (glm::length_t column = 0; column < Matrix::length(); ++column)
        text += (column > 0 ? ", " : "") + of_value(matrix[column], false, style);
    return text + "}";
}

}

template <class Value>
std::string of_value(const Value& value, bool typed, const Style& style)
{
    const auto type = [&] { return typed ? short_type(reflect::type_name<Value>()) : std::string(); };
    if constexpr (detail::MayBeNull<Value>)
        if (value == nullptr) return "nullptr";
    if constexpr (std::is_same_v<Value, bool>) {
        return value ? "true" : "false";
    } else if constexpr (std::is_same_v<Value, std::byte>) {
        return "std::byte{" + of_integer(std::to_integer<std::uint64_t>(value)) + "}";
    } else if constexpr (std::is_enum_v<Value>) {
        const std::string name = detail::enumerator(value);
        return name.empty()
                   ? short_type(reflect::type_name<Value>()) + "{" + of_integer(static_cast<std::int64_t>(value)) + "}"
                   : name;
    } else if constexpr (std::is_floating_point_v<Value>) {
        return of(value);
    } else if constexpr (std::is_integral_v<Value>) {
        if constexpr (std::is_signed_v<Value>)
            return of_integer(std::int64_t{value});
        else
            return of_integer(std::uint64_t{value});
    } else if constexpr (detail::is_vector<Value>) {
        return type() + detail::in_braces(std::span(&value[0], static_cast<std::size_t>(Value::length())), style);
    } else if constexpr (detail::is_matrix<Value>) {
        return detail::of_matrix(value, typed, style);
    } else if constexpr (detail::is_optional<Value>) {
        return value ? of_value(*value, typed, style) : "std::nullopt";
    } else if constexpr (detail::Text<Value>) {
        return of_text(value, style);
    } else if constexpr (detail::is_grid<Value>) {
        return (typed ? short_type(reflect::type_name<Value>()) : std::string()) + "{" + std::to_string(value.width) +
               ", " + std::to_string(value.height) + ", " + detail::in_braces(value.cells, style) + "}";
    } else if constexpr (detail::List<Value>) {
        const std::string elements = detail::in_braces(value, style);
        return (typed ? detail::list_type<Value>() : std::string()) +
               (detail::has_more_braces<Value> ? "{" + elements + "}" : elements);
    } else if constexpr (reflect::is_plain_struct<Value>) {
        return type() + detail::struct_in_braces(value, style);
    } else {
        return object_name(reflect::type_name<Value>());
    }
}

}
