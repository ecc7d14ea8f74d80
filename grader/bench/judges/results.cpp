#include "bench/judges/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/best_time.hpp"
#include "bench/held_out.hpp"
#include "bench/judges/picture_operators.hpp"
#include "bench/percent.hpp"
#include "judge/image/rule.hpp"
#include "judge/rules.hpp"

namespace umbral::grader {
namespace {

constexpr std::array<std::string_view, std::tuple_size_v<decltype(ImageRule::ratios)>> part_names = {
    "edges", "interior", "bias", "shift", "cluster", "surface", "displacement"};

std::vector<MeasuredPair> select(const JudgeBench& bench, bool noise)
{
    std::vector<MeasuredPair> chosen;
    std::ranges::copy_if(bench.pairs, std::back_inserter(chosen),
                         [&](const MeasuredPair& pair) { return pair.noise == noise; });
    return chosen;
}

std::string in_brackets(std::size_t part, std::size_t whole)
{
    return whole == 0 ? "" : fmt::format(" ({:.1f} %)", percent(part, whole));
}

std::string rules_table(const std::vector<MeasuredPair>& pairs)
{
    std::string text = "| rule | threshold | bugs caught | false alarms |\n|---|---|---|---|\n";
    for (const RuleResult& result : compare_rules(pairs)) {
        const auto& info = *std::ranges::find(picture_rules, result.rule, &PictureRuleInfo::rule);
        text +=
            fmt::format("| {} | {:.3g} {} ({}) | {} of {}{} | {} of {}{} |\n", info.name, result.threshold, info.unit,
                        result.origin, result.caught, result.bugs, in_brackets(result.caught, result.bugs),
                        result.alarms, result.harmless, in_brackets(result.alarms, result.harmless));
    }
    return text;
}

/// The harmless pairs' ratios by part of our rule, then of the worst.
std::string margins_table(const std::vector<MeasuredPair>& pairs, double pictures)
{
    std::string text =
        "| ratio to the threshold of | half | pictures | median | 90 % | 99 % | largest | alarms a picture "
        "|\n|---|---|---|---|---|---|---|---|\n";
    double rate = 0;
    for (std::size_t part = 0; part <= part_names.size(); ++part)
        for (const bool held : {false, true}) {
            std::vector<double> ratios;
            for (const MeasuredPair& pair : pairs)
                if (!pair.harmful && pair.held_out == held)
                    ratios.push_back(part < part_names.size() ? pair.ours.parts.ratios[part] : pair.ours.worst);
            const Margins margins = margins_of(std::move(ratios));
            if (part == part_names.size() && held) rate = margins.alarm_rate;
            text += fmt::format("| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.2g} |\n",
                                part < part_names.size() ? part_names[part] : "the worst part",
                                held ? "held out" : "calibration", margins.count, margins.median, margins.percentile90,
                                margins.percentile99, margins.largest, margins.alarm_rate);
        }
    return text +
           fmt::format(
               "\nA submission of all units holds {:.0f} pictures: the chance that a right one is blamed is {:.2g}.\n",
               pictures, alarms_of_submission(rate, pictures));
}

/// Names with their scenes, most frequent first.
std::string list_of(const std::vector<MeasuredPair>& pairs, bool (*wanted)(const MeasuredPair&))
{
    std::map<std::string, std::vector<std::string>> by_change;
    for (const MeasuredPair& pair : pairs)
        if (wanted(pair))
            by_change[pair.change].push_back(
                fmt::format("{}{} {:.2f}", pair.scene, pair.held_out ? "" : "°", pair.ours.worst));
    std::vector<std::pair<std::string, std::vector<std::string>>> sorted(by_change.begin(), by_change.end());
    std::ranges::stable_sort(sorted, std::greater{}, [](const auto& entry) { return entry.second.size(); });
    std::string text;
    for (const auto& [change, scenes] : sorted)
        text += fmt::format("- {} ({}): {}\n", change, scenes.size(), fmt::join(scenes, "; "));
    return text.empty() ? "none\n" : text;
}

}

JudgeTimes time_image_rule()
{
    Image picture(512, 512, glm::u8vec4(20, 20, 20, 255));
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x)
            if (const int d = (x - 256) * (x - 256) + (y - 256) * (y - 256); d < 200 * 200)
                picture.at(x, y) = glm::u8vec4(255 - d / 200, x / 2, y / 2, 255);
    Random random(1);
    const auto noisy = [&](int span) {
        Image result = picture;
        for (glm::u8vec4& pixel : result.cells)
            for (glm::length_t c = 0; c < 3; ++c)
                pixel[c] = static_cast<std::uint8_t>(std::clamp(
                    int{pixel[c]} + static_cast<int>(random.below(static_cast<std::uint32_t>(2 * span + 1))) - span, 0,
                    255));
        return result;
    };
    Check check;
    check.judge = image_kind();
    const Tensor expected = as_tensor(picture);
    const auto time = [&](const Tensor& student) {
        return best_milliseconds([&] { (void)fraction_right(check, student, expected, nullptr); });
    };
    return {time(expected), time(as_tensor(noisy(1))), time(as_tensor(noisy(60)))};
}

MeasuredPair unmeasured(const PicturePair& pair)
{
    MeasuredPair measured{pair.scene,           pair.change, pair.harmful, pair.noise, pair.made_up,
                          held_out(pair.scene), false,       {},           {}};
    measured.invisible = pair.harmful && looks_the_same(pair.student, pair.expected);
    return measured;
}

MeasuredPair measure(const PicturePair& pair)
{
    MeasuredPair measured = unmeasured(pair);
    measured.ours = our_measure(pair.student, pair.expected, pair.noise);
    measured.measures = measure_by_rules(pair.student, pair.expected, measured.ours);
    return measured;
}

std::string as_markdown(const JudgeBench& bench)
{
    const auto clear = select(bench, false);
    const auto noisy = select(bench, true);
    const auto invisible = std::ranges::count_if(bench.pairs, [](const MeasuredPair& pair) { return pair.invisible; });
    std::string text = fmt::format(
        "Pairs: {}, of them {} wrong ones that look right in their scene (no channel differs by more than 2 levels) "
        "and do not count.\n\n",
        bench.pairs.size(), invisible);
    text += "### Pictures without noise, on the scenes that were held out\n\n" + rules_table(clear);
    if (!noisy.empty()) text += "\n### Monte Carlo pictures, on the scenes that were held out\n\n" + rules_table(noisy);
    text += "\n### How far harmless pictures stay below our thresholds (1)\n\n" +
            margins_table(clear, bench.pictures_per_submission);
    text += "\n### Wrong pictures that pass (° calibration half)\n\n" +
            list_of(bench.pairs, [](const MeasuredPair& pair) { return is_bug(pair) && pair.ours.worst <= 1; });
    text += "\n### Harmless pictures beyond half of a threshold\n\n" +
            list_of(bench.pairs, [](const MeasuredPair& pair) { return !pair.harmful && pair.ours.worst > 0.5; });
    text += fmt::format(
        "\n### Time of one comparison, 512 x 512, one thread\n\nidentical {:.3f} ms, one level of noise {:.2f} ms, "
        "every pixel wrong {:.2f} ms\n",
        bench.times.identical, bench.times.noise, bench.times.all_wrong);
    return text;
}

nlohmann::json as_json(const JudgeBench& bench)
{
    nlohmann::json pairs = nlohmann::json::array();
    for (const MeasuredPair& pair : bench.pairs) {
        nlohmann::json row = {{"scene", pair.scene},         {"change", pair.change},
                              {"harmful", pair.harmful},     {"noise", pair.noise},
                              {"made_up", pair.made_up},     {"held_out", pair.held_out},
                              {"invisible", pair.invisible}, {"ratios", pair.ours.parts.ratios}};
        for (std::size_t i = 0; i < picture_rules.size(); ++i)
            row["measures"][std::string(picture_rules[i].name)] = pair.measures[i];
        pairs.push_back(std::move(row));
    }
    return {
        {"format", "umbral-judge-bench"},
        {"version", 1},
        {"pairs", std::move(pairs)},
        {"milliseconds",
         {{"identical", bench.times.identical}, {"noise", bench.times.noise}, {"all_wrong", bench.times.all_wrong}}}};
}

}
