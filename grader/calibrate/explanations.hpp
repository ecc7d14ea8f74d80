#pragma once

#include <cstddef>

namespace umbral::grader {

/// What `umbral bench explanations` is asked to do.
struct ExplanationOptions {
    unsigned seeds = 2;    ///< sets of random inputs; none is one that validate uses
    std::size_t jobs = 1;  ///< units at a time
};

}
