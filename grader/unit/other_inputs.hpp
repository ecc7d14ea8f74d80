#pragma once

#include "unit/grade_unit.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {

// The inputs of visible cases are the same for everybody, so that their answers can be written down: by their numbers,
// or under a hash of them. Whoever does that earns, by these cases alone, most of a unit's points without the work.

/// Work keeps all of a check's points if with other inputs it earns one part in so many of them.
inline constexpr Millipoints believed_part = 2;

/// Is anything that the check looks at another with another seed? Asked of the reference: of visible cases with two
/// seeds that are the same for all, so that a result depends on nobody else's.
[[nodiscard]] bool has_other_inputs(Worker& worker, const Exercise& exercise, const Check& check,
                                    const SeedPlan& seeds);

/// Asks visible cases again with inputs that follow from the secret and the work: what a check earned it must earn
/// there too. One that earns a tenth of its points less with two such inputs, one after the other, keeps what the
/// better of the two earned, if it had more than nine tenths of its points, or earned less than half of what it had, or
/// gave fewer right answers than by chance. Work that is right, or wrong in its own way, earns alike with all inputs of
/// a case.
///
/// Counted work keeps its points if it earns half of them there: with answers that were written down it earns nothing.
/// Left alone are hidden checks; and cases whose inputs are the same whatever the seed, unless less
/// than half holds of all that could be asked again: then they keep as much of their points as that.
void expect_the_same_of_other_inputs(Worker& worker, const Exercise& exercise, const Built& built,
                                     const CaseResults& cases, const GradeOptions& options, UnitResult& result);

}
