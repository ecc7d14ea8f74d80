// alternative: first a unit vector in the camera's coordinates, whose cosine with the axis gives the interval
#include <cmath>
#include <umbral/interaction/pick_ray.hpp>

namespace umbral::interaction {
namespace {

// The cell of a row of `cells` equal ones over [0, length) that a place lies in, or -1.
int cell_of(double place, int length, int cells)
{
    if (length < 1 || cells < 1 || std::isnan(place) || place < 0 || place >= length) return -1;
    return int(place * cells / length);
}

double between(double from, double to, int index, int count) { return from + (to - from) * (index + 0.5) / count; }

}

std::optional<glm::ivec2> pick_pixel(const glm::dvec2& cursor, const glm::ivec2& window, const glm::ivec2& framebuffer)
{
    const glm::ivec2 pixel(cell_of(cursor.x, window.x, framebuffer.x), cell_of(cursor.y, window.y, framebuffer.y));
    if (pixel.x < 0 || pixel.y < 0) return {};
    return pixel;
}

Ray pick_ray(const PickView& view, const glm::ivec2& pixel)
{
    const projections::ViewVolume& frustum = view.frustum;
    glm::dvec3 aim(between(frustum.left, frustum.right, pixel.x, view.picture.x),
                   between(frustum.top, frustum.bottom, pixel.y, view.picture.y), -frustum.near_plane);
    aim /= std::sqrt(aim.x * aim.x + aim.y * aim.y + aim.z * aim.z);
    const glm::dmat3 axes(view.frame.x, view.frame.y, view.frame.z);
    const double cosine = -aim.z;
    return Ray{view.frame.origin, glm::vec3(axes * aim), float(frustum.near_plane / cosine),
               float(frustum.far_plane / cosine)};
}

}
