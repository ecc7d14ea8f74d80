#pragma once

#include <umbral/lighting/brightest_point.hpp>

#include "../highlights.hpp"

/// Questions about a sphere that a light and an eye see from outside.
namespace umbral::lighting {

struct LitSphere {
    Sphere sphere;
    Light light;
    glm::vec3 eye{0};
};

/// A sphere with the light and the eye that many radii from its centre; the light is a direction for 0.
///
/// `share` is the angle between the two, in shares of the one from which on they see no part of the sphere in common.
inline LitSphere lit_sphere(Random& random, const Sphere& sphere, float share, float light_radii, float eye_radii)
{
    const bool is_place = light_radii > 0;
    const double limit =
        std::acos(1 / double{eye_radii}) + (is_place ? std::acos(1 / double{light_radii}) : std::acos(0.0));
    const glm::dvec3 to_eye(random.unit_vector());
    const glm::dvec3 aside = normalize(cross(to_eye, glm::dvec3(random.unit_vector())));
    const glm::dvec3 to_light = std::cos(share * limit) * to_eye + std::sin(share * limit) * aside;
    const glm::dvec3 centre(sphere.centre);
    const double radius = sphere.radius;
    const glm::vec4 position = is_place ? glm::vec4(glm::vec3(centre + light_radii * radius * to_light), 1)
                                        : glm::vec4(glm::vec3(to_light), 0);
    return {sphere, {position}, glm::vec3(centre + eye_radii * radius * to_eye)};
}

/// A sphere somewhere, the eye at 1.3 to 6 radii; the light too, or a direction: one or the other if `is_place` is not
/// 0 or 1.
inline LitSphere random_lit_sphere(Random& random, float share, int is_place = 2)
{
    const glm::vec3 centre = 3.0F * random.in_cube();
    const float radius = random.uniform(0.5F, 2);
    const bool place = is_place == 2 ? random.below(2) == 0 : is_place == 1;
    const float light_radii = place ? random.uniform(1.3F, 6) : 0;
    return lit_sphere(random, {centre, radius}, share, light_radii, random.uniform(1.3F, 6));
}

}
