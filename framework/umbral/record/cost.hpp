#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <umbral/record/recorder.hpp>
#include <utility>

namespace umbral {

/// How many basic blocks of counted code have run in this process. Counted are the tenants of units with a check of the judge "cost",
/// which are compiled with -fsanitize-coverage=trace-pc; the library functions that they call are not.
[[nodiscard]] std::uint64_t blocks_executed() noexcept;

/// Runs `work`, the unit on a problem of this size, and records what it took as the row (size, blocks) of the table `name`.
template <class Work>
void record_cost(Recorder& out, std::string_view name, std::size_t size, Work&& work)
{
    const std::uint64_t before = blocks_executed();
    std::forward<Work>(work)();
    out.append(name, glm::dvec2(static_cast<double>(size), static_cast<double>(blocks_executed() - before)));
}

}
