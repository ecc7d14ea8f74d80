#pragma once

#include <array>

#include "soups.hpp"

/// Rays and boxes of which exact numbers decide.
namespace umbral::raytracing {

/// Boxes with whole coordinates, and rays along their edges, in the planes of their faces, and across flat ones: all
/// that decides is exact. Each comes with all its coordinates in turn, in both directions, with both zeros.
inline std::vector<BoxShot> along_the_axes(Random& random)
{
    const BoundingBox cube{{0, 0, 0}, {2, 2, 2}};
    const BoundingBox pane{{0, 0, 1}, {2, 2, 1}};
    const BoundingBox point{{1, 1, 1}, {1, 1, 1}};
    const std::pair<BoxShot, BoxShot> pairs[] = {
        {{Ray{{1, 1, 5}, {0, 0, -1}}, cube}, {Ray{{1, 3, 5}, {0, 0, -1}}, cube}},
        {{Ray{{2, 1, 5}, {0, 0, -1}}, cube}, {Ray{{2.25F, 1, 5}, {0, 0, -1}}, cube}},
        {{Ray{{0, 0, 5}, {0, 0, -1}}, cube}, {Ray{{0, -0.25F, 5}, {0, 0, -1}}, cube}},
        {{Ray{{1, 2, 1}, {0, 0, -1}}, cube}, {Ray{{1, 2, -1}, {0, 0, -1}}, cube}},
        {{Ray{{4, 2, 4}, {-1, 0, -1}}, cube}, {Ray{{4, 2.25F, 4}, {-1, 0, -1}}, cube}},
        {{Ray{{1, 1, 5}, {0, 0, -1}}, pane}, {Ray{{1, 1, 5}, {0, 0, 1}}, pane}},
        {{Ray{{4, 1, 1}, {-1, 0, 0}}, pane}, {Ray{{4, 1, 1.25F}, {-1, 0, 0}}, pane}},
        {{Ray{{3, 3, 3}, {-1, -1, -1}}, pane}, {Ray{{5.5F, 3, 3}, {-1, -1, -1}}, pane}},
        {{Ray{{5, 3, 4}, {-4, -2, -3}}, point}, {Ray{{5, 3.25F, 4}, {-4, -2, -3}}, point}},
        {{Ray{{1, 1, 5}, {0, 0, -1}, 0, 3.5F}, cube}, {Ray{{1, 1, 5}, {0, 0, -1}, 0, 2.5F}, cube}},
        {{Ray{{1, 1, 5}, {0, 0, -1}, 4.5F}, cube}, {Ray{{1, 1, 5}, {0, 0, -1}, 5.5F}, cube}},
        {{Ray{{1, 1, 1}, {0, 0, -1}, 0, 0.5F}, cube}, {Ray{{1, 1, 1}, {0, 0, -1}, 1.5F, 2}, cube}},
        {{Ray{{1, 1, -5}, {0, 0, -2}, -4}, cube}, {Ray{{1, 1, -5}, {0, 0, -2}}, cube}},
        {{Ray{{1, 1, 5}, {0, 0, -1}}, cube}, {Ray{{1, 1, 5}, {0, 0, -1}}, {{0, 0, 2}, {2, 2, 0}}}},
        {{Ray{{1, 1, 5}, {0.125F, 0, -1}}, cube},
         {Ray{{1, 1, 5}, {0.125F, 0, -1}}, {glm::vec3(endless), glm::vec3(-endless)}}},
    };
    std::vector<BoxShot> shots;
    for (int turn = 0; turn < 6; ++turn)
        for (const auto& [hit, miss] : pairs) {
            const auto turned = [turn](glm::vec3 v) {
                for (int i = 0; i < turn % 3; ++i) v = {v.y, v.z, v.x};
                return v;
            };
            const auto changed = [&](BoxShot shot) {
                shot.ray = {turned(shot.ray.origin), turned(shot.ray.direction), shot.ray.t_min, shot.ray.t_max};
                shot.box = {turned(shot.box.low), turned(shot.box.high)};
                if (turn < 3) return shot;
                shot.ray.origin = -shot.ray.origin;
                shot.ray.direction = -shot.ray.direction;
                shot.box = {-shot.box.high, -shot.box.low};
                return shot;
            };
            add_pair(shots, changed(hit), changed(miss), random);
        }
    return shots;
}

/// Boxes that a ray touches in one point of an edge or in a corner, all in whole numbers and at a whole t, and the same
/// ray where it leaves one t before it enters. Quotients are exact there; products with a rounded reciprocal are not:
/// 49 (1/49) < 1. For half of the pairs such a number is chosen for the component along which the ray leaves. For a
/// quarter the point is so far away that its distance from the origin is no float, and a quotient of floats not exact.
inline std::vector<BoxShot> touching(Random& random)
{
    constexpr std::array unlucky{49, 98, 103, 107, 161, 187, 196, 197};
    std::vector<BoxShot> shots;
    for (int i = 0; i < 128; ++i) {
        const bool is_far = i % 4 == 1;
        const int leaves = static_cast<int>(random.below(3));
        const int enters = (leaves + 1 + static_cast<int>(random.below(2))) % 3;
        const int other = 3 - leaves - enters;
        const auto whole = [&](int least, int most) {
            return least + static_cast<int>(random.below(static_cast<std::uint32_t>(most - least + 1)));
        };
        glm::ivec3 step{whole(1, 60), whole(1, 60), whole(1, 60)};
        if (i % 2 == 0) {
            step = {1 << whole(0, 6), 1 << whole(0, 6), 1 << whole(0, 6)};
            step[leaves] = unlucky[random.below(unlucky.size())];
        }
        if (is_far) step = {whole(1 << 20, 1 << 22), whole(1 << 20, 1 << 22), whole(1 << 20, 1 << 22)};
        for (int axis = 0; axis < 3; ++axis)
            if (random.below(2) == 0) step[axis] = -step[axis];
        const int t = is_far ? whole(1000, 1 << 15) : i % 2 == 0 ? 1 << whole(0, 3) : whole(1, 9);
        const glm::dvec3 way = static_cast<double>(t) * glm::dvec3(step);
        const glm::dvec3 near_zero{whole(-50, 50), whole(-50, 50), whole(-50, 50)};
        // Far away, the nearest place that floats have.
        const glm::dvec3 point = is_far ? glm::dvec3(glm::vec3(way)) : near_zero;
        const glm::dvec3 forward = (is_far ? 32768.0 : 1.0) * glm::dvec3(glm::sign(step));
        // Back from where the ray leaves, on from where it enters: it has one point in common with such a box.
        glm::dvec3 far = point;
        far[leaves] -= forward[leaves] * whole(1, 20);
        far[enters] += forward[enters] * whole(1, 20);
        // At a corner, or within an edge.
        glm::dvec3 near = point;
        far[other] += forward[other] * whole(1, 20);
        if (i % 4 < 2) near[other] -= forward[other] * whole(1, 20);
        const BoundingBox box{glm::vec3(min(near, far)), glm::vec3(max(near, far))};
        BoxShot hit{Ray{glm::vec3(point - way), glm::vec3(step)}, box};
        BoxShot miss = hit;
        miss.ray.origin[leaves] += static_cast<float>(step[leaves]);
        add_pair(shots, hit, miss, random);
    }
    return shots;
}

}
