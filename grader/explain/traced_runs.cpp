#include "explain/traced_runs.hpp"

#include <algorithm>
#include <set>
#include <umbral/record/block_trace.hpp>

#include "explain/same_values.hpp"
#include "explain/source_line.hpp"
#include "judge/rows/tensor_view.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {
namespace {

using Blocks = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Blocks blocks_in(const RunOutcome& run)
{
    const std::vector<std::uint32_t> numbers = traced_numbers(run, blocks_of_questions, 2);
    Blocks blocks;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) blocks.emplace_back(numbers[i], numbers[i + 1]);
    return blocks;
}

}

std::vector<std::uint32_t> traced_numbers(const RunOutcome& run, std::string_view name, std::uint32_t components)
{
    const Tensor* const tensor = tensor_of(run, std::string(name));
    if (tensor == nullptr || !well_formed(*tensor) || tensor->element != Element::uint32 ||
        tensor->components != components || tensor->columns != 1 || tensor->rows > 2 * BlockTrace::most_rows)
        return {};
    std::vector<std::uint32_t> numbers;
    for (const double number : to_doubles(*tensor)) numbers.push_back(static_cast<std::uint32_t>(number));
    return numbers;
}

std::vector<std::optional<SourcePlace>> places_in(const Worker& worker, const Built& traced,
                                                  std::span<const std::uint32_t> blocks)
{
    Toolchain tools = worker.tools();
    tools.budget = traced.budget;
    return places_of(tools, traced.library, blocks);
}

const PlacesOfQuestions* TracedRuns::places(const Check& check, std::uint64_t seed, const RunOutcome& plain)
{
    const auto key = std::pair(check.case_name, seed);
    auto found = runs_.find(key);
    if (found == runs_.end()) {
        Run run{worker_.run_traced(exercise_, traced_, check.case_name, seed), {}};
        run.places = placed(blocks_in(run.outcome));
        found = runs_.emplace(key, std::move(run)).first;
    }
    const Run& run = found->second;
    const Tensor* const yours = tensor_of(run.outcome, check.value);
    const Tensor* const graded = tensor_of(plain, check.value);
    const bool same =
        run.outcome.verdict == Verdict::ok && yours != nullptr && graded != nullptr && are_same_values(*yours, *graded);
    return same && !run.places.empty() ? &run.places : nullptr;
}

PlacesOfQuestions TracedRuns::placed(const Blocks& blocks)
{
    constexpr std::size_t most_at_once = 1024;  // a useful run has some hundred
    std::set<std::uint32_t> fresh;
    for (const auto& [question, block] : blocks)
        if (block != ended_by_exception && !numbers_.contains(block)) fresh.insert(block);
    if (fresh.size() > most_at_once) return {};
    look_up({fresh.begin(), fresh.end()});
    PlacesOfQuestions result;
    for (const auto& [question, block] : blocks) {
        PassedByOne& passed = result[question];
        if (block == ended_by_exception) {
            passed.by_exception = true;
            continue;
        }
        const std::optional<std::uint32_t>& number = numbers_[block];
        if (number && std::ranges::find(passed.places, *number) == passed.places.end())
            passed.places.push_back(*number);
    }
    return result;
}

void TracedRuns::look_up(const std::vector<std::uint32_t>& blocks)
{
    if (blocks.empty()) return;
    const auto found = places_in(worker_, traced_, blocks);
    if (found.empty()) is_readable_ = false;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        std::optional<std::uint32_t>& number = numbers_[blocks[i]];
        if (i >= found.size() || !found[i]) continue;
        const auto file = traced_.files.find(found[i]->file);
        if (file == traced_.files.end()) continue;
        const auto line = source_line(file->second, found[i]->line);
        if (!line || !says_what_runs(*line)) continue;
        const auto known = std::ranges::find(places_, *found[i]);
        number = static_cast<std::uint32_t>(known - places_.begin());
        if (known == places_.end()) places_.push_back(*found[i]);
    }
}

}
