#pragma once

#include "batch/seeds.hpp"
#include "batch/validate.hpp"
#include "batch/worker.hpp"

namespace umbral::grader {

/// Work keeps all of a check's points if with other inputs it earns one part in so many of them.
inline constexpr Millipoints believed_part = 2;

/// Is anything that the check looks at another with another seed? Asked of the reference: of visible cases with two
/// seeds that are the same for all, so that a result depends on nobody else's.
[[nodiscard]] bool has_other_inputs(Worker& worker, const Exercise& exercise, const Check& check,
                                    const SeedPlan& seeds);

/// The share of a unit's points that the right answers to one seed's inputs keep with another's, hidden checks among
/// them: who knows the driver can write these down. Where they earn half of a check's points there, they keep all of
/// them (expect_the_same_of_other_inputs). Counted work is left out, since an answer alone earns nothing there. Holds
/// up to 30 %; the message names the checks.
[[nodiscard]] Finding expect_few_fixed_inputs(Worker& worker, const Exercise& exercise, const SeedPlan& seeds,
                                              unsigned seed);

}
