#pragma once

#include <algorithm>

#include "run/outcome.hpp"

namespace umbral::grader {

/// How long a student's code may still be run again: past its crashes, for the reason of a wrong answer, to measure
/// what it costs. That can take dozens of runs, and whoever makes each of them long would make the grader wait for all.
class SpareTime {
public:
    void allow(double seconds) noexcept { left_ = seconds; }
    void spend(double seconds) noexcept { left_ -= seconds; }
    /// A run that waits costs half of its time: the machine may have been busy with others.
    [[nodiscard]] RunOutcome spent_on(RunOutcome run) noexcept
    {
        spend(std::max(run.cpu_seconds, run.wall_seconds / 2));
        return run;
    }
    [[nodiscard]] bool is_left() const noexcept { return left_ > 0; }

private:
    double left_ = 0;
};

}
