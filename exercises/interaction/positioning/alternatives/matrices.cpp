// alternative: matrices throughout, as the course's M = inverse(O) inverse(D), and a plane through pixel and pencil
#include <cmath>
#include <complex>
#include <umbral/interaction/positioning.hpp>

namespace umbral::interaction {

namespace {

/// From pixels to normalised device coordinates: the inverse of the device matrix.
glm::dmat3 inverse_device(glm::ivec2 size)
{
    const double w = size.x, h = size.y;
    return glm::dmat3(2 / w, 0, 0, 0, -2 / h, 0, 1 / w - 1, 1 - 1 / h, 1);
}

glm::dmat3 inverse_orthographic(const ViewLimits& v)
{
    return glm::dmat3((v.right - v.left) / 2, 0, 0, 0, (v.top - v.bottom) / 2, 0, (v.right + v.left) / 2,
                      (v.top + v.bottom) / 2, 1);
}

glm::dmat3 axes(LinkedView view)
{
    switch (view) {
        case LinkedView::top: return {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
        case LinkedView::side: return {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
        default: return glm::dmat3(1);
    }
}

}

std::optional<glm::ivec2> cursor_pixel(glm::dvec2 cursor, glm::ivec2 window, glm::ivec2 framebuffer)
{
    for (int i = 0; i < 2; ++i)
        if (window[i] < 1 || framebuffer[i] < 1) return std::nullopt;
    glm::ivec2 pixel;
    for (int i = 0; i < 2; ++i) {
        const double place = cursor[i] * framebuffer[i] / window[i];
        pixel[i] = static_cast<int>(place);
        if (place < pixel[i]) --pixel[i];
    }
    return pixel;
}

glm::dvec2 pixel_in_world(glm::ivec2 pixel, const ViewLimits& limits, glm::ivec2 size)
{
    return glm::dvec2(inverse_orthographic(limits) * inverse_device(size) * glm::dvec3(pixel, 1));
}

std::optional<glm::dvec3> point_on_plane(glm::ivec2 pixel, glm::ivec2 size, const glm::mat4& view,
                                         const glm::mat4& projection, const SnapPlane& plane)
{
    // Planes go by the inverse transpose: the plane in clip space gives the depth at once.
    const glm::dmat4 m = glm::dmat4(projection) * glm::dmat4(view);
    const glm::dmat4 back = glm::inverse(m);
    const glm::dvec4 p = glm::transpose(back) * glm::dvec4(plane.normal, -plane.offset);
    const glm::dvec3 ndc = inverse_device(size) * glm::dvec3(pixel, 1);
    const double rest = p.x * ndc.x + p.y * ndc.y + p.w;
    // (ndc.x, ndc.y, depth, 1) lies in the plane if rest + p.z depth = 0; both scaled by p.z.
    const glm::dvec4 world = back * glm::dvec4(p.z * ndc.x, p.z * ndc.y, -rest, p.z);
    const glm::dvec4 a = back * glm::dvec4(ndc.x, ndc.y, -1, 1);
    const glm::dvec4 b = back * glm::dvec4(ndc.x, ndc.y, 1, 1);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(b) / b.w - glm::dvec3(a) / a.w);
    if (std::abs(glm::dot(direction, glm::normalize(plane.normal))) <= 1e-9) return std::nullopt;
    const glm::dvec3 place = glm::dvec3(world) / world.w;
    if ((m * glm::dvec4(place, 1)).w <= 0) return std::nullopt;
    return place;
}

glm::dvec3 moved_cursor(const glm::dvec3& cursor, glm::dvec2 motion, unsigned buttons, const ViewLimits& v,
                        glm::ivec2 size)
{
    const glm::dvec2 way = motion / glm::dvec2(size) * glm::dvec2(v.right - v.left, v.bottom - v.top);
    const bool left = buttons & 1, right = buttons & 2;
    const glm::dmat2x3 plane = right ? glm::dmat2x3(1, 0, 0, 0, 0, -1) : glm::dmat2x3(1, 0, 0, 0, 1, 0);
    return left || right ? cursor + plane * way : cursor;
}

glm::dvec2 cursor_in_view(LinkedView view, const glm::dvec3& cursor) { return glm::dvec2(axes(view) * cursor); }

glm::dvec3 cursor_from_view(LinkedView view, glm::dvec2 place, const glm::dvec3& cursor)
{
    const glm::dmat3 turn = axes(view);
    return glm::transpose(turn) * glm::dvec3(place, (turn * cursor).z);
}

std::optional<double> entered_angle(glm::dvec2 reference, glm::dvec2 cursor)
{
    const glm::dvec2 way = cursor - reference;
    if (way.x == 0 && way.y == 0) return {};
    return std::arg(std::complex<double>(way.x, 0 - way.y));
}

}
