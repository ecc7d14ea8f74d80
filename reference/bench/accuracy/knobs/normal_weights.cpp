#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <umbral/core/random.hpp>
#include <umbral/meshes/normals.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

double height(double x, double y) { return 0.2 * std::sin(3 * x) * std::cos(2 * y); }

glm::dvec3 exact_normal(const glm::vec3& p)
{
    const double dx = 0.6 * std::cos(3.0 * p.x) * std::cos(2.0 * p.y);
    const double dy = -0.4 * std::sin(3.0 * p.x) * std::sin(2.0 * p.y);
    return normalize(glm::dvec3(-dx, -dy, 1));
}

/// Hills over the unit square: a grid of n x n cells whose vertices are moved by up to a fifth of a cell, so that no
/// triangle turns over.
meshes::IndexedMesh hills(std::uint32_t n, Random& random)
{
    meshes::IndexedMesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) {
            const double x = (i + 0.4 * (random.uniform_double() - 0.5)) / n;
            const double y = (j + 0.4 * (random.uniform_double() - 0.5)) / n;
            mesh.positions.emplace_back(x, y, height(x, y));
        }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            mesh.triangles.emplace_back(a, a + 1, a + n + 2);
            mesh.triangles.emplace_back(a, a + n + 2, a + n + 1);
        }
    return mesh;
}

enum class Weight { area, angle, max };

/// Sums of the triangles' normals at each vertex, not yet of unit length: by area, by the angle at the vertex, or by
/// N. Max. Weights for Computing Vertex Normals from Facet Normals. 1999.
std::vector<glm::vec3> weighted_normals(const meshes::IndexedMesh& mesh, Weight weight)
{
    std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0));
    for (const glm::uvec3& one : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 a = mesh.positions[one[(k + 1) % 3]] - mesh.positions[one[k]];
            const glm::vec3 b = mesh.positions[one[(k + 2) % 3]] - mesh.positions[one[k]];
            const glm::vec3 across = cross(a, b);
            float factor = 1;
            if (weight == Weight::angle) factor = std::atan2(length(across), dot(a, b)) / length(across);
            if (weight == Weight::max) factor = 1 / (dot(a, a) * dot(b, b));
            normals[one[k]] += factor * across;
        }
    for (glm::vec3& normal : normals) normal = normalize(normal);
    return normals;
}

}

Knob measure_normal_weights(Means& means)
{
    constexpr std::uint64_t seed = 26;
    Study study = study_of("normal-weights", "Weights of vertex normals",
                           fmt::format("Normals of hills, from grids of n × n cells with moved vertices, against the "
                                       "surface's own; inner vertices only; seed {}. Equal weights are Umbral's "
                                       "reference.",
                                       seed),
                           "ns per vertex", {{"rms", "angle of the normal, RMS", "degrees"}});
    using Method = std::vector<glm::vec3> (*)(const meshes::IndexedMesh&);
    const std::vector<std::pair<std::string, Method>> methods = {
        {"equal", [](const meshes::IndexedMesh& mesh) { return meshes::vertex_normals(mesh); }},
        {"area", [](const meshes::IndexedMesh& mesh) { return weighted_normals(mesh, Weight::area); }},
        {"angle", [](const meshes::IndexedMesh& mesh) { return weighted_normals(mesh, Weight::angle); }},
        {"Max", [](const meshes::IndexedMesh& mesh) { return weighted_normals(mesh, Weight::max); }}};
    for (const auto& [family, method] : methods) {
        for (const std::uint32_t n : {16U, 32U, 64U, 128U}) {
            Random random(seed);
            const auto mesh = std::make_shared<const meshes::IndexedMesh>(hills(n, random));
            const std::vector<glm::vec3> normals = method(*mesh);
            std::vector<double> errors;
            for (std::uint32_t j = 1; j < n; ++j)
                for (std::uint32_t i = 1; i < n; ++i) {
                    const std::size_t at = j * (n + 1) + i;
                    const glm::dvec3 exact = exact_normal(mesh->positions[at]);
                    errors.push_back(57.29577951308232 * std::asin(length(cross(exact, glm::dvec3(normals[at])))));
                }
            study.trials.push_back({fmt::format("{}, {} cells", family, n),
                                    family,
                                    static_cast<double>(n),
                                    {{"rms", root_mean_square(errors)}},
                                    static_cast<double>(normals.size()),
                                    [mesh, method = method] { keep(method(*mesh)); }});
        }
        study.laws.push_back(
            {family, "rms", "cells a side", -1,
             "Facets are off by the cells' width times the curvature, and moved vertices leave no "
             "symmetry by which this would cancel.",
             "Weights that suit the shapes leave little of that, and then a share of second order is seen."});
    }
    return finish(std::move(study), means);
}

}
