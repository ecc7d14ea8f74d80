#pragma once

#include <cstddef>
#include <vector>

#include "question/dependence.hpp"

namespace umbral::grader {

/// What becomes of one number of wrong answers as an argument is moved.
struct Reaction {
    std::size_t seen = 0;
    std::size_t changed = 0;
    std::size_t still = 0;
    bool is_steady = true;  ///< as in all, most changed in each set of inputs

    /// `size`: of the numbers that it was computed with, beside which small changes are rounding.
    void add(double before, double after, double size);
    /// With the answers to other inputs.
    void add(const Reaction& others);
    /// Most change, of enough to say so.
    [[nodiscard]] bool changes() const;
    /// All stay, of enough to say so.
    [[nodiscard]] bool stays() const;
};

/// The same for what a number may be looked at as.
struct Reactions {
    Reaction yours{};
    Reaction right{};
    Reaction factor{};      ///< how many times the right number it is; not seen where one of them is 0
    Reaction difference{};  ///< what it is more than the right one
};

/// For each move, what becomes of each number of the answers: over wrong rows that have numbers before and after on
/// both sides, and remain wrong. Rows that most moves make right are wrong in their places only, and are left out.
[[nodiscard]] std::vector<std::vector<Reactions>> reactions(const AnswersToMoves& answers);

}
