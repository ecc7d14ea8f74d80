#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <umbral/record/recorder.hpp>
#include <utility>

namespace umbral {

/// How many basic blocks of counted code have run in this process. Counted are the solutions of units with a check of
/// the judge "cost", which are compiled with -fsanitize-coverage=trace-pc. What they move, fill, compare or search by
/// memmove, memcpy, memset, memcmp and memchr, as std::copy and insertion into a vector do, counts a block for 16
/// bytes; other library functions that they call count nothing.
[[nodiscard]] std::uint64_t blocks_executed() noexcept;

/// Adds to blocks_executed.
void count_blocks(std::uint64_t blocks) noexcept;

/// How many pieces of memory counted code has from `new` at once, from here on. One at a time.
class AllocationCount {
public:
    AllocationCount() noexcept;

    /// The most there were, beside those of before.
    [[nodiscard]] std::int64_t most() const noexcept;

private:
    std::int64_t before_;
};

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
