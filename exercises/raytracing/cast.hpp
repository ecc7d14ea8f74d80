#pragma once

#include <glm/glm.hpp>
#include <kit/picture.hpp>
#include <kit/varied.hpp>
#include <umbral/core/ray.hpp>
#include <umbral/record/variation.hpp>

/// Pictures of what rays meet, for any unit that finds where.
namespace umbral::raytracing {

/// A camera at `eye` that looks at `target`, with y up: the picture is as high as 2 * `half_height` at distance 1.
struct Camera {
    glm::vec3 eye;
    glm::vec3 target;
    float half_height;
};

/// Another place for the camera, if inputs are to vary: about its target, as high and as far away.
inline Camera varied(Variation& vary, Camera camera)
{
    camera.eye = other_eye(vary, camera.eye, camera.target, 0.6F);
    camera.half_height = vary.scaled(camera.half_height, 1.1F);
    return camera;
}

/// The ray of unit direction through a place of a picture `width` x `height`: (0, 0) is its upper left corner, and the
/// middle of pixel (x, y) is (x + 0.5, y + 0.5).
inline Ray camera_ray(const Camera& camera, int width, int height, const glm::vec2& place)
{
    const glm::vec3 back = normalize(camera.eye - camera.target);
    const glm::vec3 right = normalize(cross(glm::vec3(0, 1, 0), back));
    const glm::vec3 up = cross(back, right);
    const glm::vec2 size(width, height);
    const glm::vec2 at = camera.half_height * (2.0F * place - size) / size.y;
    return Ray{camera.eye, normalize(at.x * right - at.y * up - back)};
}

/// A picture in which each pixel is the mean of 2 x 2 rays' linear light, `light_along(ray)`, encoded.
template <class LightAlong>
Image ray_traced(int width, int height, const Camera& camera, LightAlong light_along)
{
    Grid<glm::vec3> light(2 * width, 2 * height);
    for (int y = 0; y < light.height; ++y)
        for (int x = 0; x < light.width; ++x)
            light.at(x, y) = light_along(camera_ray(camera, light.width, light.height, glm::vec2(x, y) + 0.5F));
    return halved(encoded(light));
}

}
