// alternative: the inverse of the view matrix in double, and places in normalised device coordinates
#include <cmath>
#include <umbral/raytracing/camera_rays.hpp>

namespace umbral::raytracing {

Ray primary_ray(const PrimaryCamera& camera, int width, int height, const glm::vec2& place)
{
    // As seen from the eye: so no large coordinate gets into the matrix.
    const glm::dvec3 centre = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    const glm::dvec3 up = normalize(glm::dvec3(camera.up));
    const glm::dmat3 to_world = transpose(glm::dmat3(glm::lookAt(glm::dvec3(0), normalize(centre), up)));
    const double aspect = static_cast<double>(width) / height;
    const double tangent = std::tan(static_cast<double>(camera.fovy) / 2);
    const glm::dvec2 ndc(2.0 * double{place.x} / width - 1, 1 - 2.0 * double{place.y} / height);
    Ray ray;
    ray.origin = camera.eye;
    ray.direction = glm::vec3(normalize(to_world * glm::dvec3(ndc.x * tangent * aspect, ndc.y * tangent, -1)));
    return ray;
}

std::vector<glm::vec2> pixel_samples(int x, int y, int n)
{
    std::vector<glm::vec2> samples;
    const float step = 1.0F / static_cast<float>(n);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) samples.push_back(glm::vec2(x, y) + step * (glm::vec2(i, j) + 0.5F));
    return samples;
}

Grid<glm::vec3> render_picture(const PrimaryCamera& camera, int width, int height, int n,
                               const LightAlongRay& light_along)
{
    Grid<glm::vec3> picture(width, height);
    const double weight = 1.0 / (n * n);
    for (int i = 0; i < width * height; ++i) {
        glm::dvec3 mean(0);
        for (const glm::vec2& sample : pixel_samples(i % width, i / width, n))
            mean += weight * glm::dvec3(light_along(primary_ray(camera, width, height, sample)));
        picture.cells[static_cast<std::size_t>(i)] = glm::vec3(mean);
    }
    return picture;
}

}
