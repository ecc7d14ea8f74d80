#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "bench/judges/rule_table.hpp"

namespace umbral::grader {

/// The scenes for calibration, without noise, drawn with so many pixels on most pictures' side.
struct JudgedSize {
    int side = 0;
    double milliseconds = 0;            ///< of one comparison, the mean over all pairs, processor time
    std::vector<MeasuredPair> pairs{};  ///< by our rule alone
};

/// Judges what umbral-bench-scenes has drawn into `folder`.
[[nodiscard]] JudgedSize judge_scenes(const std::filesystem::path& folder, int side);

/// What each size costs, and how many bugs it shows and catches: of those that are visible in the largest size.
/// In a smaller picture some are no longer to be seen.
[[nodiscard]] std::string resolution_table(std::span<const JudgedSize> sizes);

}
