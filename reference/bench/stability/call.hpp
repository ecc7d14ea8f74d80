#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

/// Numeric functions seen alike: plain floats in, plain floats out. So the same loop asks all of them.
///
/// The files in calls/ are compiled twice: with the references, and with the oracles, whose namespace is another one
/// (CMakeLists.txt). This namespace is shared by both.
namespace stability {

/// The numbers of a question, in the order of the function's arguments.
using Numbers = std::span<const float>;
/// All numbers of an answer; none for std::nullopt.
using Answer = std::vector<float>;

/// A function, and how it is written down.
struct Call {
    const char* name;  ///< qualified below umbral, as "lighting::encode_srgb"
    /// Its arguments: f a number, u, v, w a vec2, vec3, vec4, m, M a mat3, mat4, i a whole number; braces and constants
    /// stand as they are, commas are added between letters.
    const char* shape;
    Answer (*answer)(Numbers);
};

/// How many numbers a shape takes.
[[nodiscard]] std::size_t numbers_of(const char* shape);

[[nodiscard]] inline glm::vec2 u_at(Numbers x, std::size_t at) { return {x[at], x[at + 1]}; }
[[nodiscard]] inline glm::vec3 v_at(Numbers x, std::size_t at) { return {x[at], x[at + 1], x[at + 2]}; }
[[nodiscard]] inline glm::mat3 m_at(Numbers x, std::size_t at)
{
    return {v_at(x, at), v_at(x, at + 3), v_at(x, at + 6)};
}
[[nodiscard]] inline glm::mat4 M_at(Numbers x, std::size_t at)
{
    glm::mat4 matrix;
    for (int entry = 0; entry < 16; ++entry) matrix[entry / 4][entry % 4] = x[at + static_cast<std::size_t>(entry)];
    return matrix;
}

[[nodiscard]] inline Answer numbers(float value) { return {value}; }
[[nodiscard]] inline Answer numbers(const glm::vec2& v) { return {v.x, v.y}; }
[[nodiscard]] inline Answer numbers(const glm::vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Answer numbers(const glm::vec4& v) { return {v.x, v.y, v.z, v.w}; }
template <int Size>
[[nodiscard]] Answer numbers(const glm::mat<Size, Size, float>& matrix)
{
    Answer all;
    for (int column = 0; column < Size; ++column)
        for (int row = 0; row < Size; ++row) all.push_back(matrix[column][row]);
    return all;
}

template <class Value>
[[nodiscard]] Answer numbers(const std::optional<Value>& value)
{
    return value ? numbers(*value) : Answer{};
}

/// One after the other.
template <class... Values>
[[nodiscard]] Answer joined(const Values&... values)
{
    Answer all;
    const auto append = [&all](const Answer& more) { all.insert(all.end(), more.begin(), more.end()); };
    (append(numbers(values)), ...);
    return all;
}

}
