#include "sampled_study.hpp"

#include <fmt/format.h>

namespace umbral::bench {

void add_sampled_trials(Study& study, const std::vector<SamplePattern>& patterns, std::uint64_t seed, int repetitions,
                        const SampledEstimate& estimate)
{
    constexpr int timed_at_once = 16;
    for (const SamplePattern& pattern : patterns)
        for (const int count : {1, 4, 16, 64, 256}) {
            Random random(seed);
            std::vector<double> errors;
            for (int i = 0; i < repetitions; ++i)
                errors.push_back(estimate.error(random, [&] { return pattern.points(count, random); }));
            study.trials.push_back({fmt::format("{} {}", pattern.family, count),
                                    pattern.family,
                                    static_cast<double>(count),
                                    {{"rms", root_mean_square(errors)}},
                                    timed_at_once,
                                    [=, timed = estimate.timed, points = pattern.points] {
                                        Random again(seed);
                                        for (int i = 0; i < timed_at_once; ++i)
                                            keep(timed(i, again, [&] { return points(count, again); }));
                                    }});
        }
}

}
