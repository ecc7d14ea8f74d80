#pragma once

#include "polygons.hpp"

/// Tasks whose answers are small numbers, and those of which nothing comes.
namespace umbral::raytracing {

inline FlatPolygon floor_square() { return rectangle({0, 0, 0}, {0, 0, 8}, {8, 0, 0}); }

inline std::vector<ShadowTask> shadows_by_hand()
{
    const FlatPolygon floor = floor_square();
    const FlatPolygon straight_corner = {{0, 0, 0}, {0, 0, 4}, {0, 0, 8}, {8, 0, 8}, {8, 0, 0}};
    const FlatPolygon shelf = rectangle({3, 2, 3}, {0, 0, 1}, {2, 0, 0});
    const glm::vec4 lamp(4, 4, 4, 1);
    const glm::vec4 sun(1, 2, -1, 0);
    return {
        {lamp, shelf, floor},
        {sun, shelf, floor},
        {0.001F * sun, shelf, floor},
        {sun, rectangle({3, 0.004F, 3}, {0, 0, 1}, {2, 0, 0}), floor},  // nearly on the floor
        {7.0F * sun, shelf, floor},                                     // a direction has any length
        {sun, shelf, rectangle({1, 1, 1}, {0, 0, 6}, {6, 0, 0})},       // a floor that is not at y = 0
        {lamp, turned_over(shelf), floor},                              // casters have two sides
        {lamp, shelf, turned_over(floor)},                         // receivers too: the shadow turns as its receiver
        {lamp, shelf, straight_corner},                            // three corners may lie on a line
        {sun, rectangle({6, 3, 1}, {0, 0, 3}, {4, 0, 0}), floor},  // partly beside the floor
        {sun, rectangle({6, 3, 1}, {0, 0, 3}, {4, 0, 0}), turned_over(straight_corner)},
        {lamp, rectangle({-9, 3, -9}, {0, 0, 40}, {40, 0, 0}), floor},  // larger than all of it
        {lamp, rectangle({3, 0, 2}, {0, 2, 0}, {0, 0, 3}), floor},      // a board that stands on the floor
        {lamp, rectangle({3, -1, 2}, {0, 3, 0}, {0, 0, 3}), floor},     // … and reaches through it
        {lamp, rectangle({5, 2, 2}, {0, 4, 0}, {0, 0, 3}), floor},      // … and past the lamp
        {{4, 4, 4, 1},
         {{1, 1, 1}, {7, 7, 1}, {7, 7, 3}, {1, 1, 3}},
         floor},  // slanted, partly behind the lamp's height
        {sun, rectangle({2, -1, 2}, {0, 3, 0}, {2, 0, 1}), floor},
        {{4, -2, 4, 1}, rectangle({3, -1, 3}, {0, 0, 2}, {2, 0, 0}), floor},  // from below
        {{0, 2, 0, 0}, shelf, floor},                                         // the sun at the zenith
        {{0, 3, 1.5F, 0}, shelf, floor},
        {{0, 4, 0, 1}, rectangle({1, 2, 1}, {0, 0, 1}, {2, 0, 0}), floor},  // above a corner
        {{4, 4, 0, 1}, shelf, floor},
        {{2, -3, 1, 0}, rectangle({4, -2, 3}, {0, 0, 2}, {1, 0, 0}), floor},
        {{0, 4, 4, 1}, shelf, {{8, 0, 1}, {8, 5, 1}, {8, 5, 7}, {8, 0, 7}}},                              // a wall
        {{2, 6, 1, 1}, {{2, 3, 1}, {3, 3, 2}, {2, 3, 3}}, {{0, 0, 0}, {1, 0, 6}, {6, 2, 6}, {5, 2, 0}}},  // a ramp
    };
}

/// Nothing comes of these, but for some between them.
inline std::vector<ShadowTask> without_shadow()
{
    const FlatPolygon floor = floor_square();
    const FlatPolygon shelf = rectangle({3, 2, 3}, {0, 0, 1}, {2, 0, 0});
    const glm::vec4 lamp(4, 4, 4, 1);
    return {
        {lamp, shelf, floor},
        {lamp, rectangle({3, -2, 3}, {0, 0, 1}, {2, 0, 0}), floor},  // below the floor
        {lamp, rectangle({3, 6, 3}, {0, 0, 1}, {2, 0, 0}), floor},   // above the lamp
        {{1, 2, 0, 0}, rectangle({3, 2, 3}, {0, 0, 1}, {2, 0, 0}), floor},
        {lamp, rectangle({20, 2, 3}, {0, 0, 1}, {2, 0, 0}), floor},  // its shadow falls beside
        {lamp, rectangle({4, 1, 4}, {0, 2, 0}, {2, 0, 0}), floor},   // edge on
        {{1, 2, -1, 0}, rectangle({2, 3, 5}, {1, 2, -1}, {2, 4, -2}), floor},
        {lamp, rectangle({2, 0, 2}, {0, 0, 1}, {2, 0, 0}), floor},  // in the floor's plane
        {lamp, shelf, rectangle({0, 4, 0}, {0, 0, 8}, {8, 0, 0})},  // the lamp in the receiver's plane
        {{3, 0, 1, 0}, shelf, floor},                               // the sun on the horizon
        {lamp, rectangle({-2, 2, 3}, {0, 0, 1}, {4, 0, 0}),
         floor},  // touches the border from outside: one side in common
        {{1, 2, -1, 0}, shelf, floor},
        {lamp, {{3, 2, 3}, {3, 2, 4}}, floor},
        {lamp, {{3, 2, 3}}, floor},
        {lamp, {}, floor},
        {lamp, shelf, {}},
        {lamp, shelf, {{3, 0, 3}}},
        {{20, 0, 4, 1}, shelf, floor},                      // the lamp in the floor's plane, the caster above it
        {{20, 0, 4, 1}, shelf, turned_over(floor)},         // … or below
        {lamp, {{3, 0, 2}, {3, -1, 4}, {3, 2, 4}}, floor},  // corners on the floor, of sides that go down
        {lamp, {{3, 0, 2}, {3, 2, 4}, {3, -1, 5}}, floor},
        {lamp, shelf, {{0, 0, 0}, {0, 0, 8}}},
        {{4, -4, 4, 1}, shelf, floor},  // the caster is on the floor's other side
        {lamp, rectangle({3, 1, 3}, {0, 0, 2}, {3, 0, 0}), floor},
    };
}

/// Two mirrors that face each other 4 apart, and one that shows the eye its back.
inline std::vector<MirrorTask> mirrors_by_hand()
{
    const FlatPolygon left = rectangle({0, 0, 0}, {0, 2, 0}, {0, 0, 3});
    const FlatPolygon right = rectangle({4, 0, -1}, {0, 0, 5}, {0, 2, 0});
    const FlatPolygon back = rectangle({1, 0, 0}, {0, 2, 0}, {2, 0, 0});
    const FlatPolygon corner = rectangle({0, 0, 0}, {4, 0, 0}, {0, 2, 0});
    const FlatPolygon behind = rectangle({-3, 0, 0}, {0, 0, 3}, {0, 2, 0});
    return {
        {{1, 1, 1}, {left}, 1},
        {{1, 1, 1}, {left, right}, 1},
        {{1, 1, 1}, {left, right}, 2},
        {{1, 1.5F, 2}, {right, left}, 6},
        {{1, 1, 1}, {left, right}, 0},
        {{1, 1, 2}, {left, corner}, -1},  // no mirrors at all; where whoever goes on for ever has an end
        {{2, 1, 1}, {left, back}, -3},
        {{2, 1, 1}, {left, back}, 3},
        {{1, 1, 1}, {left, turned_over(left)}, 2},
        {{1, 1, 2}, {left, corner}, 3},  // a right angle: seen in both, in either order
        {{0, 1, 1}, {left, corner}, 2},  // the eye in the first one's plane
        {{1, 1, 1}, {left, behind}, 2},  // the second behind the first: the eye alone sees it
        {{1, 1, 1}, {}, 3},
        {{0.02F, 1, 1}, {left}, 1},                                          // the eye close to the mirror
        {{1, 1, 1}, {{}, left, {{4, 0, 0}, {4, 2, 0}}}, 3},                  // mirrors without area
        {{1, 1, 1}, {left, rectangle({4, 5, 0}, {0, 0, 3}, {0, 2, 0})}, 2},  // too high to be seen in the first
        // Between the mirrored eye and the mirror, turned to that eye: not seen.
        {{1, 1, 1}, {left, rectangle({-0.5F, 0, 0}, {0, 2, 0}, {0, 0, -2})}, 2},
        {{1.5F, 1, 1}, {left, rectangle({-0.75F, 0, 2}, {0, 2, 0}, {0, 0, -2}), right}, 3},
        {{2, 1, 1.5F}, {rectangle({-1, 0, 3}, {0, 2, 0}, {-0.5F, 0, -2}), left}, 2},
        // The narrow one is seen in the wide one, but not in its part that is seen in the narrow one.
        {{1, 1, 0.5F}, {rectangle({0, 0, 1}, {0, 2, 0}, {0, 0, 2}), rectangle({4, 0, -6}, {0, 0, 15}, {0, 2, 0})}, 4},
        {{2, 1, 0.5F}, {left, rectangle({2, -1, -1}, {0, 4, 0}, {-4, 0, 4})}, 3},  // one through the other's plane
    };
}

}
