// Based on: I. Sutherland, G. Hodgman. Reentrant Polygon Clipping. 1974. J. Blinn, M. Newell. Clipping Using
// Homogeneous Coordinates. 1978.

#include <cmath>
#include <umbral/pipeline/clip.hpp>

namespace umbral::pipeline {
namespace {

// In double, since a side may lead from a millimetre before the eye to a kilometre behind it.
struct Corner {
    glm::dvec4 position;
    glm::dvec3 weights;
};

// The half-space sign * position[axis] <= w. Their order is that of the bits of outside_planes.
struct Plane {
    int axis;
    double sign;
};
constexpr std::array<Plane, 6> planes = {Plane{0, -1}, {0, 1}, {1, -1}, {1, 1}, {2, -1}, {2, 1}};

// Positive inside, and linear: where it is 0 a side crosses the plane.
double distance(const Corner& corner, const Plane& plane)
{
    return corner.position.w - plane.sign * corner.position[plane.axis];
}

// Always computed from the inner end to the outer one: both triangles at a side get the same bits.
Corner crossing(const Corner& inner, double inner_distance, const Corner& outer, double outer_distance,
                const Plane& plane)
{
    const double span = inner_distance - outer_distance;
    const double to_outer = inner_distance / span;
    const double to_inner = -outer_distance / span;
    Corner corner{to_inner * inner.position + to_outer * outer.position,
                  to_inner * inner.weights + to_outer * outer.weights};
    corner.position[plane.axis] = plane.sign * corner.position.w;
    return corner;
}

// At most one corner more than it was for each plane; rounding may make a sliver not quite convex, and there is room
// for that.
struct Polygon {
    std::array<Corner, 16> corners;
    std::size_t size = 0;

    void add(const Corner& corner)
    {
        if (size < corners.size()) corners[size++] = corner;
    }
};

Polygon clipped(const Polygon& polygon, const Plane& plane)
{
    Polygon result;
    for (std::size_t i = 0; i < polygon.size; ++i) {
        const Corner& a = polygon.corners[i];
        const Corner& b = polygon.corners[i + 1 < polygon.size ? i + 1 : 0];
        const double at_a = distance(a, plane);
        const double at_b = distance(b, plane);
        if (at_a >= 0) result.add(a);
        if (at_a > 0 && at_b < 0) result.add(crossing(a, at_a, b, at_b, plane));
        if (at_a < 0 && at_b > 0) result.add(crossing(b, at_b, a, at_a, plane));
    }
    return result;
}

// Rounding never leads out of the volume: it keeps the order of |x| and w, here and in the sums of a crossing.
ClipVertex rounded(const Corner& corner) { return {glm::vec4(corner.position), glm::vec3(corner.weights)}; }

// Nothing is left where fewer than three different corners are, or one that cannot be divided by w.
void append(const Polygon& polygon, std::vector<ClipVertex>& result)
{
    const std::size_t begin = result.size();
    bool in_front = true;
    for (std::size_t i = 0; i < polygon.size; ++i) {
        const ClipVertex corner = rounded(polygon.corners[i]);
        in_front = in_front && corner.position.w > 0;
        if (result.size() == begin || corner.position != result.back().position) result.push_back(corner);
    }
    while (result.size() > begin + 1 && result.back().position == result[begin].position) result.pop_back();
    if (!in_front || result.size() < begin + 3) result.resize(begin);
}

bool finite(const glm::vec4& position) { return glm::all(glm::equal(0.0F * position, glm::vec4(0))); }

}

void clip_triangle(const std::array<glm::vec4, 3>& triangle, std::vector<ClipVertex>& polygon)
{
    const auto& [a, b, c] = triangle;
    if (!finite(a) || !finite(b) || !finite(c)) return;
    const unsigned outside_a = outside_planes(a);
    const unsigned outside_b = outside_planes(b);
    const unsigned outside_c = outside_planes(c);
    if ((outside_a & outside_b & outside_c) != 0) return;

    Polygon inside{{Corner{a, {1, 0, 0}}, {b, {0, 1, 0}}, {c, {0, 0, 1}}}, 3};
    for (std::size_t i = 0; i < planes.size(); ++i)
        if ((((outside_a | outside_b | outside_c) >> i) & 1U) != 0) inside = clipped(inside, planes[i]);
    append(inside, polygon);
}

}
