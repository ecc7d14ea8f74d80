#pragma once

#include <algorithm>
#include <array>
#include <kit/varied.hpp>
#include <limits>

#include "landscape.hpp"

/// Triangles that are written down.
namespace umbral::pipeline {

inline ClipTriangle reversed(const ClipTriangle& triangle) { return {triangle[2], triangle[1], triangle[0]}; }

// Numbers that can be worked out on paper.
inline std::vector<ClipTriangle> by_hand()
{
    std::vector<ClipTriangle> triangles = {
        {glm::vec4(-0.5F, -0.5F, 0, 1), {0.5F, -0.5F, 0, 1}, {0, 0.5F, 0.5F, 1}},  // inside
        {glm::vec4(1.5F, 0, 0, 1), {2, 0, 0, 1}, {1.5F, 0.5F, 0, 1}},              // beyond the right side
        {glm::vec4(0, 3, 0, 1), {-3, 0, 0, 1}, {-3, 3, 0, 1}},                     // beyond no side alone, yet outside
        {glm::vec4(-0.5F, -0.5F, 0, 1), {2, -0.25F, 0, 1}, {-0.5F, 0.5F, 0, 1}},   // one corner to the right
        {glm::vec4(-3, -0.5F, 0, 1), {0.5F, 0, 0, 1}, {-2, 0.75F, 0, 1}},          // two to the left
        {glm::vec4(0, 0, -3, 2), {0.5F, 0.25F, 1, 2}, {-1, 1, 1.5F, 2}},           // before the near plane
        {glm::vec4(0, 0, 3, 1), {0.5F, 0.25F, 0, 1}, {-1, 0.75F, 0.25F, 1}},       // beyond the far one
        {glm::vec4(-8, -8, 0.25F, 1), {8, -8, 0.25F, 1}, {0, 16, 0.25F, 1}},       // all round
        {glm::vec4(0, 0.25F, 0, 1), {6, 1, 2, 4}, {-2, 1, -1, 4}},       // w differs: nothing to clip at x = 1
        {glm::vec4(0, 0.25F, 0, 1), {12, 1, 2, 4}, {-2, 1, -1, 4}},      // … and here there is
        {glm::vec4(0.5F, 0, 0, 1), {1.5F, 0, 0, -1}, {0, 0.25F, 0, 1}},  // behind the camera: not to the right
        {glm::vec4(0, 0, 0, 2), {1, 0, 0, 2}, {0, 4, 0, -1}},
    };
    triangles.push_back(reversed(triangles[3]));
    triangles.push_back(reversed(triangles[11]));
    return triangles;
}

// Corners and sides exactly on planes. Those that leave nothing stand between some that do.
inline std::vector<ClipTriangle> limits()
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {
        // A corner on the right side, the rest inside.
        {glm::vec4(1, 0, 0, 1), {-0.5F, 0.5F, 0, 1}, {-0.25F, -0.5F, 0, 1}},
        {glm::vec4(1, 0, 0, 1), {-0.5F, 3, 0, 1}, {-0.25F, -0.5F, 0, 1}},   // … and another above
        {glm::vec4(1, 0, 0, 1), {1.5F, 0.5F, 0, 1}, {1.25F, -0.5F, 0, 1}},  // … the rest outside: nothing
        {glm::vec4(1, 0, 0, 1), {1, 0.5F, 0, 1}, {2, 0, 0, 1}},             // a side on it, the rest outside: nothing
        {glm::vec4(1, 0, 0, 1), {1, 0.5F, 0, 1}, {0, 0, 0, 1}},             // … inside
        {glm::vec4(1, 0.25F, 0, 1), {3, 0.5F, 0, 1}, {0, -0.5F, 0, 1}},     // a corner on it, one inside, one outside
        {glm::vec4(-3, -1, 5, 5), {5, -2, 5, 5}, {1, 4, 5, 5}},             // in the far plane: a sky
        {glm::vec4(-1, -1, -1, 1), {3, -1, -1, 1}, {-1, 3, -1, 1}},         // in the near one, over the whole picture
        {glm::vec4(2, 2, 2, 2), {2, -2, 2, 2}, {-2, 2, 2, 2}},              // three corners of the volume
        {glm::vec4(0.5F, 0, 0, 1), {0, 0.5F, 0, 1}, {nan, 0, 0, 1}},        // nonsense
        {glm::vec4(0.5F, 0, 0, 1), {0, 0.5F, 0, 1}, {0, 0, 0, infinity}},
        {glm::vec4(0, 0, 0, infinity), {0.5F, 0, 0, 1}, {0, 0.5F, 0, 1}},
        {glm::vec4(0.5F, 0, 0, 1), {0, 0, 0, infinity}, {0, 0.5F, 0, 1}},
        {glm::vec4(nan, 0, 0, 1), {0.5F, 0, 0, 1}, {0, 0.5F, 0, 1}},
        {glm::vec4(0.5F, 0, 0, 1), {0, 0.5F, -infinity, 1}, {0, 0.5F, 0, 1}},
        {glm::vec4(0, 0, 0, 0), {0.5F, 0, 0, 1}, {0, 0.5F, 0, 1}},               // a corner in the eye
        {glm::vec4(0, -0.0F, 0, 0), {0.5F, 0, 0, 1}, {0, 3, 0, 1}},              // … and a side to cut
        {glm::vec4(0.25F, 0, 0, 1), {-0.5F, 0.5F, 0.5F, 1}, {0, 2, 0, 1}},       // without the eye: something
        {glm::vec4(-3, 0, 0.5F, 1), {0, 0, 0, 0}, {2, 0.25F, 0, 1}},             // … two
        {glm::vec4(0.25F, 0.5F, 0, -1), {0.5F, 0.25F, 0, 1}, {0, 0, 0, -0.0F}},  // … and one behind
        {glm::vec4(0.5F, 0, 0, -1), {0, 0.5F, 0, -1}, {-0.5F, -0.5F, 0, -1}},    // all behind
        {glm::vec4(0, 0.5F, -2, 0), {0.5F, 0, 0, 1}, {-0.5F, 0.125F, 0, 1}},     // a corner in the camera's plane
        {glm::vec4(-1.875F, 1.8125F, 0.0625F, 1),
         {0, -1.875F, 1.8125F, 1},
         {1.8125F, 0.03125F, -1.875F, 1}},  // as many corners as there can be
        // A corner so little beyond the side that the two new ones are the same floats: three corners are left.
        {glm::vec4(1 + 0x1p-23F, 0.75F, 0, 1), {-0.5F, 0.875F, 0, 1}, {-0.5F, 0.625F, 0, 1}},
        {glm::vec4(-0.5F, 0.625F, 0, 1), {1 + 0x1p-23F, 0.75F, 0, 1}, {-0.5F, 0.875F, 0, 1}},
        // Two equal corners inside, or three: nothing.
        {glm::vec4(0.25F, 0.25F, 0, 1), {0.25F, 0.25F, 0, 1}, {-0.5F, 0.5F, 0, 1}},
        {glm::vec4(-0.5F, 0.25F, 0.5F, 2), {0.25F, 0.75F, 0, 1}, {-0.5F, 0.25F, 0.5F, 2}},
        {glm::vec4(0.5F, 0.25F, 0, 1), {0.5F, 0.25F, 0, 1}, {0.5F, 0.25F, 0, 1}},
        // Two corners that differ in w only, and one whose numbers are finite, but not their sum.
        {glm::vec4(0.25F, 0.25F, 0, 1), {0.25F, 0.25F, 0, 2}, {-0.5F, 0.5F, 0, 1}},
        {glm::vec4(0x1p126F, 0x1p125F, 0x1p126F, 0x1p127F), {-0.5F, 0.5F, 0, 1}, {0, -0.5F, 0.25F, 1}},
    };
}

/// Triangles that are written down, in another order, each begun at another corner. The view volume looks the same
/// along all axes, so that they may be swapped and mirrored.
inline std::vector<ClipTriangle> varied(Variation& vary, std::vector<ClipTriangle> triangles)
{
    const ExactMap map = vary.exact_map(0);
    for (ClipTriangle& triangle : triangles) {
        for (glm::vec4& corner : triangle) corner = map.place(corner);
        std::rotate(triangle.begin(), triangle.begin() + vary.one_of(0, std::array{1, 2}), triangle.end());
    }
    return in_random_order(vary, std::move(triangles));
}

}
