#pragma once

#include <exception>
#include <system_error>
#include <thread>

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
    if (second != nullptr) {
        try {
            thread = std::jthread([&other, &failed, second] {
                try {
                    other(*second);
                } catch (...) {
                    failed = std::current_exception();
                }
            });
        } catch (const std::system_error&) {
            // It is done behind the first.
        }
    }
    const bool is_alone = !thread.joinable();
    first(worker);
    if (is_alone) {
        other(worker);
        return;
    }
    thread.join();
    if (failed) std::rethrow_exception(failed);
}

}
