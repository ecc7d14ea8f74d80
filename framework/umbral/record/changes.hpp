#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <umbral/record/literal.hpp>
#include <umbral/record/place.hpp>
#include <utility>
#include <vector>

namespace umbral {

/// A way to misunderstand an argument: "negated", "in degrees". `make` changes the value in place.
struct Change {
    std::string_view name{};
    void (*make)(void* value) = nullptr;
};

/// A part of a question's arguments that can be misunderstood as a whole: a number, a vector, a matrix, a list.
struct Part {
    Place place;               ///< as in Features: "0.direction"
    std::string_view type;     ///< two parts of one type can be taken for each other
    std::string_view owner{};  ///< the type of the struct that it is a field of; empty for an argument
    bool of_element = false;   ///< a field of a list's element, which is changed with all others of its kind only
    void* value = nullptr;
    std::span<const Change> changes{};
    void (*exchange)(void* one, void* other) = nullptr;
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
        change<Number>("doubled", [](Number& x) { x = static_cast<Number>(x * 2); }),
        change<Number>("halved", [](Number& x) { x = static_cast<Number>(x / 2); }),
    };
};

/// "taken as even_odd": lives as long as the program.
template <class Enum, int Value>
inline constexpr auto taken_as = [] {
    constexpr std::string_view begin = "taken as ";
    constexpr std::string_view name = reflect::last_name(reflect::value_name<static_cast<Enum>(Value)>());
    std::array<char, begin.size() + name.size()> text{};
    std::copy(begin.begin(), begin.end(), text.begin());
    std::copy(name.begin(), name.end(), text.begin() + begin.size());
    return text;
}();

/// So many enumerators are asked in place of others; of longer lists the first.
inline constexpr int most_asked_enumerators = 6;

template <class Enum>
requires std::is_enum_v<Enum>
struct ChangesOf<Enum> {
    static constexpr int count = std::min(reflect::enumerators<Enum>, most_asked_enumerators);
    static constexpr auto all = []<int... Value>(std::integer_sequence<int, Value...>)
    {
        return std::array<Change, sizeof...(Value)>{
            change<Enum>(std::string_view(taken_as<Enum, Value>.data(), taken_as<Enum, Value>.size()),
                         [](Enum& e) { e = static_cast<Enum>(Value); })...};
    }
    (std::make_integer_sequence<int, count>{});
};

template <class Vector>
void normalise(Vector& v)
{
    const auto length = glm::length(v);
    if (length > 0) v /= length;
}

template <class Vector>
requires literal::detail::is_vector<Vector>
struct ChangesOf<Vector> {
    static constexpr auto all = [] {
        constexpr std::array common{
            change<Vector>("taken as 0", [](Vector& v) { v = Vector(0); }),
            change<Vector>("with x and y exchanged", [](Vector& v) { std::swap(v.x, v.y); }),
        };
        if constexpr (!std::is_floating_point_v<typename Vector::value_type>) {
            return common;
        } else {
            constexpr std::array real{
                common[0],
                common[1],
                change<Vector>("negated", [](Vector& v) { v = -v; }),
                change<Vector>("normalised", [](Vector& v) { normalise(v); }),
                change<Vector>("doubled", [](Vector& v) { v *= 2; }),
                change<Vector>("halved", [](Vector& v) { v /= 2; }),
                change<Vector>("without the signs of its components", [](Vector& v) { v = glm::abs(v); }),
                change<Vector>("with x negated", [](Vector& v) { v.x = -v.x; }),
                change<Vector>("with y negated", [](Vector& v) { v.y = -v.y; }),
                change<Vector>("with y subtracted from 1", [](Vector& v) { v.y = 1 - v.y; }),
                change<Vector>("limited to [0, 1]", [](Vector& v) { v = glm::clamp(v, Vector(0), Vector(1)); }),
                change<Vector>("rounded towards 0", [](Vector& v) { v = glm::trunc(v); }),
            };
            if constexpr (Vector::length() < 3)
                return real;
            else
                return joined(real,
                              std::array{
                                  change<Vector>("with y and z exchanged", [](Vector& v) { std::swap(v.y, v.z); }),
                                  change<Vector>("with x and z exchanged", [](Vector& v) { std::swap(v.x, v.z); }),
                                  change<Vector>("with z negated", [](Vector& v) { v.z = -v.z; }),
                              });
        }
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

template <class Value>
inline constexpr bool is_list_of_structs = false;
template <class Element>
inline constexpr bool is_list_of_structs<std::vector<Element>> =
    reflect::is_plain_struct<Element> && !literal::detail::is_vector<Element>;
/// So many elements of a list have fields that are changed with others of their kind: of chains, not of meshes.
inline constexpr std::size_t most_elements = 64;

template <class Value>
void exchange(void* one, void* other)
{
    std::swap(*static_cast<Value*>(one), *static_cast<Value*>(other));
}

}

/// Adds the parts of `value`, which stands at `place`, and itself if it is one.
template <class Value>
void add_parts(const Place& place, Value& value, std::vector<Part>& parts, std::string_view owner = {},
               bool of_element = false)
{
    if constexpr (detail::is_list_of_structs<Value>)
        for (std::size_t i = 0; i < std::min(value.size(), detail::most_elements); ++i)
            add_parts(place, value[i], parts, {}, true);
    if constexpr (!detail::ChangesOf<Value>::all.empty())
        parts.push_back({place, reflect::type_name<Value>(), owner, of_element, &value, detail::ChangesOf<Value>::all,
                         detail::exchange<Value>});
    else if constexpr (reflect::is_plain_struct<Value> && std::is_swappable_v<Value>) {
        parts.push_back({place, reflect::type_name<Value>(), owner, of_element, &value, {}, detail::exchange<Value>});
        reflect::for_each_field(value, [&](std::string_view name, auto& field) {
            add_parts(place / name, field, parts, name.starts_with('[') ? "" : reflect::type_name<Value>(), of_element);
        });
    }
}

/// A question asked in place of another: in calls of `function`, the part at `place` is changed so, or exchanged with
/// the part at `other`. Without a function, `place` is a field of a struct, "umbral::AxisAngle.angle", and all such
/// parts of all calls are changed: what is misunderstood in a helper is misunderstood everywhere.
struct OtherQuestion {
    std::string function;
    std::string place;
    std::string change;  ///< the name of a Change; empty: an exchange
    std::string other;

    friend bool operator==(const OtherQuestion&, const OtherQuestion&) = default;
};

/// All that can be asked with these parts in place of what was asked.
[[nodiscard]] std::vector<OtherQuestion> other_questions(std::string_view function, std::span<const Part> parts);

/// The field that a part is, as an OtherQuestion without a function names it; empty for an argument.
[[nodiscard]] std::string field_of(const Part& part);

/// Which parts an other question means, among those of its function: looked up once.
struct ChangedParts {
    bool known = false;
    std::optional<std::size_t> part{};
    std::optional<std::size_t> other{};
    void (*make)(void* value) = nullptr;
};

/// Changes the parts of a call of its function as `question` says; where they have no such place, nothing.
void change_parts(const OtherQuestion& question, std::span<const Part> parts, ChangedParts& which);

}
