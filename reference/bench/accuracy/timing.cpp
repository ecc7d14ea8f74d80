#include "timing.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace umbral::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// What this thread has spent of the processor: other programs that run meanwhile cost it nothing but their cold
/// caches.
double processor_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}

std::vector<double> fastest_of_interleaved(std::span<const std::function<void()>> variants, const Patience& patience)
{
    std::vector<double> fastest(variants.size(), std::numeric_limits<double>::infinity());
    for (const auto& variant : variants) variant();
    const auto begin = Clock::now();
    for (int round = 0; round < patience.rounds && (round < patience.least || seconds_since(begin) < patience.seconds);
         ++round) {
        for (std::size_t i = 0; i < variants.size(); ++i) {
            const std::size_t which = (i + static_cast<std::size_t>(round)) % variants.size();
            const auto turn = Clock::now();
            do {
                const double start = processor_seconds();
                variants[which]();
                fastest[which] = std::min(fastest[which], processor_seconds() - start);
            } while (seconds_since(turn) < patience.turn);
        }
    }
    return fastest;
}

}
