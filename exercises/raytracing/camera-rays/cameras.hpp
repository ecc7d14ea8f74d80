#pragma once

#include <algorithm>
#include <cmath>
#include <umbral/raytracing/camera_rays.hpp>

#include "../rays.hpp"

/// Cameras of all kinds, and places of their pictures.
namespace umbral::raytracing {

inline float power_of_ten(Random& random, float low, float high) { return std::pow(10.0F, random.uniform(low, high)); }

/// A camera that looks at a place in its surroundings, upright or not.
inline PrimaryCamera random_camera(Random& random, const glm::vec3& place, float distance)
{
    PrimaryCamera camera;
    camera.eye = place;
    const glm::dvec3 view = normalize(glm::dvec3(random.unit_vector()));
    camera.target = glm::vec3(glm::dvec3(place) + double{distance} * view);
    const double along = random.uniform(-0.9F, 0.9F);
    camera.up = glm::vec3(along * view + std::sqrt(1 - along * along) * perpendicular_to(view, random));
    camera.fovy = random.uniform(0.3F, 2);
    return camera;
}

/// The camera of most pictures: its up vector is an axis, most often y, or held a little askew, by 1e-4 to 0.1. Some
/// look exactly level, from a place that has a coordinate 0, or at one.
inline PrimaryCamera upright_camera(Random& random, float reach, float distance)
{
    const auto axis = random.below(2) == 0 ? 1 : static_cast<glm::length_t>(random.below(3));
    const float rise = random.below(3) == 0 ? 0.0F : random.uniform(-1.2F, 1.2F);
    const float angle = random.uniform(0, 6.2831853F);
    PrimaryCamera camera;
    camera.eye = reach * random.in_cube();
    const std::uint32_t zero = random.below(8);
    if (zero < 3) camera.eye[static_cast<glm::length_t>(zero)] = 0;
    glm::vec3 view(0);
    view[axis] = std::sin(rise);
    view[(axis + 1) % 3] = std::cos(rise) * std::cos(angle);
    view[(axis + 2) % 3] = std::cos(rise) * std::sin(angle);
    camera.target = camera.eye + distance * view;
    if (random.below(4) == 0) camera.target[static_cast<glm::length_t>(random.below(3))] = 0;
    // A target in one of the planes may have come to lie above the eye, or where it is.
    const glm::vec3 to_target = camera.target - camera.eye;
    if (glm::length(glm::vec2(to_target[(axis + 1) % 3], to_target[(axis + 2) % 3])) < 0.3F * glm::length(to_target) ||
        to_target == glm::vec3(0))
        camera.target = camera.eye + distance * view;
    camera.up = glm::vec3(0);
    camera.up[axis] = random.below(4) == 0 ? -1.0F : 1.0F;
    const float askew = random.below(4) == 0 ? 0.0F : power_of_ten(random, -4, -1);
    const float towards = random.uniform(0, 6.2831853F);
    camera.up[(axis + 1) % 3] = askew * std::cos(towards);
    camera.up[(axis + 2) % 3] = askew * std::sin(towards);
    camera.fovy = random.uniform(0.3F, 2);
    return camera;
}

/// Looks along an axis, with an up vector that leans by 0.001 to 0.05 from it: its products with the view are exact.
inline PrimaryCamera steep_camera(Random& random, int axis)
{
    glm::vec3 view(0);
    view[axis] = random.below(2) == 0 ? 1.0F : -1.0F;
    PrimaryCamera camera;
    camera.eye = glm::vec3(random.below(9), random.below(9), random.below(9));
    camera.target = camera.eye + 2.0F * view;
    camera.up = random.below(2) == 0 ? view : -view;
    const float lean = power_of_ten(random, -2.9F, -1.3F);
    const float angle = random.uniform(0, 6.28F);
    camera.up[(axis + 1) % 3] = lean * std::cos(angle);
    camera.up[(axis + 2) % 3] = lean * std::sin(angle);
    camera.fovy = random.uniform(0.3F, 2);
    return camera;
}

/// One in four lies outside the picture, and half of these far outside, up to 3000 times its size.
inline glm::vec2 random_place(Random& random, int width, int height)
{
    const glm::vec2 size(width, height);
    const float x = random.uniform();
    const glm::vec2 place = glm::vec2(x, random.uniform()) * size;
    const std::uint32_t kind = random.below(8);
    if (kind == 1) return 0.5F * size + power_of_ten(random, 0.5F, 3.5F) * (place - 0.5F * size);
    return kind == 0 ? 2.0F * place - 0.5F * size : place;
}

}
