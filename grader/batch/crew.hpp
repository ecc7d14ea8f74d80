#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "batch/workshop.hpp"

namespace umbral::grader {

/// Workers that share out tasks, each with a workshop of its own that stays warm from task to task: its spawners run, and it remembers the
/// trusted runs that it has seen.
class Crew {
public:
    using Task = std::function<void(Workshop&, std::size_t)>;

    /// At most `jobs` workers; each comes when there is a task for it.
    Crew(const Toolchain& tools, std::size_t jobs);
    /// One worker, with a workshop of somebody else's, which must outlive the crew.
    explicit Crew(Workshop& only);

    /// Workshop::keep_runs for every worker, those to come too.
    void keep_runs(std::shared_ptr<const UnitKeys> keys);

    /// Gives the numbers 0 to count - 1 to the workers, in order; each takes the next number when it is done with one. The first exception
    /// stops all, and is thrown again when every worker has ended.
    void share_out(std::size_t count, const Task& task);

    /// The first worker's workshop.
    [[nodiscard]] Workshop& first();

private:
    [[nodiscard]] std::vector<Workshop*> workshops(std::size_t count);

    const Toolchain* tools_ = nullptr;
    std::size_t jobs_ = 1;
    Workshop* only_ = nullptr;
    std::shared_ptr<const UnitKeys> keys_;
    std::vector<std::unique_ptr<Workshop>> own_;
};

/// As many as the machine has processors.
[[nodiscard]] std::size_t default_jobs();

}
