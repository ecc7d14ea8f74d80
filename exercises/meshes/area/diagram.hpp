#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <kit/drawing.hpp>
#include <umbral/meshes/area.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

#include "../bodies.hpp"

namespace umbral::meshes {

/// A ball whose triangles are coloured by their areas (triangle_area), from the poles' to the equator's, with the
/// sphere's outline behind it.
inline void draw_ball(Recorder& out, Drawing& drawing, glm::dvec2 middle, double radius, std::uint32_t columns)
{
    const IndexedMesh mesh = ball(columns, columns / 2);
    drawing.disc(middle, 50 * radius, ink::slate);
    const auto turned = [](const glm::vec3& p) {
        return glm::dvec3(p.x, 0.8 * p.y - 0.6 * p.z, 0.6 * p.y + 0.8 * p.z);
    };
    const double largest = 9.87 / (static_cast<double>(columns) * columns);  // half of a cell on the equator, nearly
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 corners[] = {turned(mesh.positions[t.x]), turned(mesh.positions[t.y]),
                                      turned(mesh.positions[t.z])};
        const glm::dvec3 normal = normalize(cross(corners[1] - corners[0], corners[2] - corners[0]));
        if (normal.z <= 0) continue;
        std::vector<glm::dvec2> places;
        for (const glm::dvec3& corner : corners) places.push_back(middle + radius * glm::dvec2(corner));
        const double share = std::clamp(
            double{ask<triangle_area>(out, mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z])} / largest,
            0.0, 1.0);
        const double light = 0.35 + 0.65 * std::max(0.0, dot(normal, normalize(glm::dvec3(-0.4, 0.6, 0.7))));
        drawing.area(places, static_cast<float>(light) * glm::mix(ink::blue, ink::orange, static_cast<float>(share)));
        drawing.outline(places, ink::night, 0.8);
    }
}

/// Left: a ball. Right: how far the areas of finer and finer balls are from 4 π, both in powers of ten: four times the
/// triangles, a quarter of the error.
inline Image draw_diagram(Recorder& out, Variation& vary)
{
    Drawing drawing(600, 300, {0, 0}, {12, 6});
    draw_ball(out, drawing, {2.9, 3}, 2.5, vary.one_of(18U, std::array{14U, 16U, 20U}));

    constexpr glm::dvec2 origin(6.4, 0.6);
    const auto place = [&](double triangles, double error) {
        return origin + glm::dvec2(0.98 * (std::log10(triangles) - 1), 0.8 * (std::log10(error) + 5.8));
    };
    for (int power = 1; power <= 6; ++power)
        drawing.line(place(std::pow(10, power), 1.6e-6), place(std::pow(10, power), 1), ink::slate, power == 1 ? 2 : 1);
    for (int power = -5; power <= 0; ++power)
        drawing.line(place(10, std::pow(10, power)), place(1e6, std::pow(10, power)), ink::slate, 1);
    drawing.line(place(10, 1.6e-6), place(1e6, 1.6e-6), ink::slate, 2);

    glm::dvec2 before(0);
    const std::uint32_t fewest = vary.one_of(8U, std::array{6U, 10U, 12U});
    for (std::uint32_t columns = fewest; columns <= 512; columns *= 2) {
        const IndexedMesh mesh = ball(columns, columns / 2);
        const double exact = 12.566370614359172;
        const double error = std::max(1e-6, std::abs(double{ask<surface_area>(out, mesh)} - exact) / exact);
        const glm::dvec2 here = place(static_cast<double>(mesh.triangles.size()), error);
        if (columns > fewest) drawing.line(before, here, ink::blue, 2);
        drawing.disc(here, 5, ink::orange);
        before = here;
    }
    return drawing.picture();
}

}
