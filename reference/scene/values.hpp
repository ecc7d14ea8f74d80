#pragma once

#include <glm/glm.hpp>

#include "text/field.hpp"

/// Numbers and vectors of a JSON file as the scenes hold them: in float. All throw as Field's readers do.
namespace umbral::scene {

[[nodiscard]] inline float real(const Field& field, double low, double high)
{
    return static_cast<float>(field.number(low, high));
}

/// A number that may be left out.
[[nodiscard]] inline float real_or(const Field& field, double low, double high, float otherwise)
{
    return field.given() ? real(field, low, high) : otherwise;
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

}
