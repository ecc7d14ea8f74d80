#include "judge/explain/confidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <umbral/record/not_finite.hpp>

#include "judge/explain/thresholds.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

constexpr std::string_view mistake_prefix = "mistake: ";

double told_by(double bits) { return 1 - std::exp2(-bits / thresholds::bits_scale); }

/// The different wrong values that two results share.
class SharedValues {
public:
    explicit SharedValues(Element element) : bits_(is_real(element) ? 6 : 3) {}

    void add(std::size_t component, double recorded)
    {
        const double value = recorded_number(recorded);
        const bool plain = value == 0 || std::abs(value) == 1 || !std::isfinite(value);
        if (plain)
            plain_.insert({component, std::isfinite(value) ? value : 2.0});
        else
            telling_.insert(value);
    }
    [[nodiscard]] double total() const
    {
        return static_cast<double>(plain_.size()) + bits_ * static_cast<double>(telling_.size());
    }

private:
    double bits_;
    std::set<std::pair<std::size_t, double>> plain_;
    std::set<double> telling_;
};

bool same(std::span<const double> a, std::span<const double> b) { return std::ranges::equal(a, b); }

}

Tally& Tally::operator+=(const Resemblance& one)
{
    for_it += one.says == Says::for_it ? 1 : 0;
    against_it += one.says == Says::against_it ? 1 : 0;
    bits += one.bits;
    return *this;
}

double fit(const Tally& tally)
{
    if (tally.for_it == 0) return 0;
    const double against = static_cast<double>(tally.against_it) - 0.5 * static_cast<double>(tally.hard_against);
    return static_cast<double>(tally.for_it) / (static_cast<double>(tally.for_it) + against);
}

double confidence(const Tally& tally) { return fit(tally) * told_by(tally.bits); }

double most_confidence(const Tally& tally, std::size_t undecided)
{
    if (undecided == 0) return confidence(tally);
    Tally most = tally;
    most.for_it += undecided;
    return fit(most);
}

double pattern_bits(std::size_t all, std::size_t alike)
{
    if (alike == 0 || alike >= all) return 0;
    const auto n = static_cast<double>(all);
    const auto k = static_cast<double>(alike);
    const double ways = std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
    return std::min(ways / std::numbers::ln2, thresholds::most_pattern_bits);
}

double agreement_bits(const Tensor& student_tensor, const Tensor& expected_tensor, const std::vector<bool>& counted,
                      const std::vector<bool>& alike)
{
    const TensorView student(student_tensor);
    const TensorView expected(expected_tensor);
    const bool grid = expected_tensor.columns > 1;
    const auto background = expected.cell(0);
    std::size_t places = 0;
    std::size_t agreeing = 0;
    SharedValues values(student_tensor.element);
    for (std::size_t i = 0; i < expected.cells(); ++i) {
        if (alike[i]) {
            ++agreeing;
            if (values.total() >= thresholds::most_value_bits) continue;
            const auto yours = student.cell(i);
            const auto target = expected.cell(i);
            if (!student.present(i) || !expected.present(i))
                values.add(student.components(), student.present(i) ? 1 : 0);
            else
                for (std::size_t c = 0; c < yours.size(); ++c)
                    if (!(yours[c] == target[c])) values.add(c, yours[c]);
        }
        if (counted[i] && !(grid && same(student.cell(i), background) && same(expected.cell(i), background))) ++places;
    }
    return pattern_bits(places, agreeing) + std::min(values.total(), thresholds::most_value_bits);
}

std::string mistake_title(const std::string& name) { return std::string(mistake_prefix) + name; }
bool is_mistake(const Explanation& explanation) { return explanation.name.starts_with(mistake_prefix); }

std::vector<Explanation> ranked(std::vector<Explanation> candidates)
{
    std::erase_if(candidates, [](const Explanation& one) { return one.confidence < thresholds::least_sure; });
    if (candidates.empty()) return candidates;
    std::ranges::stable_sort(candidates, std::ranges::greater{}, &Explanation::confidence);
    const double best = candidates.front().confidence;
    const auto matches_as_well = [best](const Explanation& one) {
        return one.confidence >= best - thresholds::equally_sure;
    };
    const auto equals = std::ranges::find_if_not(candidates, matches_as_well);
    std::stable_partition(candidates.begin(), equals, is_mistake);
    const auto of_one_kind = std::find_if(candidates.begin(), equals, [&](const Explanation& one) {
        return is_mistake(one) != is_mistake(candidates.front());
    });
    if (of_one_kind - candidates.begin() > 1)
        for (auto one = candidates.begin(); one != of_one_kind; ++one) one->ambiguous = true;
    if (candidates.size() > thresholds::most_explanations) candidates.resize(thresholds::most_explanations);
    return candidates;
}

}
