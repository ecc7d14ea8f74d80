#include <umbral/raytracing/cylinder_cone.hpp>

namespace umbral::raytracing {

float unit_cylinder_field(const glm::vec3& p)
{
    // TODO: a number that is 0 where p is as far from the y axis as the cylinder is wide: x² + z² - 1.
    return not_implemented<float>(p);
}

float unit_cone_field(const glm::vec3& p)
{
    // TODO: the same for the cone, whose radius at the height y is 1 - y.
    return not_implemented<float>(p);
}

std::optional<float> intersect_unit_cylinder(const Ray& ray)
{
    // TODO: put origin + t * direction into the cylinder's field: a quadratic equation in t. Of its roots, return the
    // smallest that lies strictly between ray.t_min and ray.t_max, and whose point has a height from 0 to 1.
    return not_implemented<std::optional<float>>(ray);
}

std::optional<float> intersect_unit_cone(const Ray& ray)
{
    // TODO: as for the cylinder, with the cone's field. What becomes of the equation if the coefficient of t² is 0?
    return not_implemented<std::optional<float>>(ray);
}

}
