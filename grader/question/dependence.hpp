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

/// What wrong answers depend on in place of what they should, in some of their numbers.
struct Dependence {
    std::vector<std::size_t> components{};
    std::vector<MovedPlace> wrongly{};  ///< that they change with, and the right ones do not
    std::vector<MovedPlace> lacking{};  ///< that the right ones change with, and they do not

    friend bool operator==(const Dependence&, const Dependence&) = default;
};

/// Of wrong answers to which most moves give the right ones nothing is said: these are wrong in one place only, as
/// where two numbers are equal.
///
/// Numbers of wrong answers of which most change with an argument, in each set of inputs, that no right one changes
/// with there, or the reverse. Said of few places only: an answer that changes with nothing is constant, and one that
/// changes with everything is of another kind.
[[nodiscard]] std::vector<Dependence> dependences(const AnswersToMoves& answers);

}
