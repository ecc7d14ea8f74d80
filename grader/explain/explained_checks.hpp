#pragma once

#include <list>
#include <string>
#include <vector>

#include "judge/explain/explain.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// The checks of one case, as explanations are tried on them.
struct CaseChecks {
    std::string name;
    const CaseResult* result = nullptr;
    std::vector<FailingCheck> checks;
    std::size_t failing = 0;
    std::size_t cells = 0;  ///< that are expected: how much work the case is, the same on every machine and day
};

/// By case: those with failing checks first, of both kinds the smallest first, for most candidates are told apart by
/// one case. A failing check with a relation is explained by what is wrong with one of its values, as a check of its
/// own that `plain` keeps; one that holds says nothing. Nor do the checks of a case that is wrong beside itself
/// only: known mistakes and other questions are asked alone.
[[nodiscard]] std::vector<CaseChecks> checks_by_case(Worker& worker, const Exercise& exercise, const UnitResult& result,
                                                     const CaseResults& cases, std::list<Check>& plain);

/// What a check says of a candidate's run. A crash has no signature: the same end speaks neither way, another one
/// against.
[[nodiscard]] Resemblance says_of(const FailingCheck& one, const CaseResult& yours, const RunOutcome& its);

/// Does a reason that students may know explain all, very likely?
[[nodiscard]] bool explains_all(const Explanation& one);

/// Does a known mistake explain all that students see? Its hint says more than can be found out.
[[nodiscard]] bool is_explained(const UnitResult& result);

}
