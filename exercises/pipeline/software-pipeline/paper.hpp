#pragma once

#include "scenes.hpp"

/// Draws that a hand can work out.
namespace umbral::pipeline {

inline constexpr std::array<glm::vec3, 6> paints = {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1},
                                                    {1, 1, 0},          {0, 1, 1}, {1, 0, 1}};

/// Eight by eight pixels, the identity for a matrix: x = -1 is the left border, x = -0.75 one pixel from it.
inline Call on_paper(const std::vector<glm::vec3>& places)
{
    Call call;
    call.width = call.height = 8;
    call.state.viewport = {0, 0, 8, 8, 0, 1};
    for (std::size_t i = 0; i < places.size(); ++i) call.vertices.push_back({places[i], paints[i % paints.size()]});
    for (unsigned i = 0; i + 2 < places.size(); i += 3) call.triangles.emplace_back(i, i + 1, i + 2);
    return call;
}

}
