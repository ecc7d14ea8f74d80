#include <optional>
#include <umbral/record/block_trace.hpp>
#include <umbral/record/cost.hpp>

namespace umbral {
namespace {

// Of the run, which has one thread.
std::uint64_t blocks = 0;
BlockTrace* followed_by = nullptr;
std::optional<CostLimit> limited;

}

std::uint64_t blocks_executed() noexcept { return blocks; }

void count_blocks(std::uint64_t more) noexcept { blocks += more; }

void follow_blocks(BlockTrace* trace) noexcept { followed_by = trace; }

void limit_costs(CostLimit limit) { limited = std::move(limit); }

bool cost_is_wanted(const Recorder& out, std::string_view table)
{
    if (!limited) return true;
    const auto found = out.tensors().find(table);
    return table == limited->table && (found == out.tensors().end() ? 0 : found->second.rows) < limited->sizes;
}

// What the compiler calls at the beginning of each basic block.
extern "C" void __sanitizer_cov_trace_pc()
{
    ++blocks;
    if (followed_by != nullptr) followed_by->pass(reinterpret_cast<std::uintptr_t>(__builtin_return_address(0)));
}  // NOLINT(bugprone-reserved-identifier): the compiler chose the name

}
