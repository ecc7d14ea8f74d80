#include <umbral/projections/fit.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

// With at least 64 bits, rounded to float once. The sphere's window by the circle of points where rays from the eye
// touch it, the field of view by the angle that is left to 180°.

namespace umbral::projections {
namespace {

using Wide = long double;

void require(bool condition)
{
    if (!condition) throw std::invalid_argument("nothing to fit");
}

ViewVolume volume_of(Wide half, const PictureSize& picture, Wide near_plane, Wide far_plane)
{
    const int shorter = std::min(picture.width, picture.height);
    const auto x = static_cast<float>(half * picture.width / shorter);
    const auto y = static_cast<float>(half * picture.height / shorter);
    return {-x, x, -y, y, static_cast<float>(near_plane), static_cast<float>(far_plane)};
}

bool has_pixels(const PictureSize& picture) { return picture.width > 0 && picture.height > 0; }

}

ViewVolume fit_cube(float side, float distance, const PictureSize& picture)
{
    const Wide half = Wide(side) / 2;
    require(has_pixels(picture) && side > 0 && Wide(distance) > half);
    return volume_of(half, picture, distance - half, distance + half);
}

// The circle has the radius r √(1 - s²) and lies r s before the middle, with s = r / D; 1 - s = (D - r) / D.
ViewVolume fit_sphere(float radius, float distance, const PictureSize& picture)
{
    require(has_pixels(picture) && radius > 0 && distance > radius);
    const Wide r = radius;
    const Wide d = distance;
    const Wide cosine = std::sqrt((d - r) / d * ((d + r) / d));
    const Wide circle_distance = (d - r) / d * (d + r);
    return volume_of(r * cosine * ((d - r) / circle_distance), picture, d - r, d + r);
}

PlacedVolume fit_cube_to_fovy(const glm::vec3& centre, float side, float fovy_degrees, const PictureSize& picture)
{
    require(has_pixels(picture) && side > 0 && fovy_degrees > 0 && fovy_degrees < 180);
    const Wide rest = (180 - Wide(fovy_degrees)) * std::numbers::pi_v<Wide> / 360;
    const Wide shorter = std::min(picture.width, picture.height);
    const Wide near_plane = Wide(side) / 2 * picture.height / shorter * (std::sin(rest) / std::cos(rest));
    const Wide eye_z = centre.z + Wide(side) / 2 + near_plane;
    return {{centre.x, centre.y, static_cast<float>(eye_z)},
            volume_of(Wide(side) / 2, picture, near_plane, near_plane + side)};
}

}
