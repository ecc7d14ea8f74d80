// alternative: the shadow matrix in homogeneous coordinates, cut after it and before the division; mirrors by their
// basis
#include <algorithm>
#include <umbral/raytracing/shadow_polygons.hpp>

namespace umbral::raytracing {
namespace {

struct Piece {
    std::vector<glm::dvec4> corners;

    void keep(const glm::dvec4& plane)
    {
        std::vector<glm::dvec4> kept;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec4 from = corners[i];
            const glm::dvec4 to = corners[(i + 1) % corners.size()];
            const double a = dot(plane, from);
            const double b = dot(plane, to);
            if (a >= 0) kept.push_back(from);
            if ((a > 0 && b < 0) || (a < 0 && b > 0)) kept.push_back((b * from - a * to) / (b - a));
        }
        corners = kept;
    }

    FlatPolygon flat() const
    {
        FlatPolygon result;
        for (const glm::dvec4& corner : corners) {
            const glm::vec3 place(glm::dvec3(corner) / corner.w);
            if (std::find(result.begin(), result.end(), place) == result.end()) result.push_back(place);
        }
        return result.size() < 3 ? FlatPolygon() : result;
    }
};

glm::dvec3 area_of(const FlatPolygon& polygon)
{
    glm::dvec3 area(0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        area += cross(glm::dvec3(polygon[i] - polygon[0]), glm::dvec3(polygon[i + 1] - polygon[0]));
    return area;
}

bool thin(const FlatPolygon& polygon)
{
    double longest = 0;
    for (const glm::vec3& corner : polygon) longest = std::max(longest, double{distance(corner, polygon[0])});
    return polygon.size() < 3 || length(area_of(polygon)) < 1e-6 * longest * longest;
}

glm::dvec4 plane_through(const FlatPolygon& polygon)
{
    glm::dvec3 n(0);
    const glm::dvec3 a(polygon[0]);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        n += cross(glm::dvec3(polygon[i]) - a, glm::dvec3(polygon[i + 1]) - a);
    n = normalize(n);
    return {n, -dot(n, a)};
}

Piece piece_of(const FlatPolygon& polygon)
{
    Piece piece;
    for (const glm::vec3& corner : polygon) piece.corners.emplace_back(corner, 1);
    return piece;
}

// The planes through a polygon's sides, perpendicular to it: the inside is positive.
std::vector<glm::dvec4> fences(const FlatPolygon& polygon)
{
    const glm::dvec3 n(plane_through(polygon));
    std::vector<glm::dvec4> planes;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a(polygon[i]);
        const glm::dvec3 inwards = cross(n, glm::dvec3(polygon[(i + 1) % polygon.size()]) - a);
        planes.emplace_back(inwards, -dot(inwards, a));
    }
    return planes;
}

// The matrix that takes points along their lines from `source` onto a plane.
glm::dmat4 onto(const glm::dvec4& plane, const glm::dvec4& source)
{
    return glm::dmat4(dot(plane, source)) - glm::outerProduct(source, plane);
}

void views_from(const glm::dvec3& eye, const std::vector<FlatPolygon>& mirrors, const MirrorView& last, int levels,
                std::vector<MirrorView>& views)
{
    if (levels <= 0) return;
    for (std::size_t i = 0; i < mirrors.size(); ++i) {
        if (mirrors[i].size() < 3) continue;
        const glm::dvec4 mirror = plane_through(mirrors[i]);
        if (dot(mirror, glm::dvec4(eye, 1)) <= 0) continue;
        Piece seen = piece_of(mirrors[i]);
        if (!last.path.empty()) {
            const glm::dvec4 before = plane_through(mirrors[last.path.back()]);
            const glm::dvec4 source(eye, 1);
            // Projected onto the window's plane, what is seen lies within the window.
            const glm::dmat4 projected = onto(-before, source);
            seen.keep(before);
            for (const glm::dvec4& fence : fences(last.window)) seen.keep(fence * projected);
        }
        MirrorView view{last.path, glm::vec3(0), seen.flat()};
        if (thin(view.window)) continue;
        view.path.push_back(i);
        const glm::dvec3 image = eye - 2 * dot(mirror, glm::dvec4(eye, 1)) * glm::dvec3(mirror);
        view.eye = glm::vec3(image);
        views.push_back(view);
        views_from(image, mirrors, view, levels - 1, views);
    }
}

}

FlatPolygon shadow_polygon(const glm::vec4& light, const FlatPolygon& caster, const FlatPolygon& receiver)
{
    if (caster.size() < 3 || receiver.size() < 3) return {};
    glm::dvec4 plane = plane_through(receiver);
    const glm::dvec4 source(light);
    const double side = dot(plane, source);
    if (side == 0) return {};
    if (side < 0) plane = -plane;
    const bool rises =
        std::any_of(caster.begin(), caster.end(), [&](const glm::vec3& p) { return dot(plane, glm::dvec4(p, 1)) > 0; });
    if (!rises) return {};
    Piece piece = piece_of(caster);
    piece.keep(plane);
    const glm::dmat4 shadow = onto(plane, source);
    for (glm::dvec4& corner : piece.corners) corner = shadow * corner;
    for (const glm::dvec4& fence : fences(receiver)) piece.keep(fence);
    FlatPolygon result = piece.flat();
    if (thin(result)) return {};
    if (dot(area_of(result), area_of(receiver)) < 0) std::reverse(result.begin(), result.end());
    return result;
}

glm::mat4 mirror_matrix(const glm::vec4& plane)
{
    const glm::dvec3 n(plane);
    const double square = dot(n, n);
    glm::mat4 matrix(1);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0);
        axis[i] = 1;
        matrix[i] = glm::vec4(axis - 2 * n[i] / square * n, 0);
    }
    matrix[3] = glm::vec4(-2 * double{plane.w} / square * n, 1);
    return matrix;
}

glm::mat4 mirrored_view(const glm::mat4& view, const glm::vec4& plane)
{
    return glm::mat4(glm::dmat4(view) * glm::dmat4(mirror_matrix(plane)));
}

std::vector<MirrorView> mirror_views(const glm::vec3& eye, const std::vector<FlatPolygon>& mirrors, int levels)
{
    std::vector<MirrorView> views;
    views_from(eye, mirrors, {}, levels, views);
    return views;
}

}
