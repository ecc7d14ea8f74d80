#pragma once

#include <algorithm>
#include <ctime>

namespace umbral::grader {

/// Processor time of `work` in milliseconds, the best of `rounds`: what it takes where nothing else disturbs it.
template <class Work>
[[nodiscard]] double best_milliseconds(Work work, int rounds = 15)
{
    double best = 1e9;
    for (int i = 0; i < rounds; ++i) {
        const std::clock_t start = std::clock();
        work();
        best = std::min(best, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

}
