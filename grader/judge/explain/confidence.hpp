#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/scorecard.hpp"

#include <umbral/record/tensor.hpp>

namespace umbral::grader {

// How sure a candidate reason (a known mistake, a named transform) is of being the reason. Both kinds are measured
// alike:
//
//   fit = checks that speak for it / (checks that speak for it + checks that speak against it)
//   confidence = fit * (1 - 2^(-bits / 4))
//
// A check speaks for a candidate if the student deviates where the candidate does, and in the same way; against it if
// only one of them fails the check, or both do in different ways. `bits` is how much the agreement says: two results
// that share one wrong boolean agree by chance, two that share a thousand wrong numbers do not.

/// What one check says about one candidate.
enum class Says : std::uint8_t { nothing, for_it, against_it };
struct Resemblance {
    Says says = Says::nothing;
    double bits = 0;  ///< where it speaks for the candidate: how much
};

/// Only one of the two fails the check, or both do in different ways.
inline constexpr Resemblance not_alike{Says::against_it, 0};

/// What all checks say.
struct Tally {
    std::size_t for_it = 0;
    std::size_t against_it = 0;
    double bits = 0;
    /// Of those against it, in hard cases: there, what rounds or overflows otherwise may be wrong in two ways at once,
    /// and each counts half.
    std::size_t hard_against = 0;

    Tally& operator+=(const Resemblance& one);
};

/// The share of the checks that say anything; 0 if nothing speaks for it.
[[nodiscard]] double fit(const Tally& tally);
/// 0..1; 0 if nothing speaks for it.
[[nodiscard]] double confidence(const Tally& tally);
/// The largest that it can become if as many more checks as `undecided` speak for it.
[[nodiscard]] double most_confidence(const Tally& tally, std::size_t undecided);

/// How much it says that of `all` places exactly the same `alike` deviate: log2 of the number of ways to choose them,
/// at most 12, for what goes wrong together often has one simple reason. Nothing if all deviate.
[[nodiscard]] double pattern_bits(std::size_t all, std::size_t alike);

/// How much the agreement of the rows for which `alike` is true says, `counted` rows in all: their pattern, and the
/// wrong values that they share. Each different value counts once; a number 6 bits, a whole number or a level of a
/// picture 3, and what many errors give (0, 1, -1, nothing, not finite) 1. In a grid, cells that are background (as the
/// first cell of `expected`) on both sides are no places.
[[nodiscard]] double agreement_bits(const Tensor& student, const Tensor& expected, const std::vector<bool>& counted,
                                    const std::vector<bool>& alike);

/// What is said of all candidates, best first: those above the floor thresholds::least_sure, at most three. Of equals,
/// known mistakes come first, whose hints are written for the unit. Those that match as well as the first and are of
/// its kind are all marked ambiguous.
[[nodiscard]] std::vector<Explanation> ranked(std::vector<Explanation> candidates);

/// "mistake: NAME", and whether a name is one.
[[nodiscard]] std::string mistake_title(const std::string& name);
[[nodiscard]] bool is_mistake(const Explanation& explanation);

}
