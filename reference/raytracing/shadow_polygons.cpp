// Based on: P. Atherton, K. Weiler, D. Greenberg. Polygon Shadow Generation. SIGGRAPH 1978: shadows in object
// precision, here of each polygon on each other one. I. Sutherland, G. Hodgman. Reentrant Polygon Clipping. CACM, 1974.

#include <algorithm>
#include <cmath>
#include <umbral/raytracing/shadow_polygons.hpp>

namespace umbral::raytracing {
namespace {

using Corners = std::vector<glm::dvec3>;

// Points with dot(normal, p - point) >= 0.
struct HalfSpace {
    glm::dvec3 normal;
    glm::dvec3 point;
};

double height(const HalfSpace& space, const glm::dvec3& p) { return dot(space.normal, p - space.point); }

// Twice the area of a flat polygon, along its normal: the sum over a fan.
glm::dvec3 area_of(const Corners& polygon)
{
    glm::dvec3 sum(0);
    for (std::size_t i = 2; i < polygon.size(); ++i) sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return sum;
}

// What lies before a polygon; it has a corner.
HalfSpace before(const Corners& polygon) { return {area_of(polygon), polygon[0]}; }

// A corner on the border stays; where it is an end of a side that leaves, it comes twice.
Corners clipped(const Corners& polygon, const HalfSpace& space)
{
    Corners result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double at_a = height(space, a);
        const double at_b = height(space, b);
        if (at_a >= 0) result.push_back(a);
        if ((at_a >= 0) != (at_b >= 0)) result.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    return result;
}

// The part of a polygon within the rays from `apex`, a place or a direction, through a window whose plane has that apex
// at height `side`. These planes all lead through the apex, so that nothing behind it is left.
Corners within_rays(Corners polygon, const glm::dvec4& apex, const Corners& window, double side)
{
    for (std::size_t i = 0; i < window.size(); ++i) {
        const glm::dvec3& a = window[i];
        const glm::dvec3& b = window[i + 1 < window.size() ? i + 1 : 0];
        const glm::dvec3 to_apex = glm::dvec3(apex) - apex.w * a;
        polygon = clipped(polygon, {side > 0 ? cross(to_apex, b - a) : cross(b - a, to_apex), a});
    }
    return polygon;
}

// Corners as floats, each once; nothing if they lie on a line but for what rounding makes of it.
FlatPolygon rounded(const Corners& corners)
{
    FlatPolygon result;
    double extent = 0;
    for (const glm::dvec3& corner : corners) {
        if (result.empty() || glm::vec3(corner) != result.back()) result.emplace_back(corner);
        extent = std::max(extent, distance(corner, corners[0]));
    }
    if (result.size() > 1 && result.back() == result.front()) result.pop_back();
    if (length(area_of(corners)) <= 1e-7 * extent * extent) return {};
    return result;
}

struct Looker {
    const std::vector<FlatPolygon>& mirrors;
    std::vector<MirrorView> views;

    // Adds the views that go on from an eye that looks through `window`, the mirror it was mirrored in last; without
    // one, from the eye itself.
    void look(const glm::dvec3& eye, const std::vector<std::size_t>& path, const Corners* window, int levels)
    {
        for (std::size_t i = 0; i < mirrors.size() && levels > 0; ++i) {
            if (mirrors[i].empty()) continue;
            Corners seen(mirrors[i].begin(), mirrors[i].end());
            const HalfSpace mirror = before(seen);
            const double away = height(mirror, eye);
            if (away <= 0) continue;  // the one that it was mirrored in last among them
            if (window != nullptr) {
                const HalfSpace last = before(*window);
                seen = within_rays(clipped(seen, last), glm::dvec4(eye, 1), *window, height(last, eye));
            }
            MirrorView view{path, {}, rounded(seen)};
            if (view.window.empty()) continue;
            view.path.push_back(i);
            const glm::dvec3 image = eye - 2 * away / dot(mirror.normal, mirror.normal) * mirror.normal;
            view.eye = glm::vec3(image);
            views.push_back(view);
            look(image, view.path, &seen, levels - 1);
        }
    }
};

}

// First what throws the shadow is cut to the pyramid between light and receiver, then it is projected: so no division
// meets a point that has no shadow.
FlatPolygon shadow_polygon(const glm::vec4& light, const FlatPolygon& caster, const FlatPolygon& receiver)
{
    if (receiver.empty()) return {};
    const Corners ground(receiver.begin(), receiver.end());
    HalfSpace above = before(ground);
    const glm::dvec4 source(light);
    const glm::dvec3 from(source);
    const double side = dot(above.normal, from - source.w * above.point);
    if (side < 0) above.normal = -above.normal;
    Corners corners(caster.begin(), caster.end());
    const auto throws = [&](const glm::dvec3& corner) { return height(above, corner) > 0; };
    if (side == 0 || std::none_of(corners.begin(), corners.end(), throws)) return {};
    corners = within_rays(clipped(corners, above), source, ground, side);
    for (glm::dvec3& p : corners) {
        const double rise = height(above, p);
        p += rise / (std::abs(side) - source.w * rise) * (source.w * p - from);
    }
    if (dot(area_of(corners), area_of(ground)) < 0) std::reverse(corners.begin(), corners.end());
    return rounded(corners);
}

glm::mat4 mirror_matrix(const glm::vec4& plane)
{
    const glm::dvec3 n(plane);
    const glm::dvec4 scaled = glm::dvec4(plane) / dot(n, n);
    return glm::mat4(glm::dmat4(1) - 2.0 * glm::outerProduct(glm::dvec4(n, 0), scaled));
}

glm::mat4 mirrored_view(const glm::mat4& view, const glm::vec4& plane) { return view * mirror_matrix(plane); }

std::vector<MirrorView> mirror_views(const glm::vec3& eye, const std::vector<FlatPolygon>& mirrors, int levels)
{
    Looker looker{mirrors, {}};
    looker.look(glm::dvec3(eye), {}, nullptr, levels);
    return looker.views;
}

}
