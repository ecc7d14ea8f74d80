#include "model/time_budget.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/caps.hpp"

namespace umbral::grader {

double TimeBudget::left() const
{
    const std::lock_guard lock(mutex_);
    return left_;
}

void TimeBudget::take(double seconds)
{
    const std::lock_guard lock(mutex_);
    left_ = std::max(0.0, left_ - seconds);
}

UnitBudget::UnitBudget(std::shared_ptr<TimeBudget> shared)
    : shared_(std::move(shared)), own_left_(shared_ ? shared_->each_unit() : 0)
{
}

double UnitBudget::left() const
{
    return shared_ ? own_left_ + shared_->left() : std::numeric_limits<double>::infinity();
}

void UnitBudget::take(double seconds)
{
    taken_ += seconds;
    if (!shared_) return;
    const double own = std::min(own_left_, seconds);
    own_left_ -= own;
    shared_->take(seconds - own);
}

SubmissionBudgets budgets_of_a_submission()
{
    return {std::make_shared<TimeBudget>(caps::compile_seconds, caps::shared_compile_seconds),
            std::make_shared<TimeBudget>(caps::run_seconds, caps::shared_run_seconds)};
}

}
