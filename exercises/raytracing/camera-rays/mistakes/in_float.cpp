// mistake: subtracts the eye from a point of the view plane in world coordinates, in float
// credit: 70..92
// hint: Far from the origin q = o + … is rounded to the world's coordinates, and q - o has few digits left. Leave the
// eye out: the direction needs only the camera's vectors. In double the narrow views come right, too.
#include <cmath>
#include <umbral/raytracing/camera_rays.hpp>

namespace umbral::raytracing {

Ray primary_ray(const PrimaryCamera& camera, int width, int height, const glm::vec2& place)
{
    const glm::vec3 z = normalize(camera.eye - camera.target);
    const glm::vec3 x = normalize(cross(camera.up, z));
    const glm::vec3 y = cross(z, x);
    const float pixel = 2 * std::tan(camera.fovy / 2) / static_cast<float>(height);
    const float u = pixel * (place.x - 0.5F * static_cast<float>(width));
    const float v = pixel * (0.5F * static_cast<float>(height) - place.y);
    const glm::vec3 q = camera.eye + u * x + v * y - z;
    return Ray{camera.eye, normalize(q - camera.eye)};
}

std::vector<glm::vec2> pixel_samples(int x, int y, int n)
{
    std::vector<glm::vec2> places;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column)
            places.emplace_back(glm::vec2(x, y) + (glm::vec2(column, row) + 0.5F) / static_cast<float>(n));
    return places;
}

Grid<glm::vec3> render_picture(const PrimaryCamera& camera, int width, int height, int n,
                               const LightAlongRay& light_along)
{
    Grid<glm::vec3> picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            glm::vec3 sum(0);
            for (const glm::vec2& place : pixel_samples(x, y, n))
                sum += light_along(primary_ray(camera, width, height, place));
            picture.at(x, y) = sum / static_cast<float>(n * n);
        }
    }
    return picture;
}

}
