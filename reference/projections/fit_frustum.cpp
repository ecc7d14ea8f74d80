// Based on: the course's problems 3.5 to 3.8.

#include <umbral/projections/fit.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace umbral::projections {
namespace {

/// Half the sizes of a window.
struct Window {
    double half_width;
    double half_height;
};

// The smallest window of the picture's shape that holds a square: the shorter side decides.
Window round_square(double half, const PictureSize& picture)
{
    const double aspect = double(picture.width) / picture.height;
    return aspect >= 1 ? Window{half * aspect, half} : Window{half, half / aspect};
}

ViewVolume volume_of(const Window& window, double near_plane, double far_plane)
{
    const auto x = static_cast<float>(window.half_width);
    const auto y = static_cast<float>(window.half_height);
    return {-x, x, -y, y, static_cast<float>(near_plane), static_cast<float>(far_plane)};
}

void require(bool condition, const char* what)
{
    if (!condition) throw std::invalid_argument(what);
}

void require_picture(const PictureSize& picture)
{
    require(picture.width > 0 && picture.height > 0, "a picture has pixels");
}

}

// The front face decides: it is as large as the others, and nearer.
ViewVolume fit_cube(float side, float distance, const PictureSize& picture)
{
    require_picture(picture);
    const double half = 0.5 * side;
    require(half > 0 && distance > half, "the eye lies outside of a cube that has a size");
    return volume_of(round_square(half, picture), distance - half, distance + half);
}

// A ray that touches makes an angle with the axis whose sine is radius / distance. Its tangent times the near plane's
// distance D - r is r √((D - r) / (D + r)), with no difference of squares.
ViewVolume fit_sphere(float radius, float distance, const PictureSize& picture)
{
    require_picture(picture);
    require(radius > 0 && distance > radius, "the eye lies outside of a sphere that has a size");
    const double nearest = double{distance} - radius;
    const double farthest = double{distance} + radius;
    return volume_of(round_square(radius * std::sqrt(nearest / farthest), picture), nearest, farthest);
}

PlacedVolume fit_cube_to_fovy(const glm::vec3& centre, float side, float fovy_degrees, const PictureSize& picture)
{
    require_picture(picture);
    require(side > 0, "a cube has a size");
    require(fovy_degrees > 0 && fovy_degrees < 180, "a field of view lies between 0 and 180 degrees");
    const Window window = round_square(0.5 * side, picture);
    const double near_plane = window.half_height / std::tan(fovy_degrees * (std::numbers::pi / 360));
    const auto eye_z = static_cast<float>(centre.z + 0.5 * side + near_plane);
    return {{centre.x, centre.y, eye_z}, volume_of(window, near_plane, near_plane + side)};
}

}
