#include <umbral/raytracing/distributed.hpp>

namespace umbral::raytracing {

glm::vec2 disc_point(Random& random)
{
    // TODO: a point of the unit disc, all parts of its area equally likely.
    return not_implemented<glm::vec2>(random);
}

Ray lens_ray(const LensCamera& camera, PictureSize size, glm::vec2 place, glm::vec2 lens)
{
    // TODO: the ray from a point of the lens to where the ray from the eye meets the plane of focus.
    return not_implemented<Ray>(camera, size, place, lens);
}

float lamp_light(const MovingScene& scene, const LitPoint& at, const AreaLamp& lamp, float time, int samples,
                 Random& random)
{
    // TODO: the mean over some points of the lamp of what reaches the surface from there, times the lamp's area.
    return not_implemented<float>(scene, at, lamp, time, samples, random);
}

glm::vec3 pixel_light(const MovingScene& scene, const LensCamera& camera, PictureSize size, glm::ivec2 pixel,
                      int samples, Random& random)
{
    // TODO: the mean of some rays, each through its own place in the pixel and its own point of the lens, and at its
    // own time.
    return not_implemented<glm::vec3>(scene, camera, size, pixel, samples, random);
}

}
