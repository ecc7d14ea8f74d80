#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/scorecard.hpp"

namespace umbral::grader::html {

/// What a class earned in one unit. Faults of the grader's count nowhere.
struct UnitStatistics {
    std::string id;
    Millipoints max_score = 0;
    std::size_t graded = 0;
    std::size_t right = 0;  ///< all points
    double median = 0;      ///< of the share earned, 0..1
    std::array<std::size_t, 11>
        by_share{};  ///< nothing; nine steps between, the first above 0 to 10 %, the last all from 80 %; everything
};

/// In the order in which units first appear.
[[nodiscard]] std::vector<UnitStatistics> unit_statistics(const ClassResult& result);

}
