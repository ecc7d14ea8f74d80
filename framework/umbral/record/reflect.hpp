#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

/// Names of types, functions and fields, and the fields of plain structs, as the compiler knows them: so that a
/// question can be written as code without its unit's author doing anything for it.
///
/// C++20 has no reflection; what is read here is how GCC 12 and later print the arguments of a template.
namespace umbral::reflect {

/// The text after `key` in what the compiler calls an instance of a template, up to its end.
[[nodiscard]] constexpr std::string_view argument_text(std::string_view function, std::string_view key)
{
    const std::size_t first = function.find(key) + key.size();
    std::size_t last = first;
    int depth = 0;
    for (; last < function.size(); ++last) {
        const char letter = function[last];
        if (depth == 0 && (letter == ';' || letter == ']')) break;
        if (letter == '<' || letter == '(' || letter == '{') ++depth;
        if (letter == '>' || letter == ')' || letter == '}') --depth;
    }
    return function.substr(first, last - first);
}

/// "intersect" of "umbral::raytracing::intersect".
[[nodiscard]] constexpr std::string_view last_name(std::string_view qualified)
{
    const std::size_t place = qualified.rfind("::");
    return place == std::string_view::npos ? qualified : qualified.substr(place + 2);
}

/// The type's full name: "umbral::raytracing::Ray".
template <class Type>
[[nodiscard]] constexpr std::string_view type_name()
{
    return argument_text(__PRETTY_FUNCTION__, "Type = ");
}

/// The full name of a function, a member function or an enumerator, without its parameters:
/// "umbral::raytracing::intersect".
template <auto Value>
[[nodiscard]] constexpr std::string_view value_name()
{
    std::string_view name = argument_text(__PRETTY_FUNCTION__, "Value = ");
    while (!name.empty() && (name.front() == '&' || name.front() == '(')) name.remove_prefix(1);
    return name.substr(0, name.find_first_of("( "));
}

inline constexpr int most_enumerators = 16;

/// How many values from 0 on, without a gap, have a name in an enumeration; most_enumerators of more.
template <class Enum, int Value = 0>
inline constexpr int enumerators = [] {
    if constexpr (Value == most_enumerators)
        return Value;
    else if constexpr (value_name<static_cast<Enum>(Value)>().find(')') != std::string_view::npos)
        return Value;
    else
        return enumerators<Enum, Value + 1>;
}();

/// Is it a struct of public members without constructors of its own?
template <class Type>
inline constexpr bool is_plain_struct =
    std::is_class_v<Type>&& std::is_aggregate_v<Type> && !std::is_polymorphic_v<Type>;

inline constexpr std::size_t most_fields = 12;

namespace detail {

struct Anything {
    template <class Type>
    // NOLINTNEXTLINE(google-explicit-constructor, hicpp-explicit-conversions): it stands for a value of any type.
    operator Type() const;
};

template <class Type, std::size_t... Index>
constexpr bool takes(std::index_sequence<Index...> /*unused*/)
{
    return requires { Type{((void)Index, Anything{})...}; };
}

template <class Type, std::size_t Count = most_fields>
constexpr std::size_t field_count()
{
    if constexpr (Count == 0 || takes<Type>(std::make_index_sequence<Count>{}))
        return Count;
    else
        return field_count<Type, Count - 1>();
}

template <class Type>
struct Holder {
    Type value;
};

/// Never defined and never read: only the names of its members are looked at.
template <class Type>
extern Holder<Type> held;

template <auto* Pointer>
constexpr std::string_view member_name()
{
    std::string_view text = argument_text(__PRETTY_FUNCTION__, "Pointer = ");
    while (text.ends_with(')')) text.remove_suffix(1);
    // Elements of an array are called as they are written, not by the library's name of their list.
    if (text.ends_with(']')) return text.substr(text.rfind('['));
    return last_name(text);
}

}

/// How many fields a plain struct has; it must not have more than most_fields, nor C arrays.
template <class Type>
inline constexpr std::size_t field_count = detail::field_count<std::remove_const_t<Type>>();

/// References to the fields of a plain struct, in their order.
template <class Struct>
[[nodiscard]] constexpr auto fields(Struct& s)
{
    constexpr std::size_t count = field_count<Struct>;
    static_assert(count <= most_fields);
    // NOLINTBEGIN(readability-identifier-length)
    if constexpr (count == 0) {
        return std::tie();
    } else if constexpr (count == 1) {
        auto& [a] = s;
        return std::tie(a);
    } else if constexpr (count == 2) {
        auto& [a, b] = s;
        return std::tie(a, b);
    } else if constexpr (count == 3) {
        auto& [a, b, c] = s;
        return std::tie(a, b, c);
    } else if constexpr (count == 4) {
        auto& [a, b, c, d] = s;
        return std::tie(a, b, c, d);
    } else if constexpr (count == 5) {
        auto& [a, b, c, d, e] = s;
        return std::tie(a, b, c, d, e);
    } else if constexpr (count == 6) {
        auto& [a, b, c, d, e, f] = s;
        return std::tie(a, b, c, d, e, f);
    } else if constexpr (count == 7) {
        auto& [a, b, c, d, e, f, g] = s;
        return std::tie(a, b, c, d, e, f, g);
    } else if constexpr (count == 8) {
        auto& [a, b, c, d, e, f, g, h] = s;
        return std::tie(a, b, c, d, e, f, g, h);
    } else if constexpr (count == 9) {
        auto& [a, b, c, d, e, f, g, h, i] = s;
        return std::tie(a, b, c, d, e, f, g, h, i);
    } else if constexpr (count == 10) {
        auto& [a, b, c, d, e, f, g, h, i, j] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j);
    } else if constexpr (count == 11) {
        auto& [a, b, c, d, e, f, g, h, i, j, k] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j, k);
    } else {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l] = s;
        return std::tie(a, b, c, d, e, f, g, h, i, j, k, l);
    }
    // NOLINTEND(readability-identifier-length)
}

/// The name of a plain struct's field: "direction"; of an array's element: "[2]".
template <class Struct, std::size_t Index>
[[nodiscard]] constexpr std::string_view field_name()
{
    return detail::member_name<&std::get<Index>(fields(detail::held<Struct>.value))>();
}

/// Calls `use(name, field)` for each field.
template <class Struct, class Use>
void for_each_field(Struct& value, Use&& use)
{
    [&]<std::size_t... Index>(std::index_sequence<Index...>)
    {
        const auto all = fields(value);
        (use(field_name<std::remove_const_t<Struct>, Index>(), std::get<Index>(all)), ...);
    }
    (std::make_index_sequence<field_count<Struct>>{});
}

}
