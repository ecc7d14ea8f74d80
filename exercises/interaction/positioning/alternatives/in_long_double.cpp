// alternative: cases and tables; the line through two points at other depths, in long double
#include <array>
#include <cmath>
#include <umbral/interaction/positioning.hpp>
#include <utility>

namespace umbral::interaction {

using real = long double;
using vec4 = glm::vec<4, real>;
using vec3 = glm::vec<3, real>;
using mat4 = glm::mat<4, 4, real>;

std::optional<glm::ivec2> cursor_pixel(glm::dvec2 cursor, glm::ivec2 window_size, glm::ivec2 framebuffer_size)
{
    if (!window_size.x || !window_size.y || !framebuffer_size.x || !framebuffer_size.y) return std::nullopt;
    const auto index = [](double c, real pixels, real points) { return (int)std::floor(c * pixels / points); };
    return std::optional<glm::ivec2>(std::in_place, index(cursor.x, framebuffer_size.x, window_size.x),
                                     index(cursor.y, framebuffer_size.y, window_size.y));
}

glm::dvec2 pixel_in_world(glm::ivec2 pixel, const ViewLimits& limits, glm::ivec2 viewport_size)
{
    const real s = (pixel.x + real(0.5)) / viewport_size.x;
    const real t = (pixel.y + real(0.5)) / viewport_size.y;
    return {(1 - s) * limits.left + s * limits.right, (1 - t) * limits.top + t * limits.bottom};
}

std::optional<glm::dvec3> point_on_plane(glm::ivec2 pixel, glm::ivec2 size, const glm::mat4& view,
                                         const glm::mat4& projection, const SnapPlane& plane)
{
    const mat4 all = mat4(projection) * mat4(view);
    const mat4 inverse = glm::inverse(all);
    const real x = 2 * (pixel.x + real(0.5)) / size.x - 1;
    const real y = -(2 * (pixel.y + real(0.5)) / size.y - 1);
    std::array<vec3, 2> ends;
    for (int i = 0; i < 2; ++i) {
        const vec4 end = inverse * vec4(x, y, i == 0 ? real(-0.9) : real(0.2), 1);
        ends[i] = vec3(end) / end.w;
    }
    const vec3 n(plane.normal);
    const std::array<real, 2> away = {glm::dot(n, ends[0]) - plane.offset, glm::dot(n, ends[1]) - plane.offset};
    const real slope = away[0] - away[1];
    if (std::abs(slope) <= 1e-9L * glm::length(n) * glm::length(ends[1] - ends[0])) return std::nullopt;
    const vec3 place = (away[0] * ends[1] - away[1] * ends[0]) / slope;
    if ((all * vec4(place, 1)).w > 0) return glm::dvec3(place);
    return std::nullopt;
}

glm::dvec3 moved_cursor(const glm::dvec3& cursor, glm::dvec2 motion, unsigned buttons, const ViewLimits& limits,
                        glm::ivec2 window_size)
{
    const glm::dvec2 unit((limits.right - limits.left) / window_size.x, (limits.top - limits.bottom) / window_size.y);
    switch (buttons & 3u) {
        case 0: return cursor;
        case 1: return {cursor.x + unit.x * motion.x, cursor.y - unit.y * motion.y, cursor.z};
        default: return {cursor.x + unit.x * motion.x, cursor.y, cursor.z + unit.y * motion.y};
    }
}

glm::dvec2 cursor_in_view(LinkedView view, const glm::dvec3& cursor)
{
    const glm::dvec2 all[] = {{cursor.x, cursor.y}, {cursor.x, -cursor.z}, {-cursor.z, cursor.y}};
    return all[static_cast<int>(view)];
}

glm::dvec3 cursor_from_view(LinkedView view, glm::dvec2 place, const glm::dvec3& cursor)
{
    const glm::dvec3 all[] = {
        {place.x, place.y, cursor.z}, {place.x, cursor.y, -place.y}, {cursor.x, place.y, -place.x}};
    return all[static_cast<int>(view)];
}

std::optional<double> entered_angle(glm::dvec2 reference, glm::dvec2 cursor)
{
    if (reference.x == cursor.x && reference.y == cursor.y) return std::nullopt;
    const double angle = -std::atan2(cursor.y - reference.y, cursor.x - reference.x);
    const double pi = std::acos(-1.0);
    return angle <= -pi ? pi : angle;
}

}
