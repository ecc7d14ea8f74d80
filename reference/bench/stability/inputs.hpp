#pragma once

#include <string>
#include <umbral/core/random.hpp>

#include "call.hpp"

namespace stability {

/// Numbers for a shape, of sizes from 1e-8 to 1e8. Half of the vectors are drawn alone, the others with regard to the
/// one before them: nearly parallel, equal, opposite, close to it, or on an axis.
[[nodiscard]] std::vector<float> drawn_numbers(const char* shape, umbral::Random& random);

/// Finite numbers that nobody expects: 0, -0, the smallest, 1e±30, mixed with ordinary ones; equal and opposite
/// vectors.
[[nodiscard]] std::vector<float> extreme_numbers(const char* shape, umbral::Random& random);

/// The call as code that can be pasted, with exact literals.
[[nodiscard]] std::string code_of(const Call& call, Numbers x);

}
