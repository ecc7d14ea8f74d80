// alternative: a class that turns the view by steps of a pixel in long double, and a mean that is brought up to date
#include <cmath>
#include <umbral/raytracing/camera_rays.hpp>

namespace umbral::raytracing {
namespace {

using Exact = glm::vec<3, long double>;

class Lens {
public:
    Lens(const PrimaryCamera& camera, int width, int height)
        : centre_(0.5L * width, 0.5L * height), forward_(normalize(Exact(camera.target) - Exact(camera.eye)))
    {
        // What of up is across the view; then down and right in steps of one pixel.
        const Exact up = normalize(Exact(camera.up));
        const Exact across = normalize(up - dot(up, forward_) * forward_);
        const long double step = std::tan(0.5L * camera.fovy) / centre_.y;
        down_ = -step * across;
        right_ = step * cross(forward_, across);
    }

    [[nodiscard]] glm::vec3 direction(const glm::vec2& place) const
    {
        return glm::vec3(normalize(forward_ + (place.x - centre_.x) * right_ + (place.y - centre_.y) * down_));
    }

private:
    glm::vec<2, long double> centre_;
    Exact forward_;
    Exact down_{0};
    Exact right_{0};
};

}

Ray primary_ray(const PrimaryCamera& camera, int width, int height, const glm::vec2& place)
{
    return Ray{camera.eye, Lens(camera, width, height).direction(place)};
}

std::vector<glm::vec2> pixel_samples(int x, int y, int n)
{
    const auto middle = [n](int corner, int i) {
        return static_cast<float>(corner + (i + 0.5) / static_cast<double>(n));
    };
    std::vector<glm::vec2> result;
    for (int i = 0; i < n * n; ++i) result.emplace_back(middle(x, i % n), middle(y, i / n));
    return result;
}

Grid<glm::vec3> render_picture(const PrimaryCamera& camera, int width, int height, int n,
                               const LightAlongRay& light_along)
{
    const Lens lens(camera, width, height);
    Grid<glm::vec3> picture(width, height);
    for (int x = 0; x < width; ++x) {
        for (int y = 0; y < height; ++y) {
            glm::dvec3 mean(0);
            int count = 0;
            for (const glm::vec2& place : pixel_samples(x, y, n)) {
                const glm::dvec3 light(light_along(Ray{camera.eye, lens.direction(place)}));
                mean += (light - mean) / static_cast<double>(++count);
            }
            picture.at(x, y) = glm::vec3(mean);
        }
    }
    return picture;
}

}
