#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <umbral/record/recorder.hpp>
#include <utility>
#include <vector>

namespace umbral {

/// How many basic blocks of counted code have run in this process. Counted are the solutions of units with a check of
/// the judge "cost", which are compiled with -fsanitize-coverage=trace-pc. What they move, fill, compare or search by
/// memmove, memcpy, memset, memcmp and memchr, as std::copy and insertion into a vector do, counts a block for 16
/// bytes; other library functions that they call count nothing.
[[nodiscard]] std::uint64_t blocks_executed() noexcept;

/// Adds to blocks_executed.
void count_blocks(std::uint64_t blocks) noexcept;

class BlockTrace;
/// From now on each block that runs is told to `trace`; null: to nobody.
void follow_blocks(BlockTrace* trace) noexcept;

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

/// Behind the name of a table of costs: what the answers to its work amounted to.
inline constexpr std::string_view cost_answers_suffix = ".answers";

/// Runs `work`, the unit on a problem of this size, and records what it took as the row (size, blocks) of the table
/// `name`. Does neither where cost_is_wanted says no.
///
/// `work` returns some numbers that every right answer leads to, always as many: sizes and sums, say (kit/amount.hpp).
/// They become a row of the table `<name>.answers`: where they differ from the reference's the cost earns nothing,
/// since whoever gives up early saves work. Without a result nobody looks at the answers: only for work whose answers
/// are looked at elsewhere, for the same problems.
template <class Work>
void record_cost(Recorder& out, std::string_view name, std::size_t size, Work&& work)
{
    if (!cost_is_wanted(out, name)) return;
    const std::uint64_t before = blocks_executed();
    const auto take_down = [&] {
        out.append(name, glm::dvec2(static_cast<double>(size), static_cast<double>(blocks_executed() - before)));
    };
    if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
        std::forward<Work>(work)();
        take_down();
    } else {
        const std::vector<float> answers = std::forward<Work>(work)();
        take_down();
        out.append(std::string(name) + std::string(cost_answers_suffix), std::span<const float>(answers));
    }
}

}
