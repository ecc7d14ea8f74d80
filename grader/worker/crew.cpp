#include "worker/crew.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "worker/thread_or_none.hpp"

namespace umbral::grader {

Crew::Crew(const Toolchain& tools, std::size_t jobs) : tools_(&tools), jobs_(std::max<std::size_t>(jobs, 1)) {}

Crew::Crew(Worker& only) : only_(&only) {}

std::vector<Worker*> Crew::workers(std::size_t count)
{
    if (only_ != nullptr) return {only_};
    while (own_.size() < std::min(count, jobs_)) {
        own_.push_back(std::make_unique<Worker>(*tools_));
        own_.back()->keep_runs(keys_);
        own_.back()->share_runs(runs_);
    }
    std::vector<Worker*> all;
    for (const auto& worker : own_) all.push_back(worker.get());
    return all;
}

void Crew::keep_runs(std::shared_ptr<const UnitKeys> keys)
{
    keys_ = std::move(keys);
    if (only_ != nullptr) only_->keep_runs(keys_);
    for (const auto& worker : own_) worker->keep_runs(keys_);
}

Worker& Crew::first() { return *workers(1).front(); }

void Crew::share_out(std::size_t count, const Task& task)
{
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> stop = false;
    std::mutex mutex;
    std::exception_ptr fault;
    const auto work = [&](Worker& worker) {
        try {
            for (std::size_t i = next++; i < count && !stop; i = next++) task(worker, i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!fault) fault = std::current_exception();
            stop = true;
        }
    };
    const std::vector<Worker*> all = workers(count);
    // Where there is work for one only, the other processors are idle.
    for (Worker* const worker : all) worker->allow_second(count == 1 && jobs_ > 1);
    {
        std::vector<std::jthread> others;
        // Where there are no more, those that there are do the work.
        for (std::size_t i = 1; i < std::min(all.size(), count); ++i)
            others.push_back(thread_or_none([&work, worker = all[i]] { work(*worker); }));
        if (count > 0) work(*all.front());
    }
    if (fault) std::rethrow_exception(fault);
}

std::size_t default_jobs() { return std::max(1U, std::thread::hardware_concurrency()); }

std::size_t default_jobs_of_class()
{
    const std::size_t processors = default_jobs();
    return processors + (processors + 3) / 4;
}

}
