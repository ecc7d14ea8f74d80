#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mutants/mutant.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// What a program earns that does nothing.
struct IdleUnit {
    std::string unit;
    double credit = 0;                 ///< percent of the unit's points
    std::vector<std::string> earning;  ///< the checks that it earns points in, as "frames/state 1.00 of 1.00"
    std::string trouble{};             ///< why it could not be tried

    double most_credit = 2;  ///< percent: what comes of rounding, and of pixels that are right by chance

    [[nodiscard]] bool holds() const { return trouble.empty() && credit <= most_credit; }
    /// Of what gives back its question, since some are their own answers: turned by an angle of 0, clipped by nothing.
    static constexpr double most_credit_of_echo = 4;
};

/// Grades the unit's reference, in which every function returns at once, with the inputs of one seed: with nothing, or,
/// of the family echo, with what it was given. `finder`: umbral-mutate.
[[nodiscard]] IdleUnit try_idle(Worker& worker, const std::filesystem::path& finder, const Exercise& exercise,
                                unsigned seed, MutantFamily family = MutantFamily::idle);

}
