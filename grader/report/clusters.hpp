#pragma once

#include <string>
#include <vector>

#include "model/scorecard.hpp"

namespace umbral::grader {

/// Submissions whose unit fails for the same reason.
struct Cluster {
    std::string name;                    ///< "far root", "far root or near root", "no explanation", "crashed"
    std::vector<std::string> sentences;  ///< one each that matches equally well; none if there is no explanation
    double confidence = 0;               ///< the median
    std::vector<std::size_t> who;        ///< places in the class result
};

/// A unit that somebody did not get right.
struct UnitClusters {
    std::string unit;
    std::size_t graded = 0;          ///< submissions that hold the unit; faults of the grader's count nowhere
    std::vector<Cluster> explained;  ///< by one reason, the largest first
    std::vector<Cluster> ambiguous;  ///< by one of several, the largest first
    std::vector<Cluster>
        unexplained;  ///< "no explanation", and one for each verdict that stopped the work, the largest first
    std::vector<std::size_t> missing;  ///< places of those who handed in nothing that could be read

    /// That failed: what is missing is not among them.
    [[nodiscard]] std::size_t submissions() const;
};

/// By what is said first of each unit; the unit with most failing submissions first. What is right or not written needs
/// no reason.
[[nodiscard]] std::vector<UnitClusters> clusters(const ClassResult& result);

}
