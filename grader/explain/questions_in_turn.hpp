#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "question/log.hpp"

namespace umbral::grader {

/// A question to ask in place of a case's own, and what its answers say of a second one as well.
struct QuestionInTurn {
    OtherQuestion question;
    /// The same change of a struct's field in all calls, where it stands in these calls only.
    std::optional<OtherQuestion> everywhere{};
    std::size_t declared = 0;  ///< its place among all, in the order of the arguments
};

/// All questions that can be asked in place of a case's, each once, in an order that may be cut off anywhere: each part
/// of the arguments has its turn before another has two, with the likeliest ways to misunderstand it first.
///
/// Beside those that the log knows, parts of several calls are changed alike: what `headers` call alike in all calls
/// that made or changed an object, all lists of a function, and all its arguments, if they are of one kind.
[[nodiscard]] std::vector<QuestionInTurn> questions_in_turn(const QuestionLog& log, const std::string& headers);

/// May a call of `function` change what a call of `asked` answers? If it is one itself, or made or changed objects that
/// answer.
[[nodiscard]] bool may_change(const QuestionLog& log, const std::string& function, const std::string& asked);

/// Is it the elements of a list, or their order, that the question changes?
[[nodiscard]] bool is_of_list(const OtherQuestion& question);

/// How far-fetched questions are that are believed only where no simpler one explains as much.
inline constexpr int one_for_another = 3;
inline constexpr int several_at_once = 4;

/// Of questions that fit alike, the one with the least is most easily mistaken for what was asked: an argument that is
/// not looked at at all explains any other change of it.
[[nodiscard]] int far_fetched(const OtherQuestion& question);

}
