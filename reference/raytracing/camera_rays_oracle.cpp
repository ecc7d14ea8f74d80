#include <cmath>
#include <umbral/raytracing/camera_rays.hpp>

#include "wide_vector.hpp"

// The frame and the direction with 113 bits (the tangent with 64), rounded to float once.

namespace umbral::raytracing {

Ray primary_ray(const PrimaryCamera& camera, int width, int height, const glm::vec2& place)
{
    const WideVector view = unit(widened(camera.target) - widened(camera.eye));
    const WideVector right = unit(cross(view, widened(camera.up)));
    const WideVector down = cross(view, right);
    const Wide half_height = std::tan(static_cast<long double>(camera.fovy) / 2);
    const Wide x = half_height * (2 * Wide{place.x} - width) / height;
    const Wide y = half_height * (2 * Wide{place.y} - height) / height;
    return Ray{camera.eye, rounded(unit(x * right + y * down + view))};
}

std::vector<glm::vec2> pixel_samples(int x, int y, int n)
{
    std::vector<glm::vec2> places;
    for (int i = 0; i < n * n; ++i) {
        const Wide column = i % n;
        const Wide row = i / n;
        places.emplace_back(static_cast<float>(x + (2 * column + 1) / (2 * n)),
                            static_cast<float>(y + (2 * row + 1) / (2 * n)));
    }
    return places;
}

Grid<glm::vec3> render_picture(const PrimaryCamera& camera, int width, int height, int n,
                               const LightAlongRay& light_along)
{
    Grid<glm::vec3> picture(width, height);
    for (int i = 0; i < width * height; ++i) {
        const int x = i % width;
        const int y = i / width;
        WideVector sum{0, 0, 0};
        for (const glm::vec2& place : pixel_samples(x, y, n))
            sum = sum + widened(light_along(primary_ray(camera, width, height, place)));
        const WideVector mean = (Wide{1} / (n * n)) * sum;
        picture.at(x, y) = {static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(mean.z)};
    }
    return picture;
}

}
