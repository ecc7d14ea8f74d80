#pragma once

#include <optional>
#include <string>

#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

struct UnsetValues {
    Explanation explanation;
    std::string warnings;  ///< lines in which the compiler names such variables, bounded; for who wrote the files only
};

/// Do answers that earned no point follow from values that were never set? The same files are built and run again with
/// zeros in variables and in memory from `new`, where the student's run had what cannot be right (build/with_zeros.hpp,
/// run/fresh_memory.hpp): if what failing checks look at is different then, although a run like the first one gives the
/// same again, the program reads what it never wrote, or memory that it has given back. Nothing if it is not so, cannot
/// be tried, or if the result is a known mistake.
[[nodiscard]] std::optional<UnsetValues> by_unset_values(Worker& worker, const Exercise& exercise, const Built& built,
                                                         const UnitResult& result, const CaseResults& cases);

}
