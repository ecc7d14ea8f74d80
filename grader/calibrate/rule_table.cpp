#include "calibrate/rule_table.hpp"

#include <algorithm>
#include <cmath>

namespace umbral::grader {
namespace {

double measure_of(const MeasuredPair& pair, PictureRule rule) { return pair.measures[static_cast<std::size_t>(rule)]; }

RuleResult try_threshold(std::span<const MeasuredPair> pairs, PictureRule rule, double threshold, std::string origin)
{
    RuleResult result{rule, std::move(origin), threshold};
    for (const MeasuredPair& pair : pairs) {
        if (!pair.held_out) continue;
        const std::size_t raised = measure_of(pair, rule) > threshold ? 1 : 0;
        if (is_bug(pair)) ++result.bugs, result.caught += raised;
        if (!pair.harmful) ++result.harmless, result.alarms += raised;
    }
    return result;
}

}

double fitted_threshold(std::span<const MeasuredPair> pairs, PictureRule rule)
{
    double largest = 0;
    for (const MeasuredPair& pair : pairs)
        if (!pair.held_out && !pair.harmful) largest = std::max(largest, measure_of(pair, rule));
    return largest;
}

std::vector<RuleResult> compare_rules(std::span<const MeasuredPair> pairs)
{
    std::vector<RuleResult> results;
    for (const PictureRuleInfo& info : picture_rules) {
        if (info.rule == PictureRule::ours) {
            results.push_back(try_threshold(pairs, info.rule, 1, "in use"));
            continue;
        }
        if (info.published) results.push_back(try_threshold(pairs, info.rule, *info.published, std::string(info.source)));
        // PSNR orders pictures as RMSE does: it has no best threshold of its own.
        if (info.rule != PictureRule::psnr) results.push_back(try_threshold(pairs, info.rule, fitted_threshold(pairs, info.rule), "best on the other half"));
    }
    return results;
}

Margins margins_of(std::vector<double> ratios)
{
    Margins margins;
    margins.count = ratios.size();
    if (ratios.empty()) return margins;
    std::ranges::sort(ratios);
    const auto quantile = [&](double share) { return ratios[static_cast<std::size_t>(share * static_cast<double>(ratios.size() - 1))]; };
    margins.median = quantile(0.5);
    margins.percentile90 = quantile(0.9);
    margins.percentile99 = quantile(0.99);
    margins.largest = ratios.back();

    const std::size_t tail = std::min(ratios.size() - 1, std::max<std::size_t>(10, ratios.size() / 10));
    if (tail == 0) return margins;
    const double start = ratios[ratios.size() - 1 - tail];
    // All beyond the start are zero: then nothing is known but that no ratio came near.
    if (start <= 0) return margins;
    double mean_log = 0;
    for (std::size_t i = ratios.size() - tail; i < ratios.size(); ++i) mean_log += std::log(ratios[i] / start) / static_cast<double>(tail);
    const double share = static_cast<double>(tail) / static_cast<double>(ratios.size());
    if (start >= 1)
        margins.alarm_rate = static_cast<double>(std::ranges::count_if(ratios, [](double ratio) { return ratio > 1; })) / static_cast<double>(ratios.size());
    else if (mean_log > 0)
        margins.alarm_rate = share * std::pow(start, 1 / mean_log);
    return margins;
}

double alarms_of_submission(double rate, double pictures) { return -std::expm1(pictures * std::log1p(-rate)); }

}
