#pragma once

#include <algorithm>
#include <ctime>

namespace umbral::grader {

/// Processor time of `work` in milliseconds, the best of 15: what it takes where nothing else disturbs it.
template <class Work>
[[nodiscard]] double best_milliseconds(Work work)
{
    double best = 1e9;
    for (int i = 0; i < 15; ++i) {
        const std::clock_t start = std::clock();
        work();
        best = std::min(best, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

}
