#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mutants/mutant.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Percent of a unit's points that such a program may earn: what comes of rounding, and of pixels that are right by
/// chance; of the family echo also what is asked of questions that are their own answers: turned by an angle of 0,
/// clipped by nothing.
constexpr double most_idle_credit(MutantFamily family) { return family == MutantFamily::echo ? 4 : 2; }

/// What a program earns that does nothing.
struct IdleUnit {
    std::string unit;
    MutantFamily family = MutantFamily::idle;
    double credit = 0;                   ///< percent of the unit's points
    std::vector<std::string> earning{};  ///< the checks that it earns points in, as "frames/state 1.00 of 1.00"
    std::string trouble{};               ///< why it could not be tried

    [[nodiscard]] bool holds() const { return trouble.empty() && credit <= most_idle_credit(family); }
};

/// Grades the unit's reference, in which every function returns at once, with the inputs of one seed: with nothing, or,
/// of the family echo, with what it was given. `finder`: umbral-mutate.
[[nodiscard]] IdleUnit try_idle(Worker& worker, const std::filesystem::path& finder, const Exercise& exercise,
                                unsigned seed, MutantFamily family = MutantFamily::idle);

}
