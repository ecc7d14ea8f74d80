// Based on: P. Shirley. Ray Tracing in One Weekend. 2016, chapters 5 and 8; J. Amanatides, D. P. Mitchell. Antialiasing
// of Interlaced Video Animation. 1990, for the mean over a pixel's area by a regular grid.

#include <cmath>
#include <umbral/raytracing/camera_rays.hpp>

namespace umbral::raytracing {

Ray primary_ray(const PrimaryCamera& camera, int width, int height, const glm::vec2& place)
{
    // Directions only: a point of the view plane would be rounded where the world's coordinates are large.
    const glm::dvec3 back = normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
    const glm::dvec3 right = normalize(cross(glm::dvec3(camera.up), back));
    const glm::dvec3 up = cross(back, right);

    // At distance 1 the picture is 2 tan(fovy / 2) high; that gives the size of a pixel, in both directions.
    const double pixel = 2 * std::tan(0.5 * double{camera.fovy}) / height;
    const double x = pixel * (double{place.x} - 0.5 * width);
    const double y = pixel * (0.5 * height - double{place.y});
    return Ray{camera.eye, glm::vec3(normalize(x * right + y * up - back))};
}

std::vector<glm::vec2> pixel_samples(int x, int y, int n)
{
    std::vector<glm::vec2> places;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) places.emplace_back(x + (column + 0.5) / n, y + (row + 0.5) / n);
    return places;
}

Grid<glm::vec3> render_picture(const PrimaryCamera& camera, int width, int height, int n,
                               const LightAlongRay& light_along)
{
    Grid<glm::vec3> picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            glm::dvec3 sum(0);
            for (const glm::vec2& place : pixel_samples(x, y, n))
                sum += glm::dvec3(light_along(primary_ray(camera, width, height, place)));
            picture.at(x, y) = glm::vec3(sum / static_cast<double>(n * n));
        }
    }
    return picture;
}

}
