#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "wide.hpp"

/// Vectors of 113 bits, for oracles.
namespace umbral {

struct WideVector {
    Wide x, y, z;

    Wide& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
    const Wide& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
};

inline WideVector widened(const glm::vec3& v) { return {v.x, v.y, v.z}; }
inline glm::vec3 rounded(const WideVector& v)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
inline WideVector operator+(const WideVector& a, const WideVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline WideVector operator-(const WideVector& a, const WideVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline WideVector operator*(Wide factor, const WideVector& v) { return {factor * v.x, factor * v.y, factor * v.z}; }
inline WideVector operator/(const WideVector& v, Wide divisor) { return {v.x / divisor, v.y / divisor, v.z / divisor}; }
inline Wide dot(const WideVector& a, const WideVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline WideVector cross(const WideVector& a, const WideVector& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Wide length(const WideVector& v) { return square_root(dot(v, v)); }
/// In the direction of v, which is not null.
inline WideVector unit(const WideVector& v) { return v / length(v); }
inline bool is_null(const WideVector& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

}
