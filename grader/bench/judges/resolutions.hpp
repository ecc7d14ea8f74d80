#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace umbral::grader {

/// What the image rule makes of a pair of pictures.
struct JudgedPair {
    bool harmful = false;
    bool visible = false;  ///< does a channel differ by more than two levels somewhere?
    double worst = 0;      ///< ratio to the threshold
};

/// The scenes for calibration, without noise, drawn with so many pixels on most pictures' side.
struct JudgedSize {
    int side = 0;
    double milliseconds = 0;  ///< of one comparison, the mean over all pairs, processor time
    std::map<std::pair<std::string, std::string>, JudgedPair> pairs{};  ///< by scene and change
};

/// Judges what umbral-bench-scenes has drawn into `folder`.
[[nodiscard]] JudgedSize judge_scenes(const std::filesystem::path& folder, int side);

/// What each size costs, and how many bugs it shows and catches: of those that are visible in the largest size.
/// In a smaller picture some are no longer to be seen.
[[nodiscard]] std::string resolution_table(std::span<const JudgedSize> sizes);

}
