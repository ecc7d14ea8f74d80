#include "bench/judges/resolutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "bench/judges/picture_rules.hpp"
#include "bench/judges/scene_pairs.hpp"
#include "bench/percent.hpp"

namespace umbral::grader {
namespace {

struct Counts {
    std::size_t bugs = 0;
    std::size_t shown = 0;
    std::size_t caught = 0;
    std::size_t harmless = 0;
    std::size_t alarms = 0;
};

Counts count(const JudgedSize& size, const JudgedSize& largest)
{
    Counts counts;
    for (const auto& [name, pair] : size.pairs) {
        if (!pair.harmful) {
            ++counts.harmless;
            counts.alarms += pair.worst > 1 ? 1 : 0;
        }
        const auto there = largest.pairs.find(name);
        if (there == largest.pairs.end() || !there->second.harmful || !there->second.visible) continue;
        ++counts.bugs;
        counts.shown += pair.visible ? 1 : 0;
        counts.caught += pair.worst > 1 ? 1 : 0;
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
        const std::clock_t start = std::clock();
        const OurMeasure found = our_measure(pair.student, pair.expected, false);
        spent += std::clock() - start;
        size.pairs[{pair.scene, pair.change}] = {pair.harmful, !looks_the_same(pair.student, pair.expected),
                                                 found.worst};
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
        const Counts found = count(size, largest);
        text += fmt::format("| {} | {:.2f} ms | {} of {} ({:.1f} %) | {} ({:.1f} %) | {} of {} |\n", size.side,
                            size.milliseconds, found.shown, found.bugs, percent(found.shown, found.bugs), found.caught,
                            percent(found.caught, found.bugs), found.alarms, found.harmless);
    }
    return text;
}

}
