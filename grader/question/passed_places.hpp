#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace umbral::grader {

/// A question, and through which places of a student's code it went.
struct PassedQuestion {
    bool wrong = false;                   ///< has it a wrong answer?
    std::vector<std::uint32_t> places{};  ///< in the order in which they were first reached
    bool by_exception = false;            ///< did an exception end it?
    bool given = true;                    ///< was an answer given, where there may be none?
    bool idle = false;                    ///< is it right that nothing is answered, and nothing was?
};

/// Questions beside each other.
using PassedPlaces = std::vector<PassedQuestion>;

/// All but those that are idle: code that finds early that there is nothing to do looks like code that leaves off
/// early.
[[nodiscard]] PassedPlaces without_idle(PassedPlaces seen);

/// Are those that were given an answer wrong, and all others right? What parts them only tells that an answer was
/// given.
[[nodiscard]] bool are_wrong_where_given(const PassedPlaces& seen);

/// A place that questions with wrong answers come through, and those with right ones do not, or the reverse.
struct PartingPlace {
    std::uint32_t place = 0;
    bool of_wrong = true;           ///< it is the wrong ones that come through
    std::size_t wrong = 0;          ///< questions with wrong answers …
    std::size_t wrong_through = 0;  ///< … and those of them that come through
    std::size_t right = 0;
    std::size_t right_through = 0;
    bool but_idle = false;  ///< right ones where nothing is to be answered are not counted
};

/// So many questions with wrong answers there must be, and half as many again with right ones: fewer are parted by
/// chance.
inline constexpr std::size_t least_parted_questions = 4;

/// The places that part wrong from right ones best, and all alike, at most sixteen: first those that wrong ones come
/// through, in the order in which they are reached. All wrong ones but 3 % must lie on their side, and of right ones at
/// most one in a hundred: more of them only say that it is where such questions go. Where an exception ended one of the
/// wrong ones, no place that right ones alone come through is told: what stands behind a call that was left so
/// is not reached, and its line is.
[[nodiscard]] std::vector<PartingPlace> parting_places(const PassedPlaces& seen);

/// The same place among other questions.
[[nodiscard]] PartingPlace place_among(const PartingPlace& place, const PassedPlaces& others);

/// Does it part them so well?
[[nodiscard]] bool parts(const PartingPlace& place);

/// Are there so few that other inputs must say the same?
[[nodiscard]] bool are_few(const PartingPlace& place);

/// How well a place tells where a mistake is, least first: the share of wrong ones that are not on their side, for no
/// mistake does harm where it is not run; then that of right ones on it, to which it need not make a difference.
[[nodiscard]] std::pair<double, double> strays_of(const PartingPlace& place);

}
