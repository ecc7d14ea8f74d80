#pragma once

#include <memory>
#include <mutex>
#include <string>

namespace umbral::grader {

/// The processor time in which a submission's units are compiled. Each unit has caps::compile_seconds of its own, and
/// all of them share caps::shared_compile_seconds. So one that takes too much costs the others nothing of their own,
/// and the whole is bounded, whatever is handed in. Units of a submission may be built by several threads.
class CompileBudget {
public:
    CompileBudget();
    [[nodiscard]] double left() const;
    void take(double seconds);

private:
    mutable std::mutex mutex_;
    double left_;
};

/// What a unit may still take of its own and of what it shares. For use by one thread at a time.
class UnitBudget {
public:
    /// Without bounds: only counts.
    UnitBudget() = default;
    explicit UnitBudget(std::shared_ptr<CompileBudget> shared);
    /// Seconds; infinite without bounds.
    [[nodiscard]] double left() const;
    [[nodiscard]] double taken() const noexcept { return taken_; }
    /// Counts what was taken: first of the unit's own.
    void take(double seconds);

private:
    std::shared_ptr<CompileBudget> shared_;
    double own_left_ = 0;
    double taken_ = 0;
};

/// Why files were not compiled for which no time was left: for the student.
[[nodiscard]] std::string no_time_to_compile();

}
