#pragma once

#include <cstddef>

#include "render/frame.hpp"

namespace umbral::render {

/// How far apart two renderers' frames of one scene are.
///
/// A pixel is interior if it and its eight neighbours show the same instance in both frames (pixels beyond the border do not count): there
/// only arithmetic differs. Elsewhere a pixel may belong to another instance in each frame, because an edge passes near its centre.
struct Comparison {
    std::size_t pixels = 0;
    std::size_t covered_first = 0;
    std::size_t covered_second = 0;
    std::size_t coverage_differs = 0;  ///< pixels drawn in one frame only
    std::size_t ids_differ = 0;        ///< pixels with another instance, those above included
    std::size_t interior = 0;
    double depth_max = 0;          ///< over interior pixels
    double color_max = 0;          ///< of a channel over interior pixels, in steps of 1/255 of the sRGB value before it is rounded
    double color_mean = 0;         ///< the mean of the same
    std::size_t color_beyond = 0;  ///< interior pixels with a channel further apart than one step
    double color_rmse = 0;         ///< of all pixels and channels, in the same steps
};

/// Throws std::invalid_argument if the sizes differ.
[[nodiscard]] Comparison compare(const Frame& first, const Frame& second);

/// What two right renderers may differ by.
struct Agreement {
    double edge_fraction = 1e-4;   ///< of all pixels: how many may show another instance. Positions are rounded to 1/256 pixel after a division
                                   ///< that may differ in its last bit, so an edge moves by 1/256 where that bit decides.
    double depth = 0x1p-20;        ///< floats near 1 are 2^-24 apart, and a plane equation of four terms is evaluated in two ways
    double color = 1;              ///< steps of 1/255
    double color_fraction = 1e-3;  ///< of interior pixels: how many may be further apart, where a texel's edge or the end of a highlight is hit
};
[[nodiscard]] bool agrees(const Comparison& comparison, const Agreement& agreement = {});

}
