#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/exercise.hpp"
#include "mutants/build_mutants.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {

/// A small change of a student's own file with which checks that were wrong are right, on inputs of two seeds, and none
/// that was right is wrong.
struct Repair {
    Mutant change;
    std::vector<std::string> mends;  ///< names of checks
};

/// How long is looked, and on which inputs.
struct RepairPlan {
    double seconds = 60;   ///< after so many no further change is tried
    unsigned attempt = 0;  ///< as of `umbral check`
};

struct RepairSearch {
    std::vector<std::string> wrong;  ///< checks, before any change
    std::vector<Repair> repairs;     ///< those that mend most, at most one a line, in the order of lines
    std::size_t tried = 0;           ///< changes; fewer than there are if the time was over
    bool out_of_time = false;        ///< what mends one case may not have been tried in all others
};

/// Looks among a student's file's own mutants for changes that mend it, in the cases that take the shortest time first:
/// what mends one of them is tried in all. Program repair by generating and validating, after: Le Goues, Nguyen,
/// Forrest, Weimer. GenProg: a generic method for automatic software repair. IEEE TSE 38(1), 2012, with changes of one
/// place only. Throws std::runtime_error for faults of the grader's.
[[nodiscard]] RepairSearch try_repairs(Crew& crew, const Exercise& exercise, const BuiltMutants& built,
                                       const RepairPlan& plan);

}
