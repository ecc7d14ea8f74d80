#include "explain/other_cases.hpp"

#include <algorithm>

#include "judge/judges.hpp"

namespace umbral::grader {

std::vector<const Check*> checks_beside(const Exercise& exercise, const CaseResults& cases, const Check& check)
{
    std::vector<const Check*> others;
    for (const Check& other : exercise.checks) {
        const CaseResult& one = cases.at(other.case_name);
        if (other.case_name != check.case_name && !other.relation && !is_picture(other) && !one.hidden && !one.beside &&
            one.reached && one.cause().empty())
            others.push_back(&other);
    }
    std::ranges::stable_partition(others, [&](const Check* other) { return other->value == check.value; });
    return others;
}

void OtherCases::each(const std::string& function, const std::function<bool(const AskedSample&)>& look)
{
    const auto goes_on = [&](const AskedSample& sample) { return sample.function != function || look(sample); };
    for (const AskedSample& sample : known_)
        if (!goes_on(sample)) return;
    if (are_all_ || !asked_.others) return;
    std::size_t passed = 0;
    bool wanted = true;
    asked_.others([&](const AskedCheck& other) {
        if (passed++ < known_.size()) return true;
        known_.push_back(asked_sample(worker_, other, other.result.seed));
        wanted = goes_on(known_.back());
        return wanted;
    });
    are_all_ = wanted;
}

}
