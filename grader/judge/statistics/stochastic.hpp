#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "judge/picture/picture.hpp"

namespace umbral::grader {

/// Estimates of light, plane by plane, row by row.
struct Estimates {
    int width = 0;
    int height = 0;
    int channels = 0;
    bool tiled =
        true;  ///< a picture, judged in tiles too; else a table: one column of replicates, a channel for each quantity
    std::vector<double> values;   ///< finite
    std::vector<double> steps{};  ///< of pictures of bytes: how far the next code lies from each value; else empty
};

/// A picture of bytes, decoded from sRGB: light is what averages. Alpha is left out.
[[nodiscard]] Estimates light_of(const Picture& picture);

/// Differences of means that are no noise and yet forgiven.
struct Forgiven {
    double relative = 0;  ///< share of the expected mean
    double absolute = 0;
};
/// Of pictures of bytes. The width of rounding, and what clipping at white takes from the noisier of two, are forgiven
/// besides.
inline constexpr Forgiven forgiven_bytes{0.005, 0};
/// Of floats: what sums of some hundred roundings can do.
inline constexpr Forgiven forgiven_floats{2e-5, 0};

/// The largest factor by which two tails of a weighted sum of random signs exceed two normal ones: 1 / (2 erfc(1)).
/// Based on: V. Bentkus, D. Dzindzalieta. A Tight Gaussian Bound for Weighted Sums of Rademacher Random Variables.
/// Bernoulli 2015.
inline constexpr double tail_factor = 3.179;

/// In what two results differ most, beyond noise.
enum class Worst {
    tile,      ///< light in one part of the picture
    place,     ///< where the whole picture lies
    sharpness  ///< how sharp it is: positive where yours is sharper
};

/// How likely two Monte Carlo results have the same expectation.
struct StochasticRule {
    bool agree = false;
    double probability =
        1;  ///< an upper bound for the chance that noise alone gives a tile at least as far off as the worst
    double worst_z = 0;  ///< of the worst tile, in standard deviations of its sum; positive where yours is larger
    Worst worst = Worst::tile;
    bool by_pixels = false;  ///< where the place is worst: it would lie better if it were moved by a whole pixel
    int right = 0;           ///< then: 1 if yours lies too far to the right, -1 to the left
    int down = 0;            ///< and 1 if too far down, -1 up; one of the two is 0
    int x = 0;               ///< left, top and size of that tile
    int y = 0;
    int width = 0;
    int height = 0;
    int channel = 0;   ///< 0 red (or grey), 1 green, 2 blue; of a table the component
    int channels = 1;  ///< of how many
    bool tiled = true;
    double yours = 0;     ///< its mean (light: 0 .. 1, linear) …
    double expected = 0;  ///< … and the expected one
    double misplaced =
        0;  ///< share of the light in the wrong place, beyond noise: largest over the sizes of tiles; 0 .. 1
    std::size_t tests = 0;  ///< tiles times channels, of all sizes

    /// "the light is 3 % too high in the tile …": one line, empty if they agree. `quantity` names a table's component.
    [[nodiscard]] std::string message(const std::string& quantity = "") const;
};

/// Chance of a false alarm for a pair of right pictures that are judged by themselves (`umbral compare`).
inline constexpr double stochastic_alpha = 1e-4;

/// Compares two noisy results of one shape whose cells are independent estimates of the same values; `agree` means a
/// probability of at least stochastic_alpha.
///
/// In tiles of 16 x 16 and of 64 x 64 pixels, and in the whole picture (of a table: in each component), R is the sum of
/// the differences over the root of the sum of their squares. Where both estimate alike, a difference and its negative
/// are equally likely, pixel by pixel, whatever its distribution; then two normal tails at |R| bound the chance up to a
/// factor of 3.179 for every number of pixels (and are exact in the limit), which that factor makes a guarantee. Where
/// the two estimate differently, and differences are skewed, the leading term of the tail's deviation is added, if it
/// makes the tail heavier. Sidak's correction covers all tiles and channels.
///
/// A local mistake shows in a small tile, a wrong factor everywhere in the large ones, and a picture that lies a pixel
/// beside its place, which moves no tile's mean, in alignment_sums(); nor does a shadow that is hard and should be
/// soft, or a lens that is too small: sharpness_sums() shows these. A filter that spreads samples over neighbouring
/// pixels, or one seed for all pixels, makes them depend on each other: then the test is too strict. Based on: K. Subr,
/// J. Arvo. Statistical Hypothesis Testing for Assessing Monte Carlo Estimators. Pacific Graphics 2007; V. Bentkus, D.
/// Dzindzalieta. A Tight Gaussian Bound for Weighted Sums of Rademacher Random Variables. Bernoulli 2015; B.-Y. Jing,
/// Q.-M. Shao, Q. Wang. Self-Normalized Cramer-Type Large Deviations for Independent Random Variables. Annals of
/// Probability 2003.
[[nodiscard]] StochasticRule apply_stochastic_rule(const Estimates& yours, const Estimates& expected,
                                                   const Forgiven& forgiven);

/// The same for pictures of bytes.
[[nodiscard]] StochasticRule apply_stochastic_rule(const Picture& yours, const Picture& expected);

/// Is one of the two so much noisier that equal means prove nothing? Whoever adds enough noise to anything, or puts all
/// light into one pixel of each tile, hides every bias from the test of means. Here all values are cut at four expected
/// means: if the means of their sizes then differ by more than half, beyond chance, the two are not comparable. Correct
/// work is accused with a chance below a hundredth of check_alpha().
[[nodiscard]] bool scatters_apart(const Estimates& yours, const Estimates& expected);

/// Do the means of the sizes themselves, nothing cut, differ by more than half in any channel, beyond chance? Then
/// noise hides nothing: what is wrong is a bias that anybody sees.
[[nodiscard]] bool is_far_off(const Estimates& yours, const Estimates& expected);

/// Is light that is nowhere negative more than half taken away again by negative estimates? Huge ones of either sign,
/// now and then, have in scatters_apart() whatever mean is expected.
[[nodiscard]] bool cancels_itself(const Estimates& yours, const Estimates& expected);

/// How many times as widely as the expected estimates yours scatter, in standard deviations, where that hides a bias:
/// the widest of a table's components, or of a picture's channels in all but an eighth of the smallest tiles that prove
/// something (noise is known from the differences of neighbours). Where a bias of a tenth would still be told, nothing
/// is hidden, and the scatter is 0.
///
/// Whoever multiplies one estimate in thirty by some twenty, of either sign, hides all that is wrong with the others
/// behind a scatter of 3: how much right work needs, each check says (NoiseParameters).
[[nodiscard]] double hiding_scatter(const Estimates& yours, const Estimates& expected);

/// Sums over a tile of two results.
struct TileSums {
    double count = 0;
    double yours = 0;  ///< of the absolute values
    double expected = 0;
    double total = 0;  ///< of the expected values with their signs
    double difference = 0;
    double squares = 0;  ///< of differences
    double cubes = 0;
    double steps = 0;    ///< of rounding at the expected values
    double clipped = 0;  ///< cells that are white in one of the pictures: how much brighter they are was cut off
    TileSums& operator+=(const TileSums& other);
};

/// Sums of differences d, each times what the pixels round it show.
struct PatternSums {
    TileSums sums;
    double misplaced = 0;  ///< light in the wrong place, at least: the size of the sum of d times the weights' signs
};

/// How much less two pictures differ, in the sum of squares, if yours is moved a pixel one way along an axis (x, or y
/// if `vertical`) than the other way. `sums.difference` is positive where yours must move on to lie as expected (it
/// lies too far left, or up); deviation_of() and tile_probability() hold for `sums` as for a tile's.
///
/// They are sums of d g / mean |g| over the pixels inside the border, d the difference there and g Sobel's slope of the
/// mean of both pictures, taken from the eight pixels round it: but at the border, the sums of squares of the three
/// alignments on one side less those on the other, weighted 1, 2, 1, are -16 sum d g. Exchanging the two pictures at a
/// pixel turns the sign of its d, and leaves its g: so here too all signs are equally likely, whatever the sizes. Where
/// the two estimate differently, terms of neighbours are correlated, but never positively.
[[nodiscard]] PatternSums alignment_sums(const Estimates& yours, const Estimates& expected, int channel, bool vertical);

/// How much sharper yours is than it should be, for each of three sizes, each channel, and each colour of a chessboard:
/// `sums.difference` is positive where it is sharper.
///
/// They are sums of d h / mean |h|, d the difference in a pixel (then in cells of 2 x 2, and of 4 x 4), and h how much
/// lighter the mean of both pictures is next to it than a knight's move away. What is too soft lacks light where it
/// gathers, and has it where it is dark between. All that h is read from has the other colour of the chessboard: so
/// exchanging the two pictures at a pixel turns the sign of its d and leaves its h, and terms of one colour do not
/// depend on each other even where the two estimate differently.
[[nodiscard]] std::vector<PatternSums> sharpness_sums(Estimates yours, Estimates expected);

/// Do two pictures differ less, in the sum of squares of all channels inside the border, if yours is first moved by
/// (right, down) pixels, each -1, 0 or 1?
[[nodiscard]] bool lies_better_moved(const Estimates& yours, const Estimates& expected, int right, int down);

/// R of a tile, less what is forgiven; positive where yours is larger.
[[nodiscard]] double deviation_of(const TileSums& sums, const Forgiven& forgiven);

/// The p-value of one tile: uniform where differences are symmetric and nothing is forgiven, up to what the limit
/// leaves.
[[nodiscard]] double tile_probability(const TileSums& sums, double deviation);

/// Pixels from left to before right, and from top to before bottom.
struct TilePlace {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
};

/// A channel cut into across x down tiles, row by row.
struct Tiling {
    int across = 1;
    int down = 1;
    std::vector<int> left;  ///< of each column of tiles, and the width behind the last
    std::vector<int> top;   ///< of each row, and the height
    std::vector<TileSums> sums;

    /// Of tile n.
    [[nodiscard]] TilePlace place(std::size_t n) const;
};

/// One channel in tiles of all sizes, the smallest first (16 x 16 pixels, then 64 x 64; larger by less than a pixel or
/// a small tile where that does not fit), the whole last. A table is one tile.
[[nodiscard]] std::vector<Tiling> tilings_of(const Estimates& yours, const Estimates& expected, int channel);

}
