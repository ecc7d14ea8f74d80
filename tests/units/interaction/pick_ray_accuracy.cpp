// Prints how far beside its pixel's centre each form's ray passes: the table in the statement of interaction/pick-ray.
// Usage: pick-ray-accuracy [SEED [RAYS]]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <interaction/pick_views.hpp>
#include <vector>

#include "../solution.hpp"
#include "pick_ray_functions.hpp"

using namespace umbral;
using namespace umbral::interaction;
using Form = Ray(const PickView&, const glm::ivec2&);

namespace {

/// The angle between two rays in those of the pixel's width, as seen from the eye, for a picture 1000 pixels wide.
std::vector<double> errors_of(Form* form, double distance, std::uint64_t seed, int rays)
{
    static Form* const oracle = tests::solution_table<PickRayFunctions>(ORACLE_MODULE)->ray;
    Random random(seed);
    std::vector<double> errors;
    for (int i = 0; i < rays; ++i) {
        PickView view = random_pick_view(random);
        view.frustum.far_plane = 1000 * view.frustum.near_plane;
        view.frame.origin = glm::vec3(distance * glm::dvec3(random.unit_vector()));
        view.picture = {1000, 1000};
        const glm::ivec2 pixel = random_pixel(view.picture, random);
        const glm::dvec3 exact(oracle(view, pixel).direction);
        const double width = length(cross(exact, glm::dvec3(oracle(view, pixel + glm::ivec2(1, 0)).direction)));
        const double error = length(cross(exact, glm::dvec3(form(view, pixel).direction))) / width;
        errors.push_back(std::isfinite(error) ? error : 1000);
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

}

int main(int count, char** arguments)
{
    const std::uint64_t seed = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 1;
    const int rays = count > 2 ? std::atoi(arguments[2]) : 100'000;
    std::printf("seed %llu, %d rays a column: median and worst error in pixels\n",
                static_cast<unsigned long long>(seed), rays);
    const double distances[] = {1, 100, 1e4, 1e6};
    std::printf("%-28s", "eye from the origin");
    for (const double distance : distances) std::printf("%20g", distance);
    std::printf("\n");
    for (const auto& [name, path] : {std::pair<const char*, const char*>{"inverted matrices, float", IN_FLOAT_MODULE},
                                     {"reference", REFERENCE_MODULE}}) {
        std::printf("%-28s", name);
        for (const double distance : distances) {
            const std::vector<double> errors =
                errors_of(tests::solution_table<PickRayFunctions>(path)->ray, distance, seed, rays);
            std::printf("%11.2g%9.2g", errors[errors.size() / 2], errors.back());
        }
        std::printf("\n");
    }
}
