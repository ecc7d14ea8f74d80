// alternative: everything from half the angle under which the body is seen
#include <numbers>
#include <stdexcept>
#include <umbral/projections/fit.hpp>

namespace umbral::projections {
namespace {

// Whatever goes to the top of the picture where the picture is square.
ViewVolume widened(double slope, double n, double f, const PictureSize& picture)
{
    double x = slope * n;
    double y = slope * n;
    if (picture.width > picture.height)
        x *= static_cast<double>(picture.width) / picture.height;
    else
        y *= static_cast<double>(picture.height) / picture.width;
    return {static_cast<float>(-x), static_cast<float>(x), static_cast<float>(-y),
            static_cast<float>(y),  static_cast<float>(n), static_cast<float>(f)};
}

void check(const PictureSize& picture, bool fits)
{
    if (picture.width < 1 || picture.height < 1 || !fits) throw std::invalid_argument("cannot be fitted");
}

}

ViewVolume fit_cube(float side, float distance, const PictureSize& picture)
{
    const double half = side / 2.0;
    check(picture, side > 0 && half < distance);
    return widened(half / (distance - half), distance - half, distance + half, picture);
}

ViewVolume fit_sphere(float radius, float distance, const PictureSize& picture)
{
    check(picture, radius > 0 && radius < distance);
    const double d = distance;
    const double angle = std::atan2(double{radius}, std::sqrt((d - radius) * (d + radius)));
    return widened(std::tan(angle), d - radius, d + radius, picture);
}

PlacedVolume fit_cube_to_fovy(const glm::vec3& centre, float side, float fovy_degrees, const PictureSize& picture)
{
    check(picture, side > 0 && fovy_degrees > 0 && fovy_degrees < 180);
    const double slope = std::tan(fovy_degrees / 360.0 * std::numbers::pi);
    const double higher = picture.height > picture.width ? double(picture.height) / picture.width : 1.0;
    const double n = 0.5 * side * higher / slope;
    return {glm::vec3(centre.x, centre.y, centre.z + side / 2.0 + n), widened(0.5 * side / n, n, n + side, picture)};
}

}
