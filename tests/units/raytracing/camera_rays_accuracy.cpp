// Prints the errors of each form in pixels: the table in the statement of raytracing/camera-rays.
// Usage: camera-rays-accuracy [SEED [RAYS]]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <raytracing/rays.hpp>

#include "../solution.hpp"
#include "camera_rays_functions.hpp"

using namespace umbral;
using namespace umbral::raytracing;

namespace {

constexpr int size = 512;

Ray in_float_without_the_eye(const PrimaryCamera& camera, int width, int height, const glm::vec2& place)
{
    const glm::vec3 back = normalize(camera.eye - camera.target);
    const glm::vec3 right = normalize(cross(camera.up, back));
    const float pixel = 2 * std::tan(camera.fovy / 2) / static_cast<float>(height);
    const glm::vec2 at = pixel * (place - 0.5F * glm::vec2(width, height));
    return Ray{camera.eye, normalize(at.x * right - at.y * cross(back, right) - back)};
}

/// The worst distance between the places that two rays go through, in pixels of the middle of the picture.
double worst_of(decltype(CameraRaysFunctions::primary_ray) form, float away, float fovy, std::uint64_t seed, int rays)
{
    const auto& oracle = *tests::solution_table<CameraRaysFunctions>(ORACLE_MODULE);
    Random random(seed);
    double worst = 0;
    for (int i = 0; i < rays; ++i) {
        PrimaryCamera camera;
        camera.eye = away * random.unit_vector();
        camera.target = camera.eye + std::max(1.0F, 0.01F * away) * random.unit_vector();
        const glm::dvec3 view = normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
        camera.up = glm::vec3(perpendicular_to(view, random));
        camera.fovy = fovy;
        const float x = random.uniform(0, size);
        const glm::vec2 place(x, random.uniform(0, size));
        const glm::dvec3 got(form(camera, size, size, place).direction);
        const glm::dvec3 exact(oracle.primary_ray(camera, size, size, place).direction);
        worst = std::max(worst, length(got - exact) * size / (2 * std::tan(0.5 * double{fovy})));
    }
    return worst;
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int rays = count > 2 ? std::atoi(arguments[2]) : 20'000;
    std::printf("seed %llu, %d rays a column, 512 x 512 pixels: worst error in pixels\n",
                static_cast<unsigned long long>(seed), rays);
    std::printf("%-26s%12s%12s%12s%12s%12s\n", "", "fovy 1", "1e3 away", "1e5 away", "fovy 1e-2", "fovy 1e-4");
    const auto& in_float = *tests::solution_table<CameraRaysFunctions>(IN_FLOAT_MODULE);
    const auto& reference = *tests::solution_table<CameraRaysFunctions>(REFERENCE_MODULE);
    for (const auto& [name, form] :
         {std::pair{"float, point minus eye", in_float.primary_ray},
          std::pair<const char*, decltype(in_float.primary_ray)>{"float, without the eye", in_float_without_the_eye},
          std::pair{"reference", reference.primary_ray}}) {
        std::printf("%-26s", name);
        for (const auto& [away, fovy] : {std::pair<float, float>{1, 1}, {1e3F, 1}, {1e5F, 1}, {1, 1e-2F}, {1, 1e-4F}})
            std::printf("%12.2g", worst_of(form, away, fovy, seed, rays));
        std::printf("\n");
    }
}
