#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <umbral/core/grid.hpp>
#include <vector>

namespace umbral::bench {

/// What both contestants are given: three of these a triangle.
struct RasterVertex {
    glm::vec4 clip;
    glm::vec3 color;
};

/// Right triangles whose legs have `legs` pixels, two in each square of a grid over a picture of `side` pixels a side,
/// as in a mesh; one layer after another, at random depths and a few 1/256 pixel apart, until some millions of pixels
/// are covered. w goes from 1 to 2. `scattered`: in random order, so that neighbours in the list are far apart on the
/// screen.
[[nodiscard]] std::vector<RasterVertex> raster_workload(int legs, int side, bool scattered);

/// Draws triangles with a depth test (less) and perspective-correct colours into a picture of 8 bits a channel, on one
/// thread.
class RasterContestant {
public:
    virtual ~RasterContestant() = default;
    /// Returns when it is done, as draw() does.
    virtual void clear() = 0;
    /// Clears, and draws the whole list.
    virtual void draw() = 0;
    /// What was drawn last: red, green, blue in the low bytes; top row first.
    [[nodiscard]] virtual Grid<std::uint32_t> picture() const = 0;
};

/// The engine's tiles and rows (render/tiles.hpp, render/raster.hpp), from clip coordinates on as llvmpipe; only the
/// shader is another one.
[[nodiscard]] std::unique_ptr<RasterContestant> make_our_raster(std::span<const RasterVertex> vertices, int side);

/// Mesa's llvmpipe, from buffers filled beforehand, then glFinish. Needs a current gl::OffscreenContext.
[[nodiscard]] std::unique_ptr<RasterContestant> make_gl_raster(std::span<const RasterVertex> vertices, int side);

}
