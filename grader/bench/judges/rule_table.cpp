#include "bench/judges/rule_table.hpp"

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

/// The share of a sorted sample that lies beyond `bound`; where there is none, what the largest tenth says of it.
double chance_beyond(const std::vector<double>& sorted, double bound)
{
    const auto size = static_cast<double>(sorted.size());
    if (sorted.back() > bound)
        return static_cast<double>(sorted.end() - std::ranges::upper_bound(sorted, bound)) / size;
    const std::size_t tail = std::max<std::size_t>(10, sorted.size() / 10);
    if (tail >= sorted.size()) return 0;
    const double start = sorted[sorted.size() - 1 - tail];
    if (start <= 0) return 0;
    double first = 0;
    double second = 0;
    for (std::size_t i = sorted.size() - tail; i < sorted.size(); ++i) {
        const double log = std::log(sorted[i] / start);
        first += log / static_cast<double>(tail);
        second += log * log / static_cast<double>(tail);
    }
    if (!(second > first * first)) return 0;
    const double bounded = 1 - 0.5 / (1 - first * first / second);
    const double shape = first + bounded;
    const double scale = start * first * (1 - bounded);
    const double base = 1 + shape * (bound - start) / scale;
    const double beyond = std::abs(shape) < 1e-9 ? std::exp(-(bound - start) / scale)
                          : base <= 0            ? 0
                                                 : std::pow(base, -1 / shape);
    return static_cast<double>(tail) / size * beyond;
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
        if (info.published)
            results.push_back(try_threshold(pairs, info.rule, *info.published, std::string(info.source)));
        // PSNR orders pictures as RMSE does: it has no best threshold of its own.
        if (info.rule != PictureRule::psnr)
            results.push_back(
                try_threshold(pairs, info.rule, fitted_threshold(pairs, info.rule), "best on the other half"));
    }
    return results;
}

Margins margins_of(std::vector<double> ratios)
{
    Margins margins;
    margins.count = ratios.size();
    if (ratios.empty()) return margins;
    std::ranges::sort(ratios);
    const auto quantile = [&](double share) {
        return ratios[static_cast<std::size_t>(share * static_cast<double>(ratios.size() - 1))];
    };
    margins.median = quantile(0.5);
    margins.percentile90 = quantile(0.9);
    margins.percentile99 = quantile(0.99);
    margins.largest = ratios.back();

    margins.alarm_rate = chance_beyond(ratios, 1);
    return margins;
}

double alarms_of_submission(double rate, double pictures) { return -std::expm1(pictures * std::log1p(-rate)); }

}
