#pragma once

#include <glm/glm.hpp>

#include "../wide.hpp"

/// Vectors of 113 bits, for the oracles of ray tracing.
namespace umbral::raytracing {

struct WideVector {
    Wide x, y, z;
};

inline WideVector widened(const glm::vec3& v) { return {v.x, v.y, v.z}; }
inline WideVector operator+(const WideVector& a, const WideVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline WideVector operator-(const WideVector& a, const WideVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline WideVector operator*(Wide factor, const WideVector& v) { return {factor * v.x, factor * v.y, factor * v.z}; }
inline Wide dot(const WideVector& a, const WideVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline WideVector cross(const WideVector& a, const WideVector& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}
