#include "batch/share_out.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace umbral::grader {

void share_out(const Toolchain& tools, std::size_t count, std::size_t jobs, const std::function<void(Workshop&, std::size_t)>& task)
{
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> stop = false;
    std::mutex mutex;
    std::exception_ptr fault;
    const auto work = [&] {
        try {
            Workshop workshop(tools);
            for (std::size_t i = next++; i < count && !stop; i = next++) task(workshop, i);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!fault) fault = std::current_exception();
            stop = true;
        }
    };
    {
        std::vector<std::jthread> workers;
        try {
            for (std::size_t i = 0; i < std::min(std::max<std::size_t>(jobs, 1), count); ++i) workers.emplace_back(work);
        } catch (const std::system_error&) {  // no more threads to be had: those that there are, or this one, do the work
            if (workers.empty()) work();
        }
    }
    if (fault) std::rethrow_exception(fault);
}

std::size_t default_jobs() { return std::max(1U, std::thread::hardware_concurrency()); }

}
