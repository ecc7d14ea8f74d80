#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <umbral/record/literal.hpp>
#include <utility>
#include <vector>

namespace umbral {

/// A way to misunderstand an argument: "negated", "in degrees". `make` changes the value in place.
struct Change {
    std::string_view name{};
    void (*make)(void* value) = nullptr;
};

namespace detail {

template <class Value, class Function>
constexpr Change change(std::string_view name, Function /*unused*/)
{
    return {name, [](void* value) { Function{}(*static_cast<Value*>(value)); }};
}

template <std::size_t First, std::size_t Second>
constexpr std::array<Change, First + Second> joined(const std::array<Change, First>& one,
                                                    const std::array<Change, Second>& other)
{
    std::array<Change, First + Second> all{};
    std::copy(one.begin(), one.end(), all.begin());
    std::copy(other.begin(), other.end(), all.begin() + First);
    return all;
}

template <class Value>
struct ChangesOf {
    static constexpr std::array<Change, 0> all{};
};

template <>
struct ChangesOf<bool> {
    static constexpr std::array all{
        change<bool>("inverted", [](bool& b) { b = !b; }),
        change<bool>("taken as true", [](bool& b) { b = true; }),
        change<bool>("taken as false", [](bool& b) { b = false; }),
    };
};

template <class Number>
requires std::is_floating_point_v<Number>
struct ChangesOf<Number> {
    static constexpr Number degree = std::numbers::pi_v<Number> / 180;
    static constexpr std::array all{
        change<Number>("negated", [](Number& x) { x = -x; }),
        change<Number>("doubled", [](Number& x) { x *= 2; }),
        change<Number>("halved", [](Number& x) { x /= 2; }),
        change<Number>("turned from degrees into radians", [](Number& x) { x *= degree; }),
        change<Number>("turned from radians into degrees", [](Number& x) { x /= degree; }),
        change<Number>("taken as 0", [](Number& x) { x = 0; }),
        change<Number>("taken as 1", [](Number& x) { x = 1; }),
        change<Number>("without its sign", [](Number& x) { x = x < 0 ? -x : x; }),
        change<Number>("taken as infinity", [](Number& x) { x = std::numeric_limits<Number>::infinity(); }),
        change<Number>("squared", [](Number& x) { x *= x; }),
        change<Number>("subtracted from 1", [](Number& x) { x = 1 - x; }),
        change<Number>("replaced by its reciprocal", [](Number& x) { x = 1 / x; }),
        change<Number>("limited to [0, 1]", [](Number& x) { x = glm::clamp(x, Number(0), Number(1)); }),
        change<Number>("rounded towards 0", [](Number& x) { x = std::trunc(x); }),
    };
};

template <class Number>
requires(std::is_integral_v<Number> && !std::is_same_v<Number, bool>) struct ChangesOf<Number> {
    static constexpr std::array all{
        change<Number>("one larger", [](Number& x) { ++x; }),
        change<Number>("one smaller", [](Number& x) { x = x > 0 ? x - 1 : x; }),
        change<Number>("taken as 0", [](Number& x) { x = 0; }),
        change<Number>("taken as 1", [](Number& x) { x = 1; }),
        change<Number>("doubled", [](Number& x) { x = static_cast<Number>(x * 2); }),
        change<Number>("halved", [](Number& x) { x = static_cast<Number>(x / 2); }),
    };
};

template <class Enum, int Value>
inline constexpr std::string_view enumerator = reflect::last_name(reflect::value_name<static_cast<Enum>(Value)>());

/// These texts behind each other: they live as long as the program.
template <const std::string_view&... Texts>
struct Joined {
    static constexpr auto letters = [] {
        std::array<char, (Texts.size() + ...)> all{};
        auto at = all.begin();
        ((at = std::copy(Texts.begin(), Texts.end(), at)), ...);
        return all;
    }();
    static constexpr std::string_view text{letters.data(), letters.size()};
};

inline constexpr std::string_view taken_as = "taken as ";
inline constexpr std::string_view exchanged_begin = "with ";
inline constexpr std::string_view exchanged_and = " and ";
inline constexpr std::string_view exchanged_end = " exchanged";

/// So many enumerators are asked in place of others; of longer lists the first.
inline constexpr int most_asked_enumerators = 6;

template <class Enum>
requires std::is_enum_v<Enum>
struct ChangesOf<Enum> {
    static constexpr int count = std::min(reflect::enumerators<Enum>, most_asked_enumerators);
    static constexpr auto taken = []<int... Value>(std::integer_sequence<int, Value...>)
    {
        return std::array<Change, sizeof...(Value)>{change<Enum>(Joined<taken_as, enumerator<Enum, Value>>::text,
                                                                 [](Enum& e) { e = static_cast<Enum>(Value); })...};
    }
    (std::make_integer_sequence<int, count>{});
    /// Each with the one that is declared behind it.
    static constexpr auto exchanged = []<int... Value>(std::integer_sequence<int, Value...>)
    {
        return std::array<Change, sizeof...(Value)>{
            change<Enum>(Joined<exchanged_begin, enumerator<Enum, Value>, exchanged_and, enumerator<Enum, Value + 1>,
                                exchanged_end>::text,
                         [](Enum& e) {
                             const auto number = static_cast<int>(e);
                             if (number == Value || number == Value + 1) e = static_cast<Enum>(2 * Value + 1 - number);
                         })...};
    }
    (std::make_integer_sequence<int, std::max(count - 1, 0)>{});
    static constexpr auto all = joined(taken, exchanged);
};

/// Also of vectors whose squares are no floats, as a unit's own function may be asked to.
template <class Vector>
void normalise(Vector& v)
{
    auto largest = std::abs(v[0]);
    for (glm::length_t i = 1; i < v.length(); ++i) largest = std::max(largest, std::abs(v[i]));
    if (!(largest > 0) || !std::isfinite(largest)) return;
    v /= largest;
    v /= glm::length(v);
}

/// One component in place of another: what is copied from the line before, and not changed all through.
template <class Vector, int To, int From>
constexpr Change copied(std::string_view name)
{
    return change<Vector>(name, [](Vector& v) { v[To] = v[From]; });
}

template <class Vector>
requires literal::detail::is_vector<Vector>
struct ChangesOf<Vector> {
    static constexpr std::array first{
        change<Vector>("taken as 0", [](Vector& v) { v = Vector(0); }),
        change<Vector>("with x and y exchanged", [](Vector& v) { std::swap(v.x, v.y); }),
        copied<Vector, 1, 0>("with y taken as x"),
        copied<Vector, 0, 1>("with x taken as y"),
    };
    static constexpr auto of_numbers = [] {
        if constexpr (!std::is_floating_point_v<typename Vector::value_type>)
            return first;
        else
            return joined(
                first,
                std::array{
                    change<Vector>("negated", [](Vector& v) { v = -v; }),
                    change<Vector>("taken as 1", [](Vector& v) { v = Vector(1); }),
                    change<Vector>("normalised", [](Vector& v) { normalise(v); }),
                    change<Vector>("doubled", [](Vector& v) { v *= 2; }),
                    change<Vector>("halved", [](Vector& v) { v /= 2; }),
                    change<Vector>("without the signs of its components", [](Vector& v) { v = glm::abs(v); }),
                    change<Vector>("with x negated", [](Vector& v) { v.x = -v.x; }),
                    change<Vector>("with y negated", [](Vector& v) { v.y = -v.y; }),
                    change<Vector>("with y subtracted from 1", [](Vector& v) { v.y = 1 - v.y; }),
                    change<Vector>("limited to [0, 1]", [](Vector& v) { v = glm::clamp(v, Vector(0), Vector(1)); }),
                    change<Vector>("rounded towards 0", [](Vector& v) { v = glm::trunc(v); }),
                });
    }();
    static constexpr auto with_z = [] {
        if constexpr (Vector::length() < 3 || !std::is_floating_point_v<typename Vector::value_type>)
            return of_numbers;
        else
            return joined(of_numbers,
                          std::array{
                              change<Vector>("with y and z exchanged", [](Vector& v) { std::swap(v.y, v.z); }),
                              change<Vector>("with x and z exchanged", [](Vector& v) { std::swap(v.x, v.z); }),
                              change<Vector>("with z negated", [](Vector& v) { v.z = -v.z; }),
                          });
    }();
    static constexpr auto all = [] {
        if constexpr (Vector::length() < 3)
            return with_z;
        else
            return joined(with_z, std::array{
                                      copied<Vector, 2, 1>("with z taken as y"),
                                      copied<Vector, 2, 0>("with z taken as x"),
                                      copied<Vector, 1, 2>("with y taken as z"),
                                      copied<Vector, 0, 2>("with x taken as z"),
                                  });
    }();
};

template <class Matrix>
requires literal::detail::is_matrix<Matrix>
struct ChangesOf<Matrix> {
    static constexpr std::array all{
        change<Matrix>("transposed", [](Matrix& m) { m = glm::transpose(m); }),
        change<Matrix>("inverted", [](Matrix& m) { m = glm::inverse(m); }),
        change<Matrix>("taken as the identity", [](Matrix& m) { m = Matrix(1); }),
        change<Matrix>("without its translation",
                       [](Matrix& m) {
                           auto& last = m[Matrix::length() - 1];
                           const auto corner = last[Matrix::length() - 1];
                           last *= 0;
                           last[Matrix::length() - 1] = corner;
                       }),
    };
};

template <class Element>
void turn_round(Element& element)
{
    if constexpr (literal::detail::is_vector<Element>) {
        if constexpr (Element::length() == 3) std::swap(element.y, element.z);
    }
}

template <class Element>
struct ChangesOf<std::vector<Element>> {
    using List = std::vector<Element>;
    static constexpr auto all = [] {
        constexpr std::array common{
            change<List>("in reverse order", [](List& list) { std::reverse(list.begin(), list.end()); }),
            change<List>("without its first element",
                         [](List& list) {
                             if (!list.empty()) list.erase(list.begin());
                         }),
            change<List>("without its last element",
                         [](List& list) {
                             if (!list.empty()) list.pop_back();
                         }),
            change<List>("beginning with its second element, the first one last",
                         [](List& list) {
                             if (!list.empty()) std::rotate(list.begin(), list.begin() + 1, list.end());
                         }),
            change<List>("cut to its first element",
                         [](List& list) {
                             if (!list.empty()) list.erase(list.begin() + 1, list.end());
                         }),
            change<List>("cut to its first three elements",
                         [](List& list) {
                             if (list.size() > 3) list.erase(list.begin() + 3, list.end());
                         }),
            change<List>("with its last element twice",
                         [](List& list) {
                             if (!list.empty()) list.push_back(Element(list.back()));
                         }),
            change<List>("with its first element at its end as well",
                         [](List& list) {
                             if (!list.empty()) list.push_back(Element(list.front()));
                         }),
        };
        if constexpr (std::is_same_v<Element, glm::uvec3>)
            return joined(common, std::array{change<List>("with each triangle turned round", [](List& list) {
                              for (Element& element : list) turn_round(element);
                          })});
        else
            return common;
    }();
};

}

}
