#pragma once

#include <algorithm>
#include <kit/drawing.hpp>
#include <kit/varied.hpp>
#include <umbral/meshes/euler.hpp>
#include <umbral/record/ask.hpp>
#include <utility>

#include "../show.hpp"
#include "../zoo.hpp"

/// Eight surfaces, and below each what the unit says of it. A context must be current.
namespace umbral::meshes {

/// A mark below a surface: a disc, or else a ring.
struct Mark {
    glm::vec3 color;
    bool is_disc;
};

/// A green disc for each 1 of V - E + F, a red one for each -1; a white ring for each handle; a yellow ring for each
/// rim. No more than six of a kind.
inline std::vector<Mark> marks_of(const TopologyCounts& counts, const std::optional<int>& handles)
{
    std::vector<Mark> marks;
    const auto add = [&](std::int64_t count, const Mark& mark) {
        marks.insert(marks.end(), static_cast<std::size_t>(std::clamp<std::int64_t>(count, 0, 6)), mark);
    };
    const std::int64_t characteristic = std::int64_t{counts.vertices} - counts.edges + counts.faces;
    add(characteristic, {ink::green, true});
    add(-characteristic, {ink::red, true});
    add(handles.value_or(0), {ink::white, false});
    add(counts.boundary_loops, {ink::orange, false});
    return marks;
}

inline void draw_marks(const Show& show, const std::vector<Mark>& marks)
{
    constexpr double step = 0.27;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const glm::vec3 place(step * (static_cast<double>(i) - 0.5 * static_cast<double>(marks.size() - 1)), -1.25,
                              0.6);
        show.points(std::array{place}, marks[i].color, 6);
        if (!marks[i].is_disc) show.points(std::array{place}, ink::night, 3.5F, 6e-3F);
    }
}

/// Blue where there is a genus, pink where there is none. Varied, they hang in another order.
inline Image draw_gallery(Recorder& out, Variation& vary)
{
    constexpr int columns = 4;
    Show show(columns, 2, 150, 150);
    const auto lying = [](const glm::vec3& p) {
        return glm::vec3(p.x, 0.35F * p.y + 0.85F * p.z, 0.35F * p.z - 0.85F * p.y);
    };
    const std::vector<IndexedMesh> written = {ball(16, 10),
                                              torus(20, 10, 0.85F),
                                              mapped(plate_with_holes(2), lying),
                                              mapped(plate_with_holes(3), lying),
                                              disc(14),
                                              tube(18, 5),
                                              moebius(28, 3),
                                              cubes_at_a_corner()};
    const std::vector<IndexedMesh> meshes = in_random_order(vary, written);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const std::optional<int> handles = ask<genus>(out, meshes[i]);
        show.pane(static_cast<int>(i) % columns, static_cast<int>(i) / columns, {{0, 2.1F, 4.9F}, {0, -0.2F, 0}, 33});
        std::vector<glm::vec3> colors;
        for (std::size_t face = 0; face < meshes[i].triangles.size(); ++face)
            colors.push_back((face % 2 == 0 ? 1.0F : 0.86F) * (handles ? ink::blue : ink::pink));
        show.mesh(meshes[i], colors, {1.0F, {}, 0});
        draw_marks(show, marks_of(ask<count_topology>(out, meshes[i]), handles));
    }
    return show.picture();
}

}
