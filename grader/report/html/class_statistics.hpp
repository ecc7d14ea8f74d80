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
    std::size_t right = 0;                   ///< all points
    double median = 0;                       ///< of the share earned, 0..1
    std::array<std::size_t, 11> by_share{};  ///< nothing; nine steps between, the first above 0 to 10 %, the last all from 80 %; everything
};

/// In the order in which units first appear.
[[nodiscard]] std::vector<UnitStatistics> unit_statistics(const ClassResult& result);

/// Submissions whose unit fails for the same reason.
struct Cluster {
    std::string unit;
    std::string name;  ///< "far root"
    std::string sentence;
    std::vector<std::size_t> who;  ///< places in the class result
};

/// By the first explanation of each unit; the largest first, then by unit and name.
[[nodiscard]] std::vector<Cluster> clusters(const ClassResult& result);

}
