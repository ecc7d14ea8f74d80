#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <umbral/core/random.hpp>

#include "judge/controls.hpp"
#include "judge/evidence/kinds.hpp"
#include "judge/explain/resemblances.hpp"
#include "judge/judge_record.hpp"
#include "judge/noise/noise.hpp"
#include "judge/noise/rule.hpp"
#include "judge/parameters.hpp"
#include "judge/statistics/error_budget.hpp"
#include "text/field.hpp"

namespace umbral::grader {
namespace {

constexpr OwnField fields_of_noise[] = {{"scatter",
                                         R"({
  "description": "Noise: how many times as widely as the reference's estimates may scatter, in standard )"
                                         R"(deviations, where that hides a bias of a tenth. At least twice what )"
                                         R"(right estimators of other kinds need.",
  "type": "number",
  "minimum": 1,
  "maximum": 1000
})"}};

void read_noise(const Field& check, Check& to)
{
    to.own = NoiseParameters{check.member("scatter").number(1, 1000)};
    if (to.tolerance.ulps || to.tolerance.band_ulps)
        check.member("tolerance").refuse("absolute or relative only, as the bias that \"noise\" forgives");
}

// Right estimators of other kinds, tried here with some seeds, speak for all that students find.
std::string too_narrow(const Check& check, const std::map<std::string, double>& metrics)
{
    const auto found = metrics.find("scatter");
    const double allowed = parameters_of<NoiseParameters>(check).scatter;
    if (found == metrics.end() || 2 * found->second <= allowed) return "";
    return fmt::format(
        "check '{}': these estimates scatter {:.3g} times as widely as the reference's, and \"scatter\" "
        "is {:g}: make it {:.2g} or more, twice what right work needs",
        check.name, found->second, allowed, std::ceil(2 * found->second));
}

// What knows the scale of the estimates only. The mean of one quantity is its answer: of a single one, nothing is left
// that knows nothing.
Controls estimate_controls(const Tensor& expected, std::uint64_t seed)
{
    const std::size_t components = expected.components;
    const ComponentStatistics each = component_statistics(expected);
    const double mean = std::accumulate(each.mean.begin(), each.mean.end(), 0.0) / static_cast<double>(components);
    const double low = *std::min_element(each.low.begin(), each.low.end());
    const double high = *std::max_element(each.high.begin(), each.high.end());
    const ComponentStatistics all{std::vector<double>(components, mean), std::vector<double>(components, low),
                                  std::vector<double>(components, high)};
    Controls result{{"zeros", filled(expected, std::vector<double>(components, 0))},
                    {"ones", filled(expected, std::vector<double>(components, 1))}};
    if (components == 1) return result;
    result.emplace_back("mean of all", filled(expected, all.mean));
    result.emplace_back("noise", noise_within(expected, all, seed));
    return result;
}

// The right colours with the right noise, each in a place that chance gave it.
Tensor shuffled(const Tensor& expected, std::uint64_t seed)
{
    Random random(seed);
    Tensor tensor = expected;
    const auto size = static_cast<std::ptrdiff_t>(size_of(expected.element) * expected.components);
    for (auto i = static_cast<std::ptrdiff_t>(expected.cells()) - 1; i > 0; --i) {
        const auto other = static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint32_t>(i) + 1));
        if (other != i)
            std::swap_ranges(tensor.bytes.begin() + i * size, tensor.bytes.begin() + (i + 1) * size,
                             tensor.bytes.begin() + other * size);
    }
    return tensor;
}

// Nothing, and huge now and then, of either sign: such a sum differs from no other by more than its noise.
Tensor spikes(const Tensor& expected, std::uint64_t seed)
{
    Random random(seed);
    std::vector<double> values(expected.count(), 0);
    for (double& value : values)
        if (random.below(4) == 0) value = (random.below(2) == 0 ? -1 : 1) * random.uniform(1e5F, 2e5F);
    return with_values(expected, values);
}

Controls noise_controls(const Check& check, const Tensor& expected, std::uint64_t seed)
{
    Controls result = is_table(expected) ? estimate_controls(expected, seed) : common_controls(check, expected, seed);
    if (!is_table(expected)) result.emplace_back("shuffled pixels", shuffled(expected, seed));
    if (expected.element != Element::uint8) result.emplace_back("spikes of either sign", spikes(expected, seed));
    return result;
}

}

extern constinit const JudgeRecord noise_judge;
constinit const JudgeRecord noise_judge{
    .name = "noise",
    .place = 3,
    .compares = "the means of Monte Carlo estimates",
    .own_fields = fields_of_noise,
    .read_own = read_noise,
    .schema_of_check = R"({"properties": {"tolerance": {"properties": {"ulps": false, "band_ulps": false}}}})",
    .most_in_course = most_noise_checks,
    .look = Look::light,
    .can_be_drawn = [](const Tensor& tensor) { return !is_table(tensor); },
    .judge = [](const Question& q) { return judge_noise(q.check, q.student, q.expected, q.names); },
    .controls = noise_controls,
    .judge_both = judge_both,
    .too_narrow = too_narrow,
    .resemblance = same_picture,
    .difference_map = noise_map,
    .evidence = picture_evidence,
};

}
