#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>
#include <type_traits>

#include "call.hpp"

namespace stability {

/// The letter of an argument's type in a shape.
template <class Argument>
inline constexpr char letter_of = '\0';
template <>
inline constexpr char letter_of<float> = 'f';
template <>
inline constexpr char letter_of<glm::vec2> = 'u';
template <>
inline constexpr char letter_of<glm::vec3> = 'v';
template <>
inline constexpr char letter_of<glm::vec4> = 'w';
template <>
inline constexpr char letter_of<glm::mat3> = 'm';
template <>
inline constexpr char letter_of<glm::mat4> = 'M';

/// Takes the next argument off the question's numbers. All types here are nothing but their numbers, column by column.
template <class Argument>
[[nodiscard]] Argument next_argument(Numbers& left)
{
    static_assert(letter_of<Argument> != '\0');
    std::array<float, sizeof(Argument) / sizeof(float)> numbers{};
    std::ranges::copy(left.first(numbers.size()), numbers.begin());
    left = left.subspan(numbers.size());
    return std::bit_cast<Argument>(numbers);
}

/// A function of numbers, vectors and matrices alone: shape and answer follow from its type.
template <auto Function>
struct Plain;
template <class Result, class... Arguments, Result (*Function)(Arguments...)>
struct Plain<Function> {
    static constexpr std::array<char, sizeof...(Arguments) + 1> shape{letter_of<std::remove_cvref_t<Arguments>>...,
                                                                      '\0'};
    static Answer answer(Numbers left)
    {
        // What stands in braces is computed from left to right.
        const std::tuple<std::remove_cvref_t<Arguments>...> arguments{
            next_argument<std::remove_cvref_t<Arguments>>(left)...};
        return numbers(std::apply(Function, arguments));
    }
};

/// Such a function under its name, as a Call has it.
template <auto Function>
[[nodiscard]] Call call(const char* name)
{
    return {name, Plain<Function>::shape.data(), Plain<Function>::answer};
}

}
