#pragma once

#include <cstdint>
#include <optional>

#include "model/exercise.hpp"
#include "run/spawner.hpp"

namespace umbral::grader {

/// What the trusted recordings alone decide of a check, whoever is graded.
struct CheckBasis {
    double control = 0;  ///< the fraction right of the best control (judge.hpp), which earns nothing
    std::optional<double> reference_error{};  ///< of a hard check: how far the reference is from the oracle
};

/// `expected_run` is the oracle's or the reference's, by judged_against(); `seed` is the case's, by which controls make
/// noise. Throws std::runtime_error if a run lacks the value, and std::invalid_argument if the check cannot be judged:
/// grader faults.
[[nodiscard]] CheckBasis basis_of(const Check& check, const RunOutcome& expected_run, const RunOutcome& reference_run,
                                  std::uint64_t seed);

}
