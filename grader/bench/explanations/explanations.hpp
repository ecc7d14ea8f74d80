#pragma once

#include <string>
#include <vector>

#include "model/exercise.hpp"
#include "model/scorecard.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Failing work whose reason is known, or known to be none of the candidates.
enum class WorkKind : std::uint8_t {
    mistake,    ///< a known mistake as it is
    rounded,    ///< the same, its results rounded otherwise
    left_out,   ///< a known mistake that is not among the candidates: nothing true can be said but by a named transform
    disturbed,  ///< the reference's results spoilt in a way that has no name
    two_mistakes,  ///< some cases from one mistake, the others from another
};

/// What was said of it.
enum class Said : std::uint8_t {
    right,           ///< its own explanation, first and alone
    right_among,     ///< ambiguous, its own among those named
    silent,          ///< nothing
    true_statement,  ///< a named transform that makes every failing check right on which it can be tried
    twin,            ///< another mistake whose recordings are the same, byte for byte, in all cases
    part,            ///< one of the two mistakes
    wrong,           ///< anything else
};

struct ExplainedWork {
    std::string unit;
    unsigned seed = 0;
    WorkKind kind = WorkKind::mistake;
    std::string subject;  ///< the mistake's name, or how the results were spoilt
    Said said = Said::silent;
    std::vector<Explanation> explanations;
};

[[nodiscard]] const char* to_string(WorkKind kind);
[[nodiscard]] const char* to_string(Said said);

/// Explains all such work of one unit, with the inputs of one seed; none of them is a seed of `umbral validate`, on
/// whose the units were made.
[[nodiscard]] std::vector<ExplainedWork> explain_known_work(Worker& worker, const Exercise& exercise, unsigned seed);

/// How often what was said, in all units, in the half on which thresholds were set and in the half held_out(), as lines
/// of text; then every wrong one by name.
[[nodiscard]] std::string explanation_table(const std::vector<ExplainedWork>& work);

/// Whatever was not told by its own reason, or told wrongly, with what was said.
[[nodiscard]] std::string explanation_misses(const std::vector<ExplainedWork>& work);

/// Is the right reason first (alone, or among equals) for at least 95 % of the mistakes, and a wrong one given for less
/// than 1 % of the work that matches none? With `held_out_only`, of the units held out alone.
[[nodiscard]] bool meets_targets(const std::vector<ExplainedWork>& work, bool held_out_only);

}
