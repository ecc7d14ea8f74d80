#pragma once

#include <array>
#include <type_traits>
#include <utility>

#include "call.hpp"

namespace stability {

/// How an argument of a type is made: its letter in a shape, and how many numbers it takes.
template <class Argument>
struct Made;
template <>
struct Made<float> {
    static constexpr char letter = 'f';
    static constexpr std::size_t size = 1;
    static float of(Numbers x, std::size_t at) { return x[at]; }
};
template <>
struct Made<glm::vec2> {
    static constexpr char letter = 'u';
    static constexpr std::size_t size = 2;
    static glm::vec2 of(Numbers x, std::size_t at) { return u_at(x, at); }
};
template <>
struct Made<glm::vec3> {
    static constexpr char letter = 'v';
    static constexpr std::size_t size = 3;
    static glm::vec3 of(Numbers x, std::size_t at) { return v_at(x, at); }
};
template <>
struct Made<glm::vec4> {
    static constexpr char letter = 'w';
    static constexpr std::size_t size = 4;
    static glm::vec4 of(Numbers x, std::size_t at) { return w_at(x, at); }
};
template <>
struct Made<glm::mat3> {
    static constexpr char letter = 'm';
    static constexpr std::size_t size = 9;
    static glm::mat3 of(Numbers x, std::size_t at) { return m_at(x, at); }
};
template <>
struct Made<glm::mat4> {
    static constexpr char letter = 'M';
    static constexpr std::size_t size = 16;
    static glm::mat4 of(Numbers x, std::size_t at) { return M_at(x, at); }
};

/// A function of numbers, vectors and matrices alone: shape and answer follow from its type.
template <auto Function>
struct Plain;
template <class Result, class... Arguments, Result (*Function)(Arguments...)>
struct Plain<Function> {
    static constexpr std::array<char, sizeof...(Arguments) + 1> shape{Made<std::remove_cvref_t<Arguments>>::letter...,
                                                                      '\0'};
    static Answer answer(Numbers x) { return answer(x, std::index_sequence_for<Arguments...>()); }

private:
    static constexpr std::array<std::size_t, sizeof...(Arguments)> sizes{Made<std::remove_cvref_t<Arguments>>::size...};
    static constexpr std::size_t start_of(std::size_t argument)
    {
        std::size_t start = 0;
        for (std::size_t i = 0; i < argument; ++i) start += sizes[i];
        return start;
    }
    template <std::size_t... Each>
    static Answer answer(Numbers x, std::index_sequence<Each...> /*arguments*/)
    {
        return numbers(Function(Made<std::remove_cvref_t<Arguments>>::of(x, start_of(Each))...));
    }
};

template <auto Function>
[[nodiscard]] Call call(const char* name)
{
    return {name, Plain<Function>::shape.data(), Plain<Function>::answer};
}

}
