#pragma once

#include <glm/glm.hpp>

#include "scene/limits.hpp"
#include "text/field.hpp"

/// Numbers and vectors of a JSON file as the scenes hold them: in float. All throw as Field's readers do.
namespace umbral::scene {

[[nodiscard]] inline float real(const Field& field, double low, double high)
{
    return static_cast<float>(field.number(low, high));
}

/// An array of two numbers.
[[nodiscard]] inline glm::vec2 vector2(const Field& field, double low, double high)
{
    const std::vector<Field> parts = field.items(2, 2);
    return {real(parts[0], low, high), real(parts[1], low, high)};
}

/// An array of three numbers.
[[nodiscard]] inline glm::vec3 vector3(const Field& field, double low, double high)
{
    const std::vector<Field> parts = field.items(3, 3);
    return {real(parts[0], low, high), real(parts[1], low, high), real(parts[2], low, high)};
}

/// Light, or a share of it: linear, no part negative.
[[nodiscard]] inline glm::vec3 color_or(const Field& field, const glm::vec3& fallback, double most = maximum_color)
{
    return field.given() ? vector3(field, 0, most) : fallback;
}

[[nodiscard]] inline glm::vec3 place(const Field& field)
{
    return vector3(field, -maximum_coordinate, maximum_coordinate);
}

[[nodiscard]] inline glm::vec3 direction(const Field& field)
{
    const glm::vec3 value = place(field);
    // Neither may its square vanish, in float.
    if (dot(value, value) < 1e-20F) field.refuse("a direction of length 1e-10 or more");
    return value;
}

/// A number that may be left out.
[[nodiscard]] inline float real_or(const Field& field, double low, double high, float fallback)
{
    return field.given() ? real(field, low, high) : fallback;
}

}
