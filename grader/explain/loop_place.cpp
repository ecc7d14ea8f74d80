#include "explain/loop_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <umbral/record/block_trace.hpp>

#include "build/traced.hpp"
#include "explain/traced_runs.hpp"
#include "text/joined.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_blocks = 1024;  ///< of a loop; of larger ones it says nothing where they are
constexpr std::size_t most_ranges = 3;
constexpr int largest_gap = 3;  ///< lines without code of their own, within a loop

/// "line 4", "lines 6 to 9 and 20".
std::string lines_in_words(const std::set<int>& lines)
{
    std::vector<std::pair<int, int>> ranges;
    for (const int line : lines) {
        if (ranges.empty() || line > ranges.back().second + largest_gap) ranges.emplace_back(line, line);
        ranges.back().second = line;
    }
    if (ranges.size() > most_ranges) ranges.resize(most_ranges);
    std::vector<std::string> words;
    for (const auto& [first, last] : ranges)
        words.push_back(first == last ? fmt::format("{}", first) : fmt::format("{} to {}", first, last));
    return (lines.size() == 1 ? "line " : "lines ") + joined_with_and(words);
}

}

std::string loop_place(Worker& worker, const Exercise& exercise, const Built& built, const CaseResults& cases)
{
    const auto stopped = std::ranges::find_if(cases, [&](const auto& entry) {
        const CaseResult& one = entry.second;
        return !one.hidden && one.reached && one.student.verdict == Verdict::timeout &&
               !slept_long(one.student, exercise.limits);
    });
    if (stopped == cases.end() || !worker.spare_time().is_left()) return "";
    const std::optional<Built> traced = build_traced(worker.tools(), exercise, built);
    if (!traced) return "";
    const RunOutcome run = worker.run_traced(exercise, *traced, stopped->first, stopped->second.seed);
    if (run.verdict != Verdict::ok) return "";
    const std::vector<std::uint32_t> blocks = traced_numbers(run, blocks_of_loop, 1);
    if (blocks.empty() || blocks.size() > most_blocks) return "";
    std::map<std::string, std::set<int>> lines;
    for (const auto& place : places_in(worker, *traced, blocks))
        if (place && place->line > 0 && traced->files.contains(place->file)) lines[place->file].insert(place->line);
    if (lines.empty()) return "";
    const auto& [file, numbers] =
        *std::ranges::max_element(lines, {}, [](const auto& one) { return one.second.size(); });
    return fmt::format("{}: one call runs {} of {} again and again\n", stopped->first, lines_in_words(numbers), file);
}

}
