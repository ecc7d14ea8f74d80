#include "build/compile_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "model/caps.hpp"

namespace umbral::grader {

CompileBudget::CompileBudget() : left_(caps::shared_compile_seconds) {}

double CompileBudget::left() const
{
    const std::lock_guard lock(mutex_);
    return left_;
}

void CompileBudget::take(double seconds)
{
    const std::lock_guard lock(mutex_);
    left_ = std::max(0.0, left_ - seconds);
}

UnitBudget::UnitBudget(std::shared_ptr<CompileBudget> shared)
    : shared_(std::move(shared)), own_left_(caps::compile_seconds)
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

std::string no_time_to_compile()
{
    return fmt::format(
        "not compiled since compiling takes too long: each unit may take {:g} s of processor time, and all units of a "
        "submission together {:g} s more, which are used up\n",
        caps::compile_seconds, caps::shared_compile_seconds);
}

}
