#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "judge/picture/image_rule.hpp"
#include "judge/picture/picture.hpp"

namespace umbral::grader {

/// The rules that are compared. Each gives one number for two pictures, 0 for equal ones, the larger the worse.
enum class PictureRule { ours, rmse, psnr, ssim, gmsd, lab, pixels, three_by_three };

struct PictureRuleInfo {
    PictureRule rule;
    std::string_view name;
    std::string_view unit;
    std::optional<double> published;  ///< a threshold that is in use somewhere, as this number
    std::string_view source;          ///< where
};

/// psnr is not here as a rule to be fitted: it orders pictures as RMSE does; only its usual threshold is another one.
inline constexpr std::array picture_rules{
    PictureRuleInfo{PictureRule::ours, "Umbral", "worst ratio", 1.0, "grader/judge/thresholds.hpp"},
    PictureRuleInfo{PictureRule::rmse, "RMSE", "levels", 5.1, "2 % of the range"},
    PictureRuleInfo{PictureRule::psnr, "PSNR", "levels of RMSE", 8.06, "30 dB"},
    PictureRuleInfo{PictureRule::ssim, "SSIM", "1 - SSIM", 0.01, "0.99"},
    PictureRuleInfo{PictureRule::gmsd, "GMSD", "", std::nullopt, ""},
    PictureRuleInfo{PictureRule::lab, "Lab dE, mean", "dE76", 1.0, "a just noticeable difference"},
    PictureRuleInfo{PictureRule::pixels, "pixel count", "share", 0.001, "0.1 % of the pixels by more than 25 levels"},
    PictureRuleInfo{PictureRule::three_by_three, "3 x 3", "share", 0.01, "1 % of the pixels by more than 10 levels"},
};

using PictureMeasures = std::array<double, picture_rules.size()>;

/// What our rule says: its worst ratio, that of the statistical test for noisy pictures (there 1 is its bound on a
/// probability).
struct OurMeasure {
    double worst = 0;
    ImageRule parts{};  ///< not for noise
};
[[nodiscard]] OurMeasure our_measure(const Picture& student, const Picture& expected, bool noise);

/// All of them. Cost: some 40 ms for 256 x 256.
[[nodiscard]] PictureMeasures measure_by_rules(const Picture& student, const Picture& expected, const OurMeasure& ours);

/// Gradient magnitude similarity deviation of the luma.
/// Based on: W. Xue, L. Zhang, X. Mou, A. Bovik. Gradient Magnitude Similarity Deviation: A Highly Efficient Perceptual
/// Image Quality Index. 2014.
[[nodiscard]] double gradient_deviation(const Picture& student, const Picture& expected);

/// Share of the pixels with no pixel within 10 levels in the other picture's 3 x 3 neighbourhood, in the better of the
/// two directions. Based on: the fuzzy comparison of the Khronos conformance suite (dEQP, tcuFuzzyImageCompare).
[[nodiscard]] double fuzzy_share(const Picture& student, const Picture& expected);

}
