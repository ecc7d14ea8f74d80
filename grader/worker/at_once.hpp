#pragma once

#include <exception>
#include <thread>

#include "worker/thread_or_none.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Calls `first` with this worker, and `other` with its second one at the same time; one after the other with this one
/// where there is no second, or no thread to be had. Nothing else may use the second meanwhile. What either throws is
/// thrown when both are done.
template <class First, class Other>
void at_once(Worker& worker, const First& first, const Other& other)
{
    Worker* const second = worker.second();
    std::exception_ptr failed;
    std::jthread thread;
    if (second != nullptr)
        thread = thread_or_none([&other, &failed, second] {
            try {
                other(*second);
            } catch (...) {
                failed = std::current_exception();
            }
        });
    first(worker);
    if (!thread.joinable()) {
        other(worker);
        return;
    }
    thread.join();
    if (failed) std::rethrow_exception(failed);
}

}
