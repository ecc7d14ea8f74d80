#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "worker/worker.hpp"

namespace umbral::grader {

/// Workers that share out tasks. They stay warm from task to task: their spawners run, and together they remember the
/// trusted runs that they have seen.
class Crew {
public:
    using Task = std::function<void(Worker&, std::size_t)>;

    /// At most `jobs` workers; each comes when there is a task for it.
    Crew(const Toolchain& tools, std::size_t jobs);
    /// One worker, somebody else's, which must outlive the crew.
    explicit Crew(Worker& only);

    /// Worker::keep_runs for every worker, those to come too.
    void keep_runs(std::shared_ptr<const UnitKeys> keys);

    /// Gives the numbers 0 to count - 1 to the workers, in order; each takes the next number when it is done with one.
    /// The first exception stops all, and is thrown again when every worker has ended.
    void share_out(std::size_t count, const Task& task);

    /// The first of them.
    [[nodiscard]] Worker& first();

private:
    [[nodiscard]] std::vector<Worker*> workers(std::size_t count);

    const Toolchain* tools_ = nullptr;
    std::size_t jobs_ = 1;
    Worker* only_ = nullptr;
    std::shared_ptr<const UnitKeys> keys_;
    std::shared_ptr<SharedRuns> runs_ = std::make_shared<SharedRuns>();
    std::vector<std::unique_ptr<Worker>> own_;
};

/// As many as the machine has processors.
[[nodiscard]] std::size_t default_jobs();

/// A quarter more, at least one: a submission waits now and then for a disk, or for a process of its own to begin or
/// end, and where there are many of them, another one computes meanwhile.
[[nodiscard]] std::size_t default_jobs_of_class();

}
