#pragma once

#include <system_error>
#include <thread>
#include <utility>

namespace umbral::grader {

/// A thread that does this, or one that is not joinable where the machine has no more: then whoever asked does it.
template <class Work>
[[nodiscard]] std::jthread thread_or_none(Work work)
{
    try {
        return std::jthread(std::move(work));
    } catch (const std::system_error&) {
        return {};
    }
}

}
