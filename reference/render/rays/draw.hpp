#pragma once

#include <functional>

#include "render/draw_list.hpp"
#include "render/frame.hpp"
#include "render/rays/counts.hpp"
#include "render/rays/world.hpp"

namespace umbral::render::rays {

/// What is spent on a picture.
struct Effort {
    int rays = 1;             ///< through each pixel, >= 1: the first through its centre, the others spread over it
    int first = 0;            ///< the number of the first of them: pictures of other numbers are parts of one picture
    int threads = 0;          ///< 0: as many as the machine has processors
    bool local_only = false;  ///< no shadows, mirrors, glass, lens or bounces: what rasterisers draw
    bool spread = false;  ///< the first ray too: the mean of the pictures of all scramblings is then the converged one
    int every = 1;        ///< only every such pixel is drawn (is_drawn); the others stay empty
    std::function<void(double)> progress{};  ///< told the share that is drawn, by one thread after each of its rows
    std::uint32_t scrambling = 0;            ///< pictures of different ones are independent where all rays are spread
};

/// Pixels that lie evenly over a picture, one in `every` of them, in rows that do not follow its columns.
[[nodiscard]] bool is_drawn(int every, int x, int y);

/// Draws by following rays (light.hpp): shadows, mirrors, glass, bump maps, lenses, lights with a size, light between
/// surfaces. Depth and ids are those of the first ray, from the middle of the lens. The picture is the same, bit by
/// bit, whatever the number of threads. Throws std::invalid_argument if a side is not 1 to 16384 pixels, or if there
/// are no rays. What was followed is added to `counts`, unless that is null.
[[nodiscard]] Frame draw_by_rays(const DrawList& list, int width, int height, const Effort& effort,
                                 RayCounts* counts = nullptr);

/// The same of a world that stands already, for several pictures of it. How deep rays go is read from its draw list.
[[nodiscard]] Frame draw_by_rays(const World& world, int width, int height, const Effort& effort,
                                 RayCounts* counts = nullptr);

}
