#pragma once

#include <span>
#include <string>

#include "mutants/mutant.hpp"

namespace umbral::grader {

/// What a run is given the number of its mutant by: an int of that name in the library, 0 for none.
inline constexpr const char* chosen_mutant = "umbral_mutant_chosen";

/// No source has so many mutants.
inline constexpr unsigned most_mutants = 1U << 15U;

/// What to choose for two mutants of a library at once.
[[nodiscard]] constexpr unsigned both(unsigned one, unsigned other) { return one + other * most_mutants; }

/// What to choose for all mutants of a library at once.
inline constexpr unsigned all_mutants = 0x7fff'ffff;

/// In diagnostics, the line of mutant n is this one and n more: what does not compile can be left out.
inline constexpr std::size_t first_mutant_line = 1'000'000;

/// A source with all its mutants in it: an expression becomes `(umbral_mutant(17) ? changed : original)`, a statement
/// `{ if (!umbral_mutant(18)) statement }`. Mutants in the order of find_mutants.
[[nodiscard]] std::string with_mutants(const std::string& source, std::span<const Mutant> mutants);

/// A source with one mutant in the place of the original. Lines behind it keep their numbers.
[[nodiscard]] std::string with_change(const std::string& source, const Mutant& mutant);

}
