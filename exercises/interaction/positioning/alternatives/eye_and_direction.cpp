// alternative: the ray begins at the near plane, and t comes from the plane; everything component by component
#include <algorithm>
#include <cmath>
#include <umbral/interaction/positioning.hpp>

namespace umbral::interaction {

std::optional<glm::ivec2> cursor_pixel(glm::dvec2 cursor, glm::ivec2 window_size, glm::ivec2 framebuffer_size)
{
    if (window_size.x <= 0 || window_size.y <= 0 || framebuffer_size.x <= 0 || framebuffer_size.y <= 0) return {};
    const double sx = double(framebuffer_size.x) / window_size.x;
    const double sy = double(framebuffer_size.y) / window_size.y;
    return glm::ivec2(int(std::floor(cursor.x * sx)), int(std::floor(cursor.y * sy)));
}

glm::dvec2 pixel_in_world(glm::ivec2 pixel, const ViewLimits& v, glm::ivec2 size)
{
    const double dx = (v.right - v.left) / size.x;
    const double dy = (v.top - v.bottom) / size.y;
    return {v.left + dx * pixel.x + dx / 2, v.top - dy * pixel.y - dy / 2};
}

std::optional<glm::dvec3> point_on_plane(glm::ivec2 pixel, glm::ivec2 size, const glm::mat4& view,
                                         const glm::mat4& projection, const SnapPlane& plane)
{
    const glm::dmat4 inverse_view = glm::inverse(glm::dmat4(view));
    const glm::dmat4 inverse_projection = glm::inverse(glm::dmat4(projection));
    auto unproject = [&](double depth) {
        glm::dvec4 p((2.0 * pixel.x + 1) / size.x - 1, 1 - (2.0 * pixel.y + 1) / size.y, depth, 1);
        p = inverse_projection * p;
        p /= p.w;
        return glm::dvec3(inverse_view * p);
    };
    const glm::dvec3 begin = unproject(-1);
    const glm::dvec3 direction = glm::normalize(unproject(0.5) - begin);
    const glm::dvec3 n = glm::normalize(plane.normal);
    const double speed = glm::dot(n, direction);
    if (std::fabs(speed) < 1e-9) return std::nullopt;
    const double t = (plane.offset / glm::length(plane.normal) - glm::dot(n, begin)) / speed;
    const glm::dvec3 p = begin + t * direction;
    const glm::dvec4 seen = glm::dmat4(view) * glm::dvec4(p, 1);
    const bool perspective = projection[2][3] != 0;
    if (perspective && seen.z >= 0) return std::nullopt;
    return p;
}

glm::dvec3 moved_cursor(const glm::dvec3& cursor, glm::dvec2 motion, unsigned buttons, const ViewLimits& v,
                        glm::ivec2 size)
{
    glm::dvec3 result = cursor;
    if (buttons % 4 == 0) return result;
    result.x += motion.x / size.x * (v.right - v.left);
    const double step = motion.y / size.y * (v.top - v.bottom);
    if (buttons % 4 == 1)
        result.y -= step;
    else
        result.z += step;
    return result;
}

glm::dvec2 cursor_in_view(LinkedView view, const glm::dvec3& c)
{
    if (view == LinkedView::front) return glm::dvec2(c);
    return view == LinkedView::top ? glm::dvec2(c.x, -c.z) : glm::dvec2(-c.z, c.y);
}

glm::dvec3 cursor_from_view(LinkedView view, glm::dvec2 p, const glm::dvec3& c)
{
    glm::dvec3 result = c;
    if (view != LinkedView::side) result.x = p.x;
    if (view != LinkedView::top) result.y = p.y;
    if (view == LinkedView::top) result.z = -p.y;
    if (view == LinkedView::side) result.z = -p.x;
    return result;
}

std::optional<double> entered_angle(glm::dvec2 reference, glm::dvec2 cursor)
{
    const double x = cursor.x - reference.x;
    const double y = reference.y - cursor.y;
    if (x == 0 && y == 0) return std::nullopt;
    const double angle = std::acos(std::clamp(x / std::hypot(x, y), -1.0, 1.0));
    return std::abs(y) < 1e-3 * std::abs(x) ? std::atan2(y, x) : (y < 0 ? -angle : angle);
}

}
