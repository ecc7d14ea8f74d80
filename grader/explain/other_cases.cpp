#include "explain/other_cases.hpp"

namespace umbral::grader {

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
