#pragma once

#include <string>
#include <vector>

#include "validate/input_gaps.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// What a unit's cases never ask of a function, or hardly ever.
struct FunctionGaps {
    std::string function;  ///< "intersect"
    std::size_t calls = 0;
    std::vector<InputGap> gaps;
};

/// Of each function whose calls the unit's driver records, in all its cases, with so many sets of inputs.
[[nodiscard]] std::vector<FunctionGaps> unit_gaps(Worker& worker, const Exercise& exercise, unsigned sets);

}
