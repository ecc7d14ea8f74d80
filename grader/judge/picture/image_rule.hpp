#pragma once

#include <array>

#include "judge/picture/image_displacement.hpp"
#include "judge/picture/image_windows.hpp"
#include "judge/picture/picture.hpp"

namespace umbral::grader {

/// Wrong pixels: all, and those where the expected picture shows its background.
struct WrongPixels {
    double all = 0;
    double outside = 0;
};

/// Where what the combined rule measured lies: for what is said about it; it decides nothing.
struct ImagePlaces {
    double background = 0;       ///< pixels where the expected picture shows its background
    bool is_plain = false;       ///< its background covers most of its border: else it may be any surface
    WrongPixels edges;           ///< those of (a)
    WrongPixels interior;        ///< those of (b)
    double bias = 0;             ///< (c), as the mean over all that either picture draws, in levels
    double edge_bias = 0;        ///< mean difference of the edge pixels that (a) forgives, in the channel of (c)
    bool bias_at_edges = false;  ///< most of (c) is theirs
    int cluster_holes = 0;       ///< of the pixels of (e), those where yours shows the background …
    int cluster_extra = 0;       ///< … and those where it alone draws something
};

/// What the combined rule measured: seven ratios of a measure to its threshold (thresholds.hpp); the picture passes if
/// none exceeds 1.
///
/// Shares are of the expected picture's content (pixels that differ from its background), so that drawing more cannot
/// thin errors out.
struct ImageRule {
    double edge_share = 0;      ///< (a) pixels with no similar one in the other picture's 3x3 neighbourhood
    double interior_share = 0;  ///< (b) pixels of another colour where the expected picture is smooth
    double bias =
        0;  ///< (c) mean difference of the worst channel over the content of either picture, in levels, signed
    int shift_x = 0;        ///< (d) the student's picture lies this many pixels to the right of the expected one …
    int shift_y = 0;        ///< … and this many below it
    DensestWindow cluster;  ///< (e) where most of the pixels of (a) lie close together: a hole or a crack
    LevelWindow surface;    ///< (f) where a smooth surface has another mean level: a highlight, a lamp or a shadow
    Displacement displacement;  ///< (g) by which part of a pixel edges are displaced: another sampling point
    double content = 0;         ///< number of pixels of the expected content
    ImagePlaces places;         ///< where all that lies
    /// In the order (a) to (g). (f) and (g) stay 0 where the others have cost more already than these two can.
    std::array<double, 7> ratios{};

    [[nodiscard]] double worst() const;
    /// Of (a) to (d), which speak of the whole picture.
    [[nodiscard]] double everywhere() const;
    /// 1 up to a ratio of 1, then falling with its logarithm to 0 at thresholds::zero_ratio. What shows in one window
    /// only, (e) and (f), or as a part of a pixel, (g), costs no more than thresholds::window_ratio does.
    [[nodiscard]] double right() const;
};

/// Measures two pictures of one size. Cost: linear, some 5 ms for 512 x 512 where every pixel differs.
[[nodiscard]] ImageRule apply_image_rule(const Picture& student, const Picture& expected);

/// The most frequent colour on the border of a picture, by channel.
[[nodiscard]] std::array<std::uint8_t, 4> background_of(const Picture& picture);

/// Largest difference over the channels, pixel by pixel without a border, row by row.
[[nodiscard]] std::vector<std::uint8_t> channel_difference(const Picture& a, const Picture& b);

}
