#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ranges>
#include <tuple>
#include <type_traits>
#include <umbral/record/ways_to_change.hpp>
#include <vector>

/// Small changes of an argument, by which it shows what an answer depends on: whoever uses it answers otherwise.
/// A name says what of the argument is moved: "moved" all of it, "moved .x" its x, "moved [2]" an element, "moved
/// length" and "moved direction" nothing else of a vector, "moved order" nothing else of a list, "moved corners" which
/// corner each triangle of a list begins with.
namespace umbral::detail {

/// By a sixteenth: more than rounding, and hardly out of the range that a unit allows. Nothing becomes 0.
template <class Number>
void move_number(Number& x)
{
    x = x == 0 ? Number(1) / 16 : x + x / 16;
}

/// Another vector of the same length.
template <class Vector>
void move_direction(Vector& v)
{
    Vector moved = v;
    for (glm::length_t i = 0; i < v.length(); ++i) moved[i] += v[(i + 1) % v.length()] / 8;
    const auto length = glm::length(moved);
    if (length > 0) v = moved * (glm::length(v) / length);
}

template <class Value>
struct MovesOf {
    static constexpr std::array<Change, 0> all{};
};

template <>
struct MovesOf<bool> {
    static constexpr std::array all{change<bool>("moved", [](bool& b) { b = !b; })};
};

template <class Number>
requires std::is_floating_point_v<Number>
struct MovesOf<Number> {
    static constexpr std::array all{change<Number>("moved", [](Number& x) { move_number(x); })};
};

template <class Number>
requires(std::is_integral_v<Number> && !std::is_same_v<Number, bool>) struct MovesOf<Number> {
    static constexpr std::array all{
        change<Number>("moved", [](Number& x) { x = x == std::numeric_limits<Number>::max() ? x : x + 1; })};
};

template <class Enum>
requires std::is_enum_v<Enum>
struct MovesOf<Enum> {
    static constexpr std::array all{change<Enum>("moved", [](Enum& e) {
        e = static_cast<Enum>((static_cast<int>(e) + 1) % std::max(1, reflect::enumerators<Enum>));
    })};
};

template <class Vector, int Component>
constexpr Change component_moved(std::string_view name)
{
    return change<Vector>(name, [](Vector& v) {
        if constexpr (std::is_floating_point_v<typename Vector::value_type>)
            move_number(v[Component]);
        else
            ++v[Component];
    });
}

template <class Vector>
requires(literal::detail::is_vector<Vector> &&
         !std::is_same_v<typename Vector::value_type, bool>) struct MovesOf<Vector> {
    static constexpr std::array first{component_moved<Vector, 0>("moved .x"), component_moved<Vector, 1>("moved .y")};
    static constexpr auto of_three = [] {
        if constexpr (Vector::length() < 3)
            return first;
        else
            return joined(first, std::array{component_moved<Vector, 2>("moved .z")});
    }();
    static constexpr auto of_four = [] {
        if constexpr (Vector::length() < 4)
            return of_three;
        else
            return joined(of_three, std::array{component_moved<Vector, 3>("moved .w")});
    }();
    static constexpr auto all = [] {
        if constexpr (!std::is_floating_point_v<typename Vector::value_type>)
            return of_four;
        else
            return joined(of_four, std::array{change<Vector>("moved length", [](Vector& v) { v += v / Vector(16); }),
                                              change<Vector>("moved direction", [](Vector& v) { move_direction(v); })});
    }();
};

/// "moved [2][1]" of column 2, row 1, as GLM writes entries: live as long as the program.
template <std::size_t Column, std::size_t Row>
inline constexpr std::array<char, 12> entry_move{'m', 'o',          'v', 'e', 'd',       ' ',
                                                 '[', '0' + Column, ']', '[', '0' + Row, ']'};

/// Each entry by itself, and a turn more of the whole: what is rigid remains so.
template <class Matrix>
requires literal::detail::is_matrix<Matrix>
struct MovesOf<Matrix> {
    static constexpr std::size_t rows = Matrix::col_type::length();
    static constexpr std::array turn{change<Matrix>("moved", [](Matrix& m) {
        const auto x = m[0];
        constexpr typename Matrix::value_type sine = 0.28F;
        constexpr typename Matrix::value_type cosine = 0.96F;
        m[0] = m[0] * cosine + m[1] * sine;
        m[1] = m[1] * cosine - x * sine;
    })};
    static constexpr auto all = []<std::size_t... Index>(std::index_sequence<Index...>)
    {
        return joined(turn,
                      std::array{change<Matrix>({entry_move<Index / rows, Index % rows>.data(), 12},
                                                [](Matrix& m) { move_number(m[Index / rows][Index % rows]); })...});
    }
    (std::make_index_sequence<Matrix::length() * rows>{});
};

template <class List, std::size_t Index>
constexpr Change element_moved(std::string_view name)
{
    return change<List>(name, [](List& list) {
        if (Index >= list.size()) return;
        for (glm::length_t i = 0; i < list[Index].length(); ++i) move_number(list[Index][i]);
    });
}

template <class Element>
inline constexpr bool is_float_vector = [] {
    if constexpr (literal::detail::is_vector<Element>)
        return std::is_floating_point_v<typename Element::value_type>;
    else
        return false;
}();

/// Are there whole numbers in a value of this type, which may say which element of a list is meant?
template <class Value>
constexpr bool holds_whole_numbers()
{
    if constexpr (literal::detail::is_vector<Value>)
        return !is_float_vector<Value>;
    else if constexpr (std::is_integral_v<Value>)
        return !std::is_same_v<Value, bool>;
    else if constexpr (literal::detail::List<Value>)
        return holds_whole_numbers<std::ranges::range_value_t<Value>>();
    else if constexpr (reflect::is_plain_struct<Value>)
        return []<class... Fields>(std::type_identity<std::tuple<Fields&...>>) {
            return (holds_whole_numbers<Fields>() || ...);
        }(std::type_identity<decltype(reflect::fields(std::declval<Value&>()))>{});
    else
        return false;
}

/// The elements in reverse order: of lights, say, it is no matter which comes first.
template <class List>
inline constexpr std::array order_moved{
    change<List>("moved order", [](List& list) { std::reverse(list.begin(), list.end()); })};

/// Of triangles neither their order nor which of its corners a triangle begins with should matter, but to what is
/// numbered so.
template <>
struct MovesOf<std::vector<glm::uvec3>> {
    using List = std::vector<glm::uvec3>;
    static constexpr auto all = joined(order_moved<List>, std::array{change<List>("moved corners", [](List& list) {
                                           for (glm::uvec3& corners : list) corners = {corners.y, corners.z, corners.x};
                                       })});
};

/// Where elements are meant by their numbers, another order is another thing, on which code may not come to an end.
template <class Element>
requires(!is_float_vector<Element> && !holds_whole_numbers<Element>()) struct MovesOf<std::vector<Element>> {
    static constexpr std::array all = order_moved<std::vector<Element>>;
};

/// Of places and directions each of the first by itself, too.
template <class Element>
requires(is_float_vector<Element>) struct MovesOf<std::vector<Element>> {
    using List = std::vector<Element>;
    static constexpr std::array elements{
        element_moved<List, 0>("moved [0]"), element_moved<List, 1>("moved [1]"), element_moved<List, 2>("moved [2]"),
        element_moved<List, 3>("moved [3]"), element_moved<List, 4>("moved [4]"), element_moved<List, 5>("moved [5]"),
    };
    static constexpr auto all = joined(order_moved<List>, elements);
};

}
