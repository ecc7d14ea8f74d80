// alternative: the product of two matrices; the direction as what the inverse of the shear makes of -z
#include <stdexcept>
#include <umbral/projections/oblique.hpp>

namespace umbral::projections {
namespace {

constexpr double pi = 3.14159265358979323846;

glm::dmat4 wide_shear(const Lean& lean)
{
    glm::dmat4 shear(1.0);
    shear[2][0] = -lean.foreshortening * std::cos(lean.angle_degrees / 180.0 * pi);
    shear[2][1] = -lean.foreshortening * std::sin(lean.angle_degrees / 180.0 * pi);
    return shear;
}

}

float foreshortening_of(float alpha_degrees)
{
    const bool possible = alpha_degrees > 0 && alpha_degrees <= 90;
    if (!possible) throw std::invalid_argument("foreshortening_of: angle");
    if (alpha_degrees == 90) return 0;
    return static_cast<float>(1 / std::tan(alpha_degrees / 180.0 * pi));
}

glm::mat4 oblique_shear(const Lean& lean) { return glm::mat4(wide_shear(lean)); }

glm::mat4 oblique_matrix(const ViewVolume& box, const Lean& lean)
{
    glm::dmat4 scaling(1.0);
    scaling[0][0] = 2 / (double{box.right} - box.left);
    scaling[1][1] = 2 / (double{box.top} - box.bottom);
    scaling[2][2] = 2 / (double{box.near_plane} - box.far_plane);
    glm::dmat4 translation(1.0);
    translation[3] = {-0.5 * (double{box.left} + box.right), -0.5 * (double{box.bottom} + box.top),
                      0.5 * (double{box.near_plane} + box.far_plane), 1};
    return glm::mat4(scaling * translation * wide_shear(lean));
}

glm::vec3 projector_direction(const Lean& lean)
{
    const glm::dvec4 ray = glm::inverse(wide_shear(lean)) * glm::dvec4(0, 0, -1, 0);
    return glm::vec3(glm::normalize(glm::dvec3(ray)));
}

}
