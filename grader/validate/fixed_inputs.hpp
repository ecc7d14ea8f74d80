#pragma once

#include "validate/validate.hpp"
#include "worker/seeds.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Whether it is also looked at what a table of the answers to several seeds' inputs keeps (known_share): nine runs of
/// each case.
enum class Tables { tried, passed_over };

/// The share of a unit's points that the right answers to one seed's inputs keep with another's, hidden checks among
/// them: who knows the driver can write these down. Where they earn half of a check's points there, they keep all of
/// them (expect_the_same_of_other_inputs). Counted work is left out, since an answer alone earns nothing there. Holds
/// up to 30 %; the message names the checks.
[[nodiscard]] Finding expect_few_fixed_inputs(Worker& worker, const Exercise& exercise, const SeedPlan& seeds,
                                              unsigned seed, Tables tables);

}
