#pragma once

#include <CLI/CLI.hpp>

namespace umbral::grader {

// Numbers beyond these are slips: every job is a thread with programs of its own, and a thousand seeds take days.
inline constexpr int most_jobs = 1024;
inline const CLI::Range possible_jobs(1, most_jobs);
inline const CLI::Range possible_seeds(1, 10000);

}
