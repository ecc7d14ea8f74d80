#pragma once

#include <vector>

/// What a picture by rays costs, and how far it lies from the converged one: measured by a pilot, predicted for every
/// setting. Errors are root mean squares of displayed values (sRGB, 0 to 1): what a file holds is what is looked at.
namespace umbral::render::budget {

/// What may be chosen of a picture.
struct Setting {
    int rays = 1;     ///< through each pixel
    int depth = 0;    ///< mirrors and panes of glass that light may meet
    int bounces = 0;  ///< between other surfaces

    friend bool operator==(const Setting&, const Setting&) = default;
};

inline constexpr int most_rays = 65536;

/// The error that the samples' chance makes, without what is cut off.
struct Noise {
    int rays = 1;
    double error = 0;
};

/// Light that is followed less far than the scene says, or as far: then the bias is 0, and the cost 1.
struct Cut {
    int value = 0;
    double bias = 0;  ///< root mean square of what is missing
    double cost = 1;  ///< over that of the scene's own value
};

struct Model {
    std::vector<Noise> noise;        ///< by increasing rays, at least one, the first of one ray; errors may be 0
    std::vector<Cut> depths;         ///< at least one
    std::vector<Cut> bounces;        ///< at least one
    double ray_seconds = 0;          ///< of one ray through every pixel, nothing cut off; > 0
    std::vector<Noise> uneven = {};  ///< measured numbers of rays that are no power of two; may be empty
};

/// How the noise falls with the rays: the slope of its logarithm against theirs, by least squares over the last points
/// (at most four). Never above -1/2: scrambled samples converge at least as fast as independent ones (A. Owen. 1997).
[[nodiscard]] double noise_slope(const Model& model);

/// Of a power of two between measured numbers of rays straight in logarithms, beyond them by the slope, never more for
/// more rays. Other numbers are made of powers of two, each a net of its own, and as if independent: 12 rays have the
/// noise of the mean of 8 and 4, weighted so. That is why 16 rays may be less noisy than 20. What was measured of such
/// a number stands instead.
[[nodiscard]] double noise_of(const Model& model, int rays);

/// What may be chosen: 4, 5, 6, 7 times each power of two, and fewer; 1 to most_rays, increasing.
[[nodiscard]] std::vector<int> numbers_of_rays();

struct Predicted {
    double noise = 0;
    double bias = 0;
    double error = 0;    ///< the root of the sum of their squares
    double seconds = 0;  ///< of following rays: what comes before and after is not in it
};

/// `depth` and `bounces` of the setting must be among the model's. Biases add, as if all of them were of one sign.
[[nodiscard]] Predicted predict(const Model& model, const Setting& setting);

struct Choice {
    Setting setting;
    Predicted predicted;
    bool reached = true;  ///< false: nothing does what was asked, and this is the nearest to it
    int compared = 0;     ///< settings
};

/// The cheapest setting whose error is at most this, > 0; of equal cost the more accurate. Not reached: the one of the
/// smallest error.
[[nodiscard]] Choice cheapest(const Model& model, double error);

/// The most accurate setting that takes at most this time; of equal error the cheaper. Not reached: the quickest one.
[[nodiscard]] Choice most_accurate(const Model& model, double seconds);

}
