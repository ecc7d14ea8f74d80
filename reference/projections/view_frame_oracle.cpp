#include <umbral/projections/view_frame.hpp>

#include <cmath>
#include <numbers>

// With at least 64 bits, rounded to float once. Gram-Schmidt instead of the cross product u×n, and rotations one after
// the other instead of formulas for the axes: other ways to the same answers.

namespace umbral::projections {
namespace {

using Wide = long double;
using WideVector = glm::vec<3, Wide>;

Wide size_of(const WideVector& v) { return std::sqrt(dot(v, v)); }

/// Turns the plane of two coordinates by an angle: the first one towards the second.
WideVector turned(WideVector v, int first, int second, Wide degrees)
{
    const Wide angle = std::remainder(degrees, Wide(360)) * std::numbers::pi_v<Wide> / 180;
    const Wide a = v[first];
    const Wide b = v[second];
    v[first] = std::cos(angle) * a - std::sin(angle) * b;
    v[second] = std::sin(angle) * a + std::cos(angle) * b;
    return v;
}

}

std::optional<ViewFrame> view_frame(const ViewParameters& view)
{
    const WideVector n(view.normal);
    const WideVector u(view.up);
    if (dot(n, n) == 0 || dot(u, u) == 0) return std::nullopt;
    const WideVector z = n / size_of(n);
    const WideVector direction = u / size_of(u);
    WideVector rest = direction - dot(direction, z) * z;
    if (size_of(rest) < Wide(1e-6L)) return std::nullopt;
    rest /= size_of(rest);
    rest -= dot(rest, z) * z;  // what rounding left along z
    const WideVector y = rest / size_of(rest);
    const WideVector origin = WideVector(view.target) + n;
    return ViewFrame{glm::vec3(cross(y, z)), glm::vec3(y), glm::vec3(z), glm::vec3(origin)};
}

ViewParameters view_from(const glm::vec3& target, float distance, float azimuth_degrees, float elevation_degrees,
                         float roll_degrees)
{
    // In the camera's own coordinates, then rolled about z, raised about x, and turned about y.
    const auto placed = [&](WideVector v) {
        v = turned(v, 0, 1, -Wide(roll_degrees));
        v = turned(v, 2, 1, elevation_degrees);
        return turned(v, 2, 0, azimuth_degrees);
    };
    return {target, glm::vec3(placed({0, 1, 0})), glm::vec3(Wide(distance) * placed({0, 0, 1}))};
}

}
