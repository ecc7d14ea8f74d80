#include <fmt/format.h>

#include <array>
#include <cmath>
#include <umbral/core/random.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

const glm::dvec3 light = normalize(glm::dvec3(1, 1.5, 2));
const glm::dvec3 half_way = normalize(light + glm::dvec3(0, 0, 1));

/// Diffuse light and a highlight, for a unit normal.
double shade(const glm::dvec3& normal)
{
    return 0.6 * std::max(0.0, dot(normal, light)) + 0.4 * std::pow(std::max(0.0, dot(normal, half_way)), 20);
}

/// The sphere's normal, and point, at longitude and latitude u, v in [-0.7, 0.7].
glm::dvec3 on_sphere(double u, double v) { return {std::sin(u) * std::cos(v), std::sin(v), std::cos(u) * std::cos(v)}; }

/// A pixel: a triangle of the mesh, and where in it.
struct Spot {
    std::array<glm::dvec3, 3> corners;  ///< also the normals there
    std::array<double, 3> shades;       ///< at the corners, computed once a vertex
    double face;                        ///< shade of the facet
    glm::dvec3 weights;
};

Spot random_spot(int cells, Random& random)
{
    const double width = 1.4 / cells;
    const double u = -0.7 + width * random.below(static_cast<std::uint32_t>(cells));
    const double v = -0.7 + width * random.below(static_cast<std::uint32_t>(cells));
    Spot spot{{on_sphere(u, v), on_sphere(u + width, v), on_sphere(u + width, v + width)}, {}, 0, {}};
    for (std::size_t i = 0; i < 3; ++i) spot.shades[i] = shade(spot.corners[i]);
    spot.face = shade(normalize(cross(spot.corners[1] - spot.corners[0], spot.corners[2] - spot.corners[0])));
    const double root = std::sqrt(random.uniform_double());
    const double along = random.uniform_double();
    spot.weights = {1 - root, root * (1 - along), root * along};
    return spot;
}

glm::dvec3 between(const Spot& spot)
{
    return spot.weights.x * spot.corners[0] + spot.weights.y * spot.corners[1] + spot.weights.z * spot.corners[2];
}

double flat(const Spot& spot) { return spot.face; }
double gouraud(const Spot& spot)
{
    return dot(spot.weights, glm::dvec3(spot.shades[0], spot.shades[1], spot.shades[2]));
}
double phong(const Spot& spot) { return shade(normalize(between(spot))); }

/// The true shade where the line of sight, along z, meets the sphere behind this point of the facet.
double exact(const Spot& spot)
{
    const glm::dvec3 p = between(spot);
    return shade({p.x, p.y, std::sqrt(1 - p.x * p.x - p.y * p.y)});
}

}

Knob measure_shading(Means& means)
{
    constexpr std::uint64_t seed = 17;
    const int spots = means.quick ? 3000 : 30'000;
    Study study = study_of("shading", "Flat, Gouraud, Phong",
                           fmt::format("A part of a sphere with a highlight (exponent 20), cut into n × n cells of two "
                                       "triangles and seen along z: {} random pixels against the true sphere; seed {}. "
                                       "The time is a pixel's; vertices and facets are shaded before.",
                                       spots, seed),
                           "ns per pixel", {{"rms", "error of the shade, RMS", "of white"}});
    const std::vector<std::pair<std::string, double (*)(const Spot&)>> methods = {
        {"flat", flat}, {"Gouraud", gouraud}, {"Phong", phong}};
    for (const auto& [family, method] : methods)
        for (const int cells : {2, 4, 8, 16, 32, 64}) {
            Random random(seed);
            std::vector<double> errors;
            std::vector<Spot> timed;
            for (int i = 0; i < spots; ++i) {
                const Spot spot = random_spot(cells, random);
                errors.push_back(method(spot) - exact(spot));
                if (i < 1000) timed.push_back(spot);
            }
            study.trials.push_back({fmt::format("{} {}", family, cells),
                                    family,
                                    static_cast<double>(cells),
                                    {{"rms", root_mean_square(errors)}},
                                    1000,
                                    [timed, method = method] {
                                        for (const Spot& spot : timed) keep(method(spot));
                                    }});
        }
    study.laws = {
        {"flat", "rms", "cells a side", -1, "One normal for a facet errs by its width.",
         "A facet as wide as the highlight does not resolve it."},
        {"Gouraud", "rms", "cells a side", -2, "Linear interpolation errs by the square of the width.",
         "A facet as wide as the highlight does not resolve it."},
        {"Phong", "rms", "cells a side", -2, "The normal between the corners is off by the square of the width.",
         "On a sphere much of the error cancels: the normalised blend points along the facet's own point."}};
    return finish(std::move(study), means);
}

}
