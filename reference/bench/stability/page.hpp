#pragma once

#include <string>

#include "measure.hpp"
#include "sweeps.hpp"

namespace stability {

struct Measured {
    std::vector<Result> results;
    std::vector<SweepResult> sweeps;
    FiniteResult finite;
    std::uint32_t questions = 0;  ///< a function
    std::uint64_t seed = 0;
};

/// Whether the reference exceeds its bound, or was asked nothing.
[[nodiscard]] bool failed(const Result& result);
[[nodiscard]] bool failed(const SweepResult& result);

/// A page of HTML that needs nothing else.
[[nodiscard]] std::string page_of(const Measured& measured);

}
