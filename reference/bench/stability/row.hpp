#pragma once

#include <umbral/core/random.hpp>

#include "call.hpp"

namespace stability {

/// In what an error is counted.
enum class Unit {
    ulps,             ///< of each number of the answer
    ulps_of_largest,  ///< of the answer's largest number
    absolute          ///< as it is
};

/// A function and what its header promises of it.
struct Row {
    const char* name;  ///< as the call's
    Unit unit;
    double bound;        ///< what the reference may be off, in that unit
    const char* reason;  ///< of the bound, in short: the header's words, or how it is derived
    /// The formula of the textbook in float; none where nobody would write another one than the reference.
    Answer (*naive)(Numbers) = nullptr;
    /// Makes any numbers legal ones, as the header has them; none if all are.
    void (*repair)(std::vector<float>&, umbral::Random&) = nullptr;
    /// What the answer's size may be off besides, where the header promises it relative to something else.
    double (*slack)(Numbers) = nullptr;
};

[[nodiscard]] std::vector<Row> transforms_rows();
[[nodiscard]] std::vector<Row> projections_rows();
[[nodiscard]] std::vector<Row> lighting_rows();
[[nodiscard]] std::vector<Row> raytracing_rows();
[[nodiscard]] std::vector<Row> texturing_rows();
[[nodiscard]] std::vector<Row> all_rows();

/// A number spread evenly over powers of ten.
[[nodiscard]] float between_powers(umbral::Random& random, float low, float high);

/// Makes `count` numbers from `at` on a unit vector (float's best).
void make_unit(std::vector<float>& x, std::size_t at, std::size_t count = 3);

}
