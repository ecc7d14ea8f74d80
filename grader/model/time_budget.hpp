#pragma once

#include <memory>
#include <mutex>

namespace umbral::grader {

/// Time that the units of one submission may take of one kind: each has something of its own, and all of them share
/// more. So one that takes too much costs the others nothing of their own, and the whole is bounded, whatever is handed
/// in. Units of a submission may take of it on several threads.
class TimeBudget {
public:
    /// In seconds.
    TimeBudget(double each_unit, double shared) : each_unit_(each_unit), left_(shared) {}
    [[nodiscard]] double each_unit() const noexcept { return each_unit_; }
    /// What is left of what all units share.
    [[nodiscard]] double left() const;
    void take(double seconds);

private:
    double each_unit_;
    mutable std::mutex mutex_;
    double left_;
};

/// What a unit may still take of its own and of what it shares. For use by one thread at a time.
class UnitBudget {
public:
    /// Without bounds: only counts.
    UnitBudget() = default;
    explicit UnitBudget(std::shared_ptr<TimeBudget> shared);
    /// Seconds; infinite without bounds.
    [[nodiscard]] double left() const;
    [[nodiscard]] double taken() const noexcept { return taken_; }
    /// Counts what was taken: first of the unit's own.
    void take(double seconds);

private:
    std::shared_ptr<TimeBudget> shared_;
    double own_left_ = 0;
    double taken_ = 0;
};

/// What all units of a submission may take; null for no bound but that of each program.
struct SubmissionBudgets {
    std::shared_ptr<TimeBudget> compiling{};  ///< processor time
    std::shared_ptr<TimeBudget> running{};    ///< of the student's code, as SpareTime counts it
};

/// As much as the caps say.
[[nodiscard]] SubmissionBudgets budgets_of_a_submission();

}
