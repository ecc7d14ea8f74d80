#include "judge/noise/noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "judge/events/events.hpp"
#include "judge/explain/thresholds.hpp"
#include "judge/noise/other_means.hpp"
#include "judge/noise/rule.hpp"
#include "judge/parameters.hpp"
#include "judge/picture/picture.hpp"
#include "judge/rows/tensor_view.hpp"
#include "judge/statistics/stochastic.hpp"

namespace umbral::grader {
namespace {

Judgement wrong(std::string message)
{
    Judgement result;
    result.message = std::move(message);
    return result;
}

Forgiven forgiven_by(const Check& check, const Tensor& tensor)
{
    const Forgiven usual = tensor.element == Element::uint8 ? forgiven_bytes : forgiven_floats;
    return {check.tolerance.relative.value_or(usual.relative), check.tolerance.absolute.value_or(usual.absolute)};
}

/// Credit of a bias that is proven; see thresholds.hpp.
double credit_for(double misplaced)
{
    const double share = std::log(thresholds::noise_zero / std::max(misplaced, 1e-9)) /
                         std::log(thresholds::noise_zero / thresholds::noise_full);
    return std::clamp(share, 0.0, thresholds::noise_most);
}

std::vector<std::string> quantity_names(const Tensor* names, int quantities)
{
    const auto known = event_names(text_of(names));
    std::vector<std::string> all(static_cast<std::size_t>(quantities));
    for (int i = 0; i < quantities; ++i)
        if (const auto found = known.find(i); found != known.end()) all[static_cast<std::size_t>(i)] = found->second;
    return all;
}

/// What is farthest off, and of a table what of the others is.
std::string in_words(const StochasticRule& rule, const Estimates& yours, const Estimates& expected,
                     const Forgiven& forgiven, const std::vector<std::string>& names)
{
    std::string text = rule.message(rule.tiled ? "" : names.at(static_cast<std::size_t>(rule.channel)));
    const std::string others =
        text.empty() || rule.tiled ? "" : others_in_words(yours, expected, rule.channel, forgiven, names);
    return others.empty() ? text : text + '.' + others;
}

Difference worst_tile(const StochasticRule& rule, const std::vector<std::string>& names)
{
    const std::string name = rule.tiled ? "" : names.at(static_cast<std::size_t>(rule.channel));
    const std::string where = rule.tiled     ? fmt::format("mean light of the {} x {} pixels from ({}, {})", rule.width,
                                                           rule.height, rule.x, rule.y)
                              : name.empty() ? fmt::format("mean of component {}", rule.channel)
                                             : name + ", on average";
    return {where, number_text(rule.yours), number_text(rule.expected)};
}

}

bool is_table(const Tensor& tensor) { return tensor.columns == 1; }

Estimates estimates_of(const Check& check, const Tensor& tensor)
{
    const bool table = is_table(tensor);
    if (tensor.element != Element::uint8 && tensor.element != Element::float32 && tensor.element != Element::float64)
        throw std::invalid_argument("check '" + check.name + "': expected Monte Carlo estimates in bytes or floats");
    if (!table) check_picture(check, tensor);
    if (table && tensor.rows < static_cast<std::uint32_t>(thresholds::noise_rows))
        throw std::invalid_argument(fmt::format("check '{}': expected a table of at least {} replicates, got {}",
                                                check.name, thresholds::noise_rows, tensor.rows));
    if (!table && tensor.element == Element::uint8) return light_of(to_picture(check, tensor));

    const std::vector<double> values = to_doubles(tensor);
    const std::size_t components = tensor.components;
    const std::size_t channels = table ? components : components < 3 ? 1 : 3;
    Estimates result{
        static_cast<int>(tensor.columns), static_cast<int>(tensor.rows), static_cast<int>(channels), !table, {}, {}};
    result.values.resize(channels * tensor.cells());
    for (std::size_t channel = 0, to = 0; channel < channels; ++channel)
        for (std::size_t from = channel; from < values.size(); from += components) result.values[to++] = values[from];
    return result;
}

Judgement judge_noise(const Check& check, const Tensor& student, const Tensor& expected, const Tensor* names)
{
    const Estimates target = estimates_of(check, expected);
    if (!complete(expected))
        throw std::invalid_argument("check '" + check.name +
                                    "': the expected estimates hold values that are not finite");
    if (!complete(student))
        return wrong(
            "Some estimates have no value or are not finite (NaN or infinity): look for a division by a probability of "
            "zero, and for a root of a "
            "negative number.");
    // The unit's own random numbers in the reference's order: both estimates are equal, and bytes say so at no cost.
    if (std::ranges::equal(student.bytes, expected.bytes)) {
        Judgement same{1, 0, "", {{"probability", 1}, {"misplaced_percent", 0}, {"worst_deviation", 0}}, {}};
        same.chance = 1;
        return same;
    }
    const Estimates yours = estimates_of(check, student);
    const Forgiven forgiven = forgiven_by(check, expected);
    const std::vector<std::string> quantities = quantity_names(names, target.channels);
    StochasticRule rule = apply_stochastic_rule(yours, target, forgiven);
    rule.agree = rule.probability >= check_alpha();
    // What scatters apart by a bias shows it: at least a third of the light then lies in the wrong place, beyond noise.
    const double scatter = hiding_scatter(yours, target);
    const bool may_hide = rule.agree || rule.misplaced < 1.0 / 3;
    const bool too_wide =
        may_hide && (scatter > parameters_of<NoiseParameters>(check).scatter || cancels_itself(yours, target));
    const bool apart = may_hide && !too_wide && scatters_apart(yours, target);
    // One quantity of several that is far off: it earns no more, but is told as what it is.
    if (apart && !rule.agree && is_far_off(yours, target))
        return wrong(in_words(rule, yours, target, forgiven, quantities));
    if (too_wide || apart)
        return wrong(
            "The estimates scatter far more than the reference's, so that their mean proves nothing: take as many "
            "samples as you are told, choose "
            "directions where the light is, and look at what each one is divided by.");

    Judgement result;
    result.right = rule.agree ? 1 : credit_for(rule.misplaced);
    result.error = rule.misplaced;
    result.message = in_words(rule, yours, target, forgiven, quantities);
    result.metrics = {{"probability", rule.probability},
                      {"misplaced_percent", 100 * rule.misplaced},
                      {"worst_deviation", rule.worst_z},
                      {"scatter", scatter},
                      {"tests", static_cast<double>(rule.tests)}};
    result.chance = rule.probability;
    result.borderline = after_first_run(rule.probability) == FirstRun::borderline;
    if (!rule.agree && rule.worst == Worst::tile) result.first_difference = worst_tile(rule, quantities);
    return result;
}

Judgement judge_both(const Judgement& first, const Judgement& second)
{
    if (!first.chance || !second.chance) return second;
    const double before = *first.chance;
    const double after = *second.chance;
    const double probability = two_stage_probability(before, after, thresholds::noise_borderline);
    const bool right = probability >= check_alpha();
    // The worse of the two says what is wrong.
    Judgement result = before < after ? first : second;
    result.error = (first.error.value_or(0) + second.error.value_or(0)) / 2;
    result.right = right ? 1 : credit_for(*result.error);
    if (right)
        result.message.clear();
    else if (result.message.empty())
        result.message = "The estimates lie off by more than noise explains in two runs";
    if (!right)
        result.message += fmt::format(" (in two runs, which noise does with a probability of {:.2g})", probability);
    if (right) result.first_difference.reset();
    result.chance = probability;
    result.borderline = false;
    result.metrics["probability"] = probability;
    result.metrics["probability_first"] = before;
    result.metrics["probability_fresh"] = after;
    result.metrics["misplaced_percent"] = 100 * *result.error;
    return result;
}

}
