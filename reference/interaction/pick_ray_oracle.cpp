#include <umbral/interaction/pick_ray.hpp>

#include "../wide.hpp"

// The corners of the near plane in world coordinates, and between them the pixel's centre, with 113 bits, rounded to
// float once; the pixel by whole numbers.
// Based on: A. S. Glassner (ed.). An Introduction to Ray Tracing. 1989, chapter 2.

namespace umbral::interaction {
namespace {

/// A pixel counts from 0 to size - 1; -1 stands for none. The first one whose right border lies beyond the cursor.
int pixel_along(double cursor, int window, int framebuffer)
{
    if (!(cursor >= 0)) return -1;
    const Wide place = Wide(cursor) * framebuffer;
    int low = 0;
    int high = framebuffer;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (place < (Wide(middle) + 1) * window)
            high = middle;
        else
            low = middle + 1;
    }
    return low < framebuffer ? low : -1;
}

}

std::optional<glm::ivec2> pick_pixel(const glm::dvec2& cursor, const glm::ivec2& window, const glm::ivec2& framebuffer)
{
    for (int axis = 0; axis < 2; ++axis)
        if (window[axis] <= 0 || framebuffer[axis] <= 0) return std::nullopt;
    const int column = pixel_along(cursor.x, window.x, framebuffer.x);
    const int row = pixel_along(cursor.y, window.y, framebuffer.y);
    if (column < 0 || row < 0) return std::nullopt;
    return glm::ivec2(column, row);
}

Ray pick_ray(const PickView& view, const glm::ivec2& pixel)
{
    const auto& [left, right, bottom, top, near_plane, far_plane] = view.frustum;
    // Twice the pixel's place and size, so that all weights are whole numbers.
    const Wide across = Wide(2) * pixel.x + 1;
    const Wide down = Wide(2) * pixel.y + 1;
    const Wide width = Wide(2) * view.picture.x;
    const Wide height = Wide(2) * view.picture.y;
    const Wide in_camera[] = {((width - across) * left + across * right) / width,
                              ((height - down) * top + down * bottom) / height, -Wide(near_plane)};

    Wide to_near[3];
    Wide squares = 0;
    for (int i = 0; i < 3; ++i) {
        to_near[i] = in_camera[0] * view.frame.x[i] + in_camera[1] * view.frame.y[i] + in_camera[2] * view.frame.z[i];
        squares += to_near[i] * to_near[i];
    }
    const Wide distance = square_root(squares);
    Ray ray{view.frame.origin};
    for (int i = 0; i < 3; ++i) ray.direction[i] = static_cast<float>(to_near[i] / distance);
    ray.t_min = static_cast<float>(distance);
    ray.t_max = static_cast<float>(distance * far_plane / near_plane);
    return ray;
}

}
