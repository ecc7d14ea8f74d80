#pragma once

#include <cstddef>

#include "render/frame.hpp"

namespace umbral::render {

/// How far apart two renderers' frames of one scene are.
///
/// A pixel is interior if it and its eight neighbours show the same instance in both frames (pixels beyond the border
/// do not count): there only arithmetic differs. Elsewhere a pixel may belong to another instance in each frame,
/// because an edge passes near its centre.
struct Comparison {
    std::size_t pixels = 0;
    std::size_t covered_first = 0;
    std::size_t covered_second = 0;
    std::size_t coverage_differs = 0;  ///< pixels drawn in one frame only
    std::size_t ids_differ = 0;        ///< pixels with another instance, those above included
    std::size_t interior = 0;
    double depth_max = 0;   ///< over interior pixels
    double depth_mean = 0;  ///< the mean of the same
    double color_max =
        0;  ///< of a channel over interior pixels, in steps of 1/255 of the sRGB value before it is rounded
    double color_mean = 0;         ///< the mean of the same
    std::size_t color_beyond = 0;  ///< interior pixels with a channel further apart than Agreement::color
    double color_rmse = 0;         ///< of all pixels and channels, in the same steps
    double color_edge_rmse = 0;    ///< the same of the pixels that are drawn in either frame and not interior
};

/// What two right renderers may differ by.
///
/// Coverage and ids: positions are rounded to 1/256 pixel after a division that may differ in its last bit, so now and
/// then an edge may move. (In the course's scenes none does.) Depth: llvmpipe adds up a plane equation from the
/// window's corner, in float: about 2^-24 times the window's width over the triangle's thickness, so slivers (near a
/// silhouette, or in a small picture of a fine mesh) have the largest errors; allowed is what a width of 512 and a
/// sixteenth of a pixel give. The software side has the exact depth, rounded (tests/render/oracle_test.cpp). Colour:
/// texture coordinates have the same error, and it shows where it meets the edge of a texel. Without textures, colours
/// agree to a hundredth of a step.
struct Agreement {
    double edge_fraction = 1e-4;   ///< of all pixels: how many may show another instance
    double depth_most = 0x1p-11;   ///< at any interior pixel
    double depth_mean = 0x1p-18;   ///< over all of them
    double color = 1;              ///< steps of 1/255, of all interior pixels but …
    double color_fraction = 0.02;  ///< … these
};

/// Throws std::invalid_argument if the sizes differ.
[[nodiscard]] Comparison compare(const Frame& first, const Frame& second, const Agreement& agreement = {});

[[nodiscard]] bool agrees(const Comparison& comparison, const Agreement& agreement = {});

/// In ids, coverage with them, and depth, whatever the colours.
[[nodiscard]] bool agrees_in_shape(const Comparison& comparison, const Agreement& agreement = {});

/// Angles between the normals of two renderers, in degrees, over interior pixels. `first` and `second` are the frames
/// that tell which those are.
struct NormalComparison {
    double largest = 0;
    double mean = 0;
};
[[nodiscard]] NormalComparison compare_normals(const Grid<glm::vec3>& first_normals,
                                               const Grid<glm::vec3>& second_normals, const Frame& first,
                                               const Frame& second);

}
