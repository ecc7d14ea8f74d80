#include "explain/simpler_questions.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "explain/questions_in_turn.hpp"
#include "question/movable.hpp"

namespace umbral::grader {
namespace {

/// Whether the change takes something away that code can be wrong about, and leaves a question that is one still: its
/// place among those that do, the likeliest first.
std::optional<int> rank(const OtherQuestion& question)
{
    constexpr std::array<std::string_view, 3> neutral{"taken as 0", "taken as 1", "taken as the identity"};
    constexpr std::array<std::string_view, 3> simpler{"normalised", "limited to [0, 1]", "rounded towards 0"};
    constexpr std::array<std::string_view, 2> equal{"with y taken as x", "with z taken as y"};
    const std::string_view change = question.change;
    const auto is_one_of = [&](const auto& all) { return std::ranges::find(all, change) != all.end(); };
    if (change == "in reverse order") return std::nullopt;
    if (leaves_out(question)) return 0;
    if (!question.also.empty()) return std::nullopt;
    if (is_one_of(neutral)) return 0;
    if (is_one_of(simpler) || change.starts_with("without ")) return 1;
    if (is_one_of(equal)) return 2;
    return change == taken_for_another ? std::optional(3) : std::nullopt;
}

/// Numbers and vectors that are equal are a simpler case. Lists and structs that are have nothing left to do.
bool is_number_or_vector(const QuestionLog& log, const OtherQuestion& question)
{
    return std::ranges::any_of(log.kinds, [&](const QuestionKind& kind) {
        return kind.function == question.function &&
               std::ranges::any_of(kind.features, [&](const std::string& feature) {
                   return feature == question.place || feature == question.place + ".x";
               });
    });
}

}

bool leaves_out(const OtherQuestion& question) { return question.change == left_out || is_of_list(question); }

std::vector<OtherQuestion> simpler_questions(const QuestionLog& log, const std::string& function,
                                             const std::string& headers)
{
    std::vector<std::pair<int, OtherQuestion>> likely;
    for (QuestionInTurn& one : questions_in_turn(log, headers)) {
        const std::string& of = one.question.function;
        const bool is_list_taken =
            !of.empty() && one.question.change == taken_for_another && !is_number_or_vector(log, one.question);
        const std::optional<int> place = rank(one.question);
        if (place && !is_list_taken && (of.empty() || may_change(log, of, function)) &&
            !is_of_unit_length(log, one.question))
            likely.emplace_back(*place, std::move(one.question));
    }
    std::ranges::stable_sort(likely, {}, &std::pair<int, OtherQuestion>::first);
    std::vector<OtherQuestion> all;
    for (auto& [place, question] : likely) all.push_back(std::move(question));
    return all;
}

}
