#pragma once

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

}
