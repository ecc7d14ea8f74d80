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
    /// What a run costs: its time, in which it may have slept, but for what a machine that is busy with others took.
    [[nodiscard]] static double cost_of(const RunOutcome& run) noexcept
    {
        return std::max(run.cpu_seconds, run.wall_seconds - run.waited_seconds);
    }
    [[nodiscard]] RunOutcome spent_on(RunOutcome run) noexcept
    {
        spend(cost_of(run));
        return run;
    }
    [[nodiscard]] bool is_left() const noexcept { return left_ > 0; }
    [[nodiscard]] double left() const noexcept { return left_; }

private:
    double left_ = 0;
};

}
