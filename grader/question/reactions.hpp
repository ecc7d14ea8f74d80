#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <umbral/record/changes.hpp>

namespace umbral::grader {

/// Tables of answers, row after row, to a case's questions as they were asked, and with an argument moved
/// (umbral/record/ways_to_move.hpp) in all of them. NaN where there is no number.
struct MovedAnswers {
    OtherQuestion move;
    std::vector<double> yours{};
    std::vector<double> right{};
};

/// Answers of a check, and what becomes of them as arguments are moved.
struct AnswersToMoves {
    std::size_t components = 1;
    std::vector<double> yours{};
    std::vector<double> right{};
    std::vector<std::size_t> wrong{};  ///< rows of answers that are looked at: wrong ones
    std::vector<std::size_t> ends{};   ///< where among these those of one set of inputs end; none: all are of one
    std::vector<MovedAnswers> moved{};
};

/// Something that an answer changes with, of the arguments of a function.
struct MovedPlace {
    std::string function;
    std::string place;        ///< as in OtherQuestion, with what is moved of it behind: "1.axis", "0.size.x"
    bool is_length = false;   ///< only the length of the vector there
    bool is_order = false;    ///< only the order of the list there
    bool is_corners = false;  ///< only which corner each triangle of the list there begins with

    friend auto operator<=>(const MovedPlace&, const MovedPlace&) = default;
};

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

/// What becomes of each number of the answers as something is moved.
struct MoveReactions {
    MovedPlace place;
    std::vector<Reactions> numbers;
};

/// How many numbers an answer has; 0 if nothing was moved.
[[nodiscard]] inline std::size_t numbers_of_answer(const std::vector<MoveReactions>& moves)
{
    return moves.empty() ? 0 : moves.front().numbers.size();
}

/// For each move: over wrong rows that have numbers before and after on both sides, and remain wrong. Rows that most
/// moves make right are wrong in their places only, and are left out.
[[nodiscard]] std::vector<MoveReactions> reactions(const AnswersToMoves& answers);

}
