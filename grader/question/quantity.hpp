#pragma once

#include <string_view>

namespace umbral::grader {

/// What a number or a vector of a question measures, as far as its name tells: no angle is less than a length, and no
/// direction or colour lies near a place, though some numbers say so by chance.
enum class Quantity {
    unknown,    ///< a length, a place, a count, …
    angle,      ///< "fovy_degrees", "camera.azimuth"
    direction,  ///< "ray.direction", "plane.normal"
    light,      ///< "material.emission", "global_ambient": colours lie nowhere
    screen,     ///< "viewport.width": a number of pixels
    depth,      ///< "viewport.near_depth", "z_far"
    index,      ///< "material.index": which of several, or a material's number
};

/// By the words of the name's last part: "fovy" and "degrees" of "camera.fovy_degrees".
[[nodiscard]] Quantity quantity_of(std::string_view name);

}
