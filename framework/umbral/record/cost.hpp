#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <umbral/record/recorder.hpp>
#include <utility>

namespace umbral {

/// How many basic blocks of counted code have run in this process. Counted are the solutions of units with a check of
/// the judge "cost", which are compiled with -fsanitize-coverage=trace-pc; the library functions that they call are
/// not.
[[nodiscard]] std::uint64_t blocks_executed() noexcept;

/// One table of costs, and how many of its sizes are worked on: what a run is asked for whose work is measured from
/// outside.
struct CostLimit {
    std::string table;
    std::size_t sizes = 0;
};

/// From now on record_cost works on the first sizes of this one table only, and leaves out all other work.
void limit_costs(CostLimit limit);

/// Is the next row of this table of costs to be worked on? Yes, unless a limit leaves it out.
[[nodiscard]] bool cost_is_wanted(const Recorder& out, std::string_view table);

/// Runs `work`, the unit on a problem of this size, and records what it took as the row (size, blocks) of the table
/// `name`. Does neither where cost_is_wanted says no.
template <class Work>
void record_cost(Recorder& out, std::string_view name, std::size_t size, Work&& work)
{
    if (!cost_is_wanted(out, name)) return;
    const std::uint64_t before = blocks_executed();
    std::forward<Work>(work)();
    out.append(name, glm::dvec2(static_cast<double>(size), static_cast<double>(blocks_executed() - before)));
}

}
