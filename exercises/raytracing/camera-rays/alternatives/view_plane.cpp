// alternative: the course's way in double, a point of the view plane minus the observer; its frustum's l, r, b and t
#include <cmath>
#include <umbral/raytracing/camera_rays.hpp>

namespace umbral::raytracing {
namespace {

struct ViewFrame {
    glm::dvec3 o, x, y, z;
};

ViewFrame frame_of(const PrimaryCamera& camera)
{
    ViewFrame frame;
    frame.o = camera.eye;
    frame.z = normalize(frame.o - glm::dvec3(camera.target));
    frame.x = normalize(cross(glm::dvec3(camera.up), frame.z));
    frame.y = cross(frame.z, frame.x);
    return frame;
}

}

Ray primary_ray(const PrimaryCamera& camera, int width, int height, const glm::vec2& place)
{
    const ViewFrame frame = frame_of(camera);
    // A view plane as far away as the eye is from the world's origin, so that its points keep as many digits.
    const double n = 1 + length(frame.o);
    const double t = n * std::tan(camera.fovy / 2.0);
    const double r = t * width / height;
    const double u = -r + 2 * r * place.x / width;
    const double v = t - 2 * t * place.y / height;
    const glm::dvec3 q = frame.o + u * frame.x + v * frame.y - n * frame.z;
    return {camera.eye, glm::vec3(normalize(q - frame.o))};
}

std::vector<glm::vec2> pixel_samples(int x, int y, int n)
{
    std::vector<glm::vec2> places(static_cast<std::size_t>(n * n));
    for (int i = 0; i < n * n; ++i) {
        const double column = x + (2 * (i % n) + 1) / (2.0 * n);
        const double row = y + (2 * (i / n) + 1) / (2.0 * n);
        places[static_cast<std::size_t>(i)] = {column, row};
    }
    return places;
}

Grid<glm::vec3> render_picture(const PrimaryCamera& camera, int width, int height, int n,
                               const LightAlongRay& light_along)
{
    // All of the picture n times as large first, bottom row first; then its blocks.
    Grid<glm::vec3> large(width * n, height * n);
    for (int y = large.height - 1; y >= 0; --y)
        for (int x = 0; x < large.width; ++x)
            large.at(x, y) = light_along(primary_ray(camera, large.width, large.height, {x + 0.5F, y + 0.5F}));
    Grid<glm::vec3> picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            glm::dvec3 sum(0);
            for (int i = 0; i < n * n; ++i) sum += glm::dvec3(large.at(x * n + i % n, y * n + i / n));
            picture.at(x, y) = sum / double(n * n);
        }
    }
    return picture;
}

}
