#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mutants/equivalents.hpp"
#include "mutants/mutant.hpp"
#include "mutants/try_mutant.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {

/// A mutant, what became of it, and why it may survive, if that is known.
struct TriedMutant {
    Mutant mutant;
    Trial trial;
    std::string reason{};  ///< of an equivalent one
};

/// A unit's mutants.
struct UnitMutants {
    std::string unit;
    std::string file;  ///< the reference's, below the folder of references: "raytracing/sphere.cpp"
    std::vector<TriedMutant> mutants;
    std::size_t not_compiled = 0;
    std::vector<Equivalent> stale{};  ///< entries of mutants.json about no mutant that survives
    std::string trouble{};            ///< why there are none, if something is wrong

    [[nodiscard]] std::size_t killed() const;
    /// Those that no check notices and nobody has looked at.
    [[nodiscard]] std::vector<const TriedMutant*> survivors() const;
    /// No survivor, no entry that is out of date, no trouble.
    [[nodiscard]] bool holds() const;
};

/// Tries the mutants of this family of the units' references, which `finder` (umbral-mutate) finds, with the inputs of
/// one seed. Units in GLSL have none and are left out. Calls `done` with each unit's result, in the order of
/// `exercises`.
void try_units(Crew& crew, MutantFamily family, const std::filesystem::path& finder,
               std::span<const Exercise> exercises, unsigned seed, const std::function<void(const UnitMutants&)>& done);

}
