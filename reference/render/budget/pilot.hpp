#pragma once

#include <functional>
#include <vector>

#include "render/budget/model.hpp"
#include "render/budget/wish.hpp"
#include "render/rays/draw.hpp"
#include "scene/scene.hpp"

namespace umbral::render::budget {

/// What pictures are drawn of, and how; all of it must outlive this.
struct Stage {
    const scene::Scene& scene;
    DrawList& list;  ///< its depth and bounces are set before each picture
    const rays::World& world;
    int width = 0;
    int height = 0;
    int threads = 0;                ///< as rays::Effort
    std::function<double()> clock;  ///< seconds from any beginning: wall or processor time
};

/// A picture as it is displayed, at the pixels drawn, and what it took.
struct Look {
    Frame frame;
    std::vector<double> shown;  ///< sRGB values in [0, 1], not rounded, three a pixel
    double rays = 0;            ///< that were followed, of all kinds
    double seconds = 0;
};

/// What is displayed of a picture, at one pixel in `every`: as Look::shown.
[[nodiscard]] std::vector<double> shown_of(const Stage& stage, const Frame& frame, int every);

/// Draws one pixel in `every`, all rays spread over their pixels. The rays have the numbers from `first` on: looks of
/// other numbers are parts of one.
[[nodiscard]] Look look_at(const Stage& stage, const Setting& setting, int every, std::uint32_t scrambling,
                           int first = 0);

/// One look of two parts, of all pixels of one stage, that have so many rays through each pixel; depths and ids are
/// those of `a`.
[[nodiscard]] Look joined(const Stage& stage, Look a, int rays_of_a, const Look& b, int rays_of_b);

/// The mean of the products of two lists as long, not empty.
[[nodiscard]] double mean_product(const std::vector<double>& a, const std::vector<double>& b);

/// a - b, of lists as long.
[[nodiscard]] std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b);

/// The error of each of two pictures that differ in their scrambling only: the root of half their mean squared
/// difference.
[[nodiscard]] double error_between(const std::vector<double>& a, const std::vector<double>& b);

struct Pilot {
    Model model;
    int every = 1;       ///< one pixel in so many was drawn
    double seconds = 0;  ///< that it took
};

/// Measures a scene. The noise: two scramblings each of 1, 2, 4 … rays on part of the pixels, until the error that is
/// wished for lies among them, or a tenth of the time that is wished for is spent. What is cut off: pictures by the
/// same rays with and without it, again by two scramblings, since the mean product of two independent differences is
/// the square of the bias alone; tried shorter and shorter until it is beyond the wish.
[[nodiscard]] Pilot fly(const Stage& stage, const Setting& whole, const Wish& wish);

}
