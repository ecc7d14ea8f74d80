#pragma once

#include <functional>
#include <span>
#include <vector>

namespace umbral::bench {

/// How long to measure.
struct Patience {
    int rounds = 25;      ///< at most
    int least = 5;        ///< at least, however long they take
    double seconds = 20;  ///< no new round is begun after this
    double turn =
        0;  ///< seconds for which a variant is repeated in its turn; at least once, and each time counts for itself
};

/// The smallest time in seconds of this thread's processor that each of `variants` took (their work must not move to
/// other threads), over rounds in which all of them run in turn, each round beginning with another one: what disturbs
/// the machine for a while disturbs all of them, and the minimum leaves out what it can. A first round that warms
/// caches is not counted. Ratios between variants are meant to be used, the figures themselves hold for this machine
/// and moment.
[[nodiscard]] std::vector<double> fastest_of_interleaved(std::span<const std::function<void()>> variants,
                                                         const Patience& patience);

}
