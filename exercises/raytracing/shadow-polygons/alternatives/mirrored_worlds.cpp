// alternative: the eye stays and the world is mirrored; a stack instead of recursion; all cuts from one list of planes
#include <algorithm>
#include <functional>
#include <umbral/raytracing/shadow_polygons.hpp>

namespace umbral::raytracing {
namespace {

using Points = std::vector<glm::dvec3>;

struct Plane {
    glm::dvec3 n{0};
    double d = 0;

    double operator()(const glm::dvec3& p) const { return glm::dot(n, p) + d; }
    Plane flipped() const { return {-n, -d}; }
};

Plane plane_at(const glm::dvec3& normal, const glm::dvec3& point)
{
    const glm::dvec3 n = glm::normalize(normal);
    return {n, -glm::dot(n, point)};
}

// Newell's sum.
glm::dvec3 newell(const Points& points)
{
    glm::dvec3 sum(0);
    const glm::dvec3 origin = points.front();
    for (std::size_t i = 0; i < points.size(); ++i)
        sum += glm::cross(points[i] - origin, points[(i + 1) % points.size()] - origin);
    return sum;
}

Plane plane_of(const Points& points) { return plane_at(newell(points), points.front()); }

Points cut(Points points, const std::vector<Plane>& planes)
{
    for (const Plane& plane : planes) {
        Points left;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec3 a = points[i];
            const glm::dvec3 b = points[(i + 1) % points.size()];
            const double at_a = plane(a);
            const double at_b = plane(b);
            if (at_a >= 0) left.push_back(a);
            if (at_a * at_b < 0) left.push_back(glm::mix(a, b, at_a / (at_a - at_b)));
        }
        points = left;
    }
    return points;
}

// Planes through a lamp or along a sun's direction, and the sides of a polygon; its inside is positive.
std::vector<Plane> sides(const Points& polygon, const std::function<glm::dvec3(const glm::dvec3&)>& towards_source)
{
    glm::dvec3 middle(0);
    for (const glm::dvec3& p : polygon) middle += p / static_cast<double>(polygon.size());
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = polygon[i];
        Plane plane = plane_at(glm::cross(polygon[(i + 1) % polygon.size()] - a, towards_source(a)), a);
        planes.push_back(plane(middle) < 0 ? plane.flipped() : plane);
    }
    return planes;
}

FlatPolygon finished(const Points& points)
{
    FlatPolygon result;
    for (const glm::dvec3& p : points)
        if (std::count(result.begin(), result.end(), glm::vec3(p)) == 0) result.emplace_back(p);
    double size = 0;
    for (const glm::dvec3& p : points) size = std::max(size, glm::distance(p, points.front()));
    if (result.size() < 3 || glm::length(newell(points)) < 1e-8 * size * size) return {};
    return result;
}

Points points_of(const FlatPolygon& polygon) { return {polygon.begin(), polygon.end()}; }

struct World {
    glm::dmat4 matrix{1};
    std::vector<std::size_t> path;
    Points window;  // where it seems to be
};

glm::dmat4 reflection(const Plane& plane)
{
    glm::dmat4 m(1);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) m[column][row] -= 2 * plane.n[row] * (column < 3 ? plane.n[column] : plane.d);
    return m;
}

Points moved(const glm::dmat4& matrix, const Points& points)
{
    Points result;
    for (const glm::dvec3& p : points) result.emplace_back(matrix * glm::dvec4(p, 1));
    return result;
}

}

FlatPolygon shadow_polygon(const glm::vec4& light, const FlatPolygon& caster, const FlatPolygon& receiver)
{
    if (std::min(caster.size(), receiver.size()) < 3) return {};
    const Points ground = points_of(receiver);
    Plane floor = plane_of(ground);
    const glm::dvec3 source(light);
    const bool lamp = light.w != 0;
    const double height = lamp ? floor(source) : glm::dot(floor.n, source);
    if (height == 0) return {};
    if (height < 0) floor = floor.flipped();
    double highest = 0;
    for (const glm::vec3& p : caster) highest = std::max(highest, floor(p));
    if (highest == 0) return {};
    const auto towards = [&](const glm::dvec3& p) { return lamp ? source - p : source; };
    std::vector<Plane> planes = sides(ground, towards);
    planes.push_back(floor);
    Points points = cut(points_of(caster), planes);
    for (glm::dvec3& p : points) {
        const glm::dvec3 ray = -towards(p);
        p += ray * (floor(p) / -glm::dot(floor.n, ray));
    }
    FlatPolygon shadow = finished(points);
    if (!shadow.empty() && glm::dot(newell(points), newell(ground)) < 0) std::reverse(shadow.begin(), shadow.end());
    return shadow;
}

glm::mat4 mirror_matrix(const glm::vec4& plane)
{
    const double size = glm::length(glm::dvec3(plane));
    return glm::mat4(reflection({glm::dvec3(plane) / size, double{plane.w} / size}));
}

glm::mat4 mirrored_view(const glm::mat4& view, const glm::vec4& plane) { return view * mirror_matrix(plane); }

std::vector<MirrorView> mirror_views(const glm::vec3& eye, const std::vector<FlatPolygon>& mirrors, int levels)
{
    const glm::dvec3 from(eye);
    std::vector<MirrorView> views;
    std::vector<World> stack{World{}};
    while (!stack.empty()) {
        const World world = stack.back();
        stack.pop_back();
        const glm::dmat4 back = glm::inverse(world.matrix);
        if (!world.path.empty()) {
            Points window = moved(back, world.window);
            const glm::dvec3 there(back * glm::dvec4(from, 1));
            views.push_back({world.path, glm::vec3(there), finished(window)});
        }
        if (static_cast<int>(world.path.size()) >= levels) continue;
        for (std::size_t i = mirrors.size(); i-- > 0;) {
            if (mirrors[i].size() < 3) continue;
            const Plane real = plane_of(points_of(mirrors[i]));
            if (real(glm::dvec3(back * glm::dvec4(from, 1))) <= 0) continue;
            Points seen = moved(world.matrix, points_of(mirrors[i]));
            if (!world.path.empty()) {
                std::vector<Plane> planes = sides(world.window, [&](const glm::dvec3& p) { return from - p; });
                const Plane window = plane_of(world.window);
                planes.push_back(window(from) > 0 ? window.flipped() : window);
                seen = cut(seen, planes);
            }
            if (finished(seen).empty()) continue;
            World next{world.matrix * reflection(real), world.path, seen};
            next.path.push_back(i);
            stack.push_back(next);
        }
    }
    return views;
}

}
