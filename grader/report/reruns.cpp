#include "report/reruns.hpp"

#include <fmt/format.h>

namespace umbral::grader {

std::vector<std::string> seeds_of_noise(const UnitResult& unit)
{
    std::vector<std::string> sentences;
    for (const CheckResult& check : unit.checks) {
        const bool right = check.score >= check.max_score;
        if (check.seeds.size() == 2)
            sentences.push_back(
                fmt::format("{} was borderline with seed {}, so it was run again with seed {}: {} by both runs.",
                            check.name, check.seeds[0], check.seeds[1], right ? "right" : "wrong"));
        else if (check.seeds.size() == 1 && !right)
            sentences.push_back(fmt::format("{} was run with seed {}.", check.name, check.seeds[0]));
    }
    return sentences;
}

}
