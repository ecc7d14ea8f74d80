#include <cmath>

#include "render/fields/shapes.hpp"

namespace umbral::render::fields {
namespace {

constexpr int iterations = 9;
constexpr double size = 0.78;        ///< the set reaches to about 1.2
constexpr double thickness = 0.006;  ///< what is nearer than that belongs to the solid

double squared(double x) { return x * x; }

/// Of a complex number.
glm::dvec2 to_the_eighth(glm::dvec2 z)
{
    for (int i = 0; i < 3; ++i) z = {z.x * z.x - z.y * z.y, 2 * z.x * z.y};
    return z;
}

/// z^8: the distance to the eighth power, longitude and latitude eight times as large.
glm::dvec3 to_the_eighth(const glm::dvec3& z, double distance)
{
    const double eighth = squared(squared(squared(distance)));
    const double across = length(glm::dvec2(z));
    if (across == 0) return {eighth, 0, 0};  // eight times 90 degrees, at longitude 0
    const glm::dvec2 longitude = to_the_eighth(glm::dvec2(z) / across);
    const glm::dvec2 latitude = to_the_eighth(glm::dvec2(across, z.z) / distance);
    return eighth * glm::dvec3(latitude.x * longitude, latitude.y);
}

}

double mandelbulb(const glm::dvec3& place)
{
    // Turned so that its axis stands upright.
    const glm::dvec3 c = glm::dvec3(place.x, -place.z, place.y) / size;
    glm::dvec3 z = c;
    double slope = 1;
    for (int i = 0; i < iterations; ++i) {
        const double distance = length(z);
        // The estimate that Hubbard and Douady's potential gives.
        if (distance > 4) return size * 0.5 * std::log(distance) * distance / slope - thickness;
        if (distance == 0) break;
        slope = 8 * squared(squared(distance)) * squared(distance) * distance * slope + 1;
        z = to_the_eighth(z, distance) + c;
    }
    const double distance = length(z);
    return (distance > 1 ? size * 0.5 * std::log(distance) * distance / slope : 0) - thickness;
}

}
