#include "bench/judges/resolutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <set>
#include <utility>

#include "bench/judges/results.hpp"
#include "bench/judges/scene_pairs.hpp"
#include "bench/percent.hpp"

namespace umbral::grader {
namespace {

struct PairCounts {
    std::size_t bugs = 0;
    std::size_t shown = 0;
    std::size_t caught = 0;
    std::size_t harmless = 0;
    std::size_t alarms = 0;
};

/// A pair by its scene and what was changed there.
std::pair<std::string, std::string> name_of(const MeasuredPair& pair) { return {pair.scene, pair.change}; }

PairCounts count(const JudgedSize& size, const JudgedSize& largest)
{
    std::set<std::pair<std::string, std::string>> bugs;
    for (const MeasuredPair& pair : largest.pairs)
        if (is_bug(pair)) bugs.insert(name_of(pair));
    PairCounts counts;
    for (const MeasuredPair& pair : size.pairs) {
        const bool caught = pair.ours.worst > 1;
        if (!pair.harmful) {
            ++counts.harmless;
            counts.alarms += caught ? 1 : 0;
        }
        if (!bugs.contains(name_of(pair))) continue;
        ++counts.bugs;
        counts.shown += is_bug(pair) ? 1 : 0;
        counts.caught += caught ? 1 : 0;
    }
    return counts;
}

}

JudgedSize judge_scenes(const std::filesystem::path& folder, int side)
{
    JudgedSize size{side};
    std::clock_t spent = 0;
    visit_scenes(folder, [&](const PicturePair& pair) {
        if (pair.noise) return;
        MeasuredPair& measured = size.pairs.emplace_back(unmeasured(pair));
        const std::clock_t start = std::clock();
        measured.ours = our_measure(pair.student, pair.expected, false);
        spent += std::clock() - start;
    });
    const auto pairs = static_cast<double>(std::max<std::size_t>(size.pairs.size(), 1));
    size.milliseconds = 1e3 * static_cast<double>(spent) / CLOCKS_PER_SEC / pairs;
    return size;
}

std::string resolution_table(std::span<const JudgedSize> sizes)
{
    std::string text =
        "| side of most pictures | time of a comparison | bugs that show | bugs caught | false alarms |\n"
        "|---|---|---|---|---|\n";
    if (sizes.empty()) return text;
    const JudgedSize& largest = *std::ranges::max_element(sizes, {}, &JudgedSize::side);
    for (const JudgedSize& size : sizes) {
        const PairCounts found = count(size, largest);
        text += fmt::format("| {} | {:.2f} ms | {} of {} ({:.1f} %) | {} ({:.1f} %) | {} of {} |\n", size.side,
                            size.milliseconds, found.shown, found.bugs, percent(found.shown, found.bugs), found.caught,
                            percent(found.caught, found.bugs), found.alarms, found.harmless);
    }
    return text;
}

}
