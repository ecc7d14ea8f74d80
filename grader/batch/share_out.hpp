#pragma once

#include <cstddef>
#include <functional>

#include "batch/workshop.hpp"

namespace umbral::grader {

/// Gives the numbers 0 to count - 1 to at most `jobs` workers, in order; each worker has a workshop of its own and takes the next number
/// when it is done with one. The first exception stops all, and is thrown again when every worker has ended.
void share_out(const Toolchain& tools, std::size_t count, std::size_t jobs, const std::function<void(Workshop&, std::size_t)>& task);

/// As many as the machine has processors.
[[nodiscard]] std::size_t default_jobs();

}
