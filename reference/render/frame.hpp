#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>

namespace umbral::render {

/// What a renderer gives: everything a judge may want to look at, before anything is rounded to 8 bits.
struct Frame {
    Grid<glm::vec4> color;    ///< linear; alpha 1 where something was drawn and 0 elsewhere, colour 0 there;
                              ///< of several rays their mean, so that alpha is a share and multiplied in
    Grid<float> depth;        ///< in [0, 1], 1 where nothing was drawn
    Grid<std::uint32_t> ids;  ///< Draw::id, 0 where nothing was drawn

    Frame() = default;
    Frame(int width, int height)
        : color(width, height, glm::vec4(0)), depth(width, height, 1.0F), ids(width, height, 0U)
    {
    }

    [[nodiscard]] int width() const { return ids.width; }
    [[nodiscard]] int height() const { return ids.height; }
};

}
