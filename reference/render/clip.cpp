#include "render/clip.hpp"

namespace umbral::render {
namespace {

/// Signed distances to the six planes, positive inside; in double, since near a plane they are differences of nearly equal numbers.
double inside(const glm::vec4& clip, unsigned plane, const glm::vec2& guard)
{
    const glm::dvec4 at(clip);
    switch (plane) {
        case 0: return double{guard.x} * at.w + at.x;
        case 1: return double{guard.x} * at.w - at.x;
        case 2: return double{guard.y} * at.w + at.y;
        case 3: return double{guard.y} * at.w - at.y;
        case 4: return at.w + at.z;
        default: return at.w - at.z;
    }
}

constexpr unsigned plane_count = 6;

template <class Vector>
Vector between(const Vector& a, const Vector& b, double t)
{
    return a + static_cast<float>(t) * (b - a);
}

ClipVertex cut(const ClipVertex& inner, const ClipVertex& outer, double from_inner, double from_outer)
{
    const double t = from_inner / (from_inner - from_outer);
    return {between(inner.clip, outer.clip, t), between(inner.eye, outer.eye, t), between(inner.normal, outer.normal, t), between(inner.uv, outer.uv, t)};
}

ClipPolygon clip_at(const ClipPolygon& polygon, unsigned plane, const glm::vec2& guard)
{
    ClipPolygon kept;
    for (std::size_t i = 0; i < polygon.size; ++i) {
        const ClipVertex& a = polygon.corners[i];
        const ClipVertex& b = polygon.corners[(i + 1) % polygon.size];
        const double at_a = inside(a.clip, plane, guard);
        const double at_b = inside(b.clip, plane, guard);
        if (at_a >= 0) kept.add(a);
        if (at_a >= 0 && at_b < 0) kept.add(cut(a, b, at_a, at_b));
        if (at_a < 0 && at_b >= 0) kept.add(cut(b, a, at_b, at_a));
    }
    return kept;
}

}

unsigned outcode(const glm::vec4& clip, const glm::vec2& guard)
{
    unsigned code = 0;
    for (unsigned plane = 0; plane < plane_count; ++plane) code |= (inside(clip, plane, guard) < 0 ? 1U : 0U) << plane;
    return code;
}

ClipPolygon clip_triangle(const std::array<ClipVertex, 3>& triangle, unsigned planes, const glm::vec2& guard)
{
    ClipPolygon polygon;
    for (const ClipVertex& corner : triangle) polygon.add(corner);
    for (unsigned plane = 0; plane < plane_count && polygon.size > 0; ++plane)
        if (((planes >> plane) & 1U) != 0) polygon = clip_at(polygon, plane, guard);
    return polygon;
}

}
