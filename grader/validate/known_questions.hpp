#pragma once

#include "worker/seeds.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// The share of a check's rows that a table of answers would have right: rows whose question, and its answer, came with
/// one of a few other seeds as well. Who can make the driver's varied inputs can write down all that are likely. What
/// is not asked by calls of functions, pictures and relations between tables counts as never seen before.
[[nodiscard]] double known_share(Worker& worker, const Exercise& exercise, const Check& check, const SeedPlan& seeds);

}
