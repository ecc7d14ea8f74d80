#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "cli/application.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// For commands that draw goal pictures: builds the units that a checkout lacks, then calls `draw` with the number of
/// each unit, on all processors. What the reference gives is kept for the next call, and for the first check. Says that
/// it takes a while where there are many units. Throws UsageError as have_built does, and what `draw` throws.
void draw_goal_pictures(const Application& application, const std::vector<Exercise>& exercises,
                        const std::function<void(Worker& worker, std::size_t unit)>& draw);

}
