#include <umbral/raytracing/camera_rays.hpp>

namespace umbral::raytracing {

Ray primary_ray(const PrimaryCamera& camera, int width, int height, const glm::vec2& place)
{
    // TODO: the camera's three unit vectors: right, up, and back, away from what it looks at. How high is what it sees
    // at distance 1, and so how large is a pixel there? Go from the middle of the picture to the place.
    return not_implemented<Ray>(camera, width, height, place);
}

std::vector<glm::vec2> pixel_samples(int x, int y, int n)
{
    // TODO: the centres of n x n small squares of the pixel, row by row.
    return not_implemented<std::vector<glm::vec2>>(x, y, n);
}

Grid<glm::vec3> render_picture(const PrimaryCamera& camera, int width, int height, int n,
                               const LightAlongRay& light_along)
{
    // TODO: for each pixel the mean of light_along(ray) over its samples.
    return not_implemented<Grid<glm::vec3>>(camera, width, height, n, light_along);
}

}
