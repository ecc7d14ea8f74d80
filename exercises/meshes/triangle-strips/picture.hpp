#pragma once

#include <cmath>
#include <kit/drawing.hpp>
#include <umbral/meshes/strips.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

#include "../show.hpp"
#include "../zoo.hpp"
#include "strip_log.hpp"

namespace umbral::meshes {

/// Hills over a grid of `columns` x `rows` cells, whose vertices are numbered as grid_strips has it; rows go away from
/// the viewer.
inline std::vector<glm::vec3> hills_over_a_grid(std::uint32_t columns, std::uint32_t rows)
{
    std::vector<glm::vec3> positions;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const double x = 3.2 * column / columns - 1.6;
            const double z = 1.3 - 2.6 * row / rows;
            const double height = 0.55 * std::exp(-3 * ((x - 0.5) * (x - 0.5) + (z + 0.2) * (z + 0.2))) +
                                  0.3 * std::exp(-5 * ((x + 0.8) * (x + 0.8) + (z - 0.4) * (z - 0.4)));
            positions.emplace_back(x, height, z);
        }
    }
    return positions;
}

/// Left: the strips of a grid, joined and taken apart again, each in a colour of its own, with its zigzag over it.
/// Right: a knot drawn from its strips. Backs are red.
inline Image draw_strips(Recorder& out, Variation& vary)
{
    const std::uint32_t columns = vary.one_of(16U, std::array{11U, 13U, 19U});
    const std::uint32_t rows = vary.one_of(8U, std::array{6U, 9U, 10U});
    const Look look{1.0F, ink::red, 0.9F};
    Show show(2, 1, 300, 300);

    show.pane(0, 0, {{-0.4F, 3.2F, 5.2F}, {0, -0.1F, 0.1F}, 38});
    const std::vector<Strip> strips = ask<grid_strips>(out, columns, rows);
    IndexedMesh ground{hills_over_a_grid(columns, rows), ask<triangles_of_strip>(out, ask<join_strips>(out, strips))};
    ground.triangles.resize(std::min<std::size_t>(ground.triangles.size(), 1000));
    std::vector<glm::vec3> colors;
    for (std::size_t i = 0; i < ground.triangles.size(); ++i) {
        const bool is_odd_row = i / (2 * std::size_t{columns}) % 2 == 1;
        colors.push_back((i % 2 == 0 ? 1.0F : 0.8F) * (is_odd_row ? ink::green : ink::blue));
    }
    show.mesh(ground, colors, look);
    std::vector<std::array<glm::vec3, 2>> zigzag;
    for (std::size_t i = 0; i < std::min<std::size_t>(strips.size(), 100); ++i)
        for (std::size_t k = 1; k < std::min<std::size_t>(strips[i].size(), 100); ++k)
            if (strips[i][k - 1] < ground.positions.size() && strips[i][k] < ground.positions.size())
                zigzag.push_back({ground.positions[strips[i][k - 1]], ground.positions[strips[i][k]]});
    show.lines(zigzag, ink::orange, 1.6F);

    show.pane(1, 0, {{0.4F, -1.8F, 6.4F}, {0, 0, 0}, 33});
    IndexedMesh knot = mapped(trefoil(vary.one_of(72U, std::array{54U, 60U, 84U}), 8, 0.55),
                              [](const glm::vec3& p) { return 0.5F * p; });
    knot.triangles = drawn(ask<make_strips>(out, knot), knot.triangles.size());
    std::vector<glm::vec3> shades;
    for (const glm::uvec3& t : knot.triangles) {
        const glm::vec3 place = t.x < knot.positions.size() ? knot.positions[t.x] : glm::vec3(0);
        shades.push_back(glm::mix(ink::orange, ink::pink, 0.5F + 0.3F * place.x - 0.3F * place.y));
    }
    show.mesh(knot, shades, look);
    return show.picture();
}

}
