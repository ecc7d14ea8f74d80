#include "explain/wrong_dependence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "explain/moved_samples.hpp"
#include "explain/samples.hpp"
#include "judge/judges.hpp"
#include "question/dependence.hpp"
#include "question/error_dependence.hpp"
#include "question/names.hpp"
#include "text/joined.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

constexpr std::size_t fresh_place = 11;  ///< of practice inputs, behind those that conditions are confirmed on; two
constexpr std::size_t enough_moved = 8;  ///< answers; of fewer, other cases are asked too
constexpr std::size_t least_moved = 4;   ///< answers; of fewer it may come of their inputs, as a ray along an axis
constexpr std::size_t most_told = 2;     ///< kinds of dependence
constexpr std::size_t most_named = 3;    ///< numbers of an answer

/// An error, and the number on which it depends.
struct ErrorAt {
    double given;
    double error;
};

/// The wrong answers where that number is least, and where it is most; nothing if they do not differ.
std::optional<std::pair<ErrorAt, ErrorAt>> least_and_most(const ErrorDependence& one, const MovedTable& answers)
{
    std::vector<ErrorAt> all;
    for (std::size_t i = 0; i < answers.given.size(); ++i) {
        const std::optional<double> given = answers.given[i].at(one.place);
        if (!given) return std::nullopt;
        const std::size_t number = answers.all.wrong[i] * answers.all.components + one.components.front();
        const double yours = answers.all.yours.at(number);
        const double right = answers.all.right.at(number);
        const double error = one.kind == ErrorKind::factor ? yours / right : yours - right;
        if (std::isfinite(error)) all.push_back({*given, error});
    }
    if (all.empty()) return std::nullopt;
    const auto [least, most] = std::ranges::minmax(all, {}, &ErrorAt::given);
    return least.given < most.given ? std::optional(std::pair(least, most)) : std::nullopt;
}

/// Writes what answers depend on in the words of the unit's headers.
class Words {
public:
    Words(const std::string& headers, std::string function) : headers_(headers), function_(std::move(function)) {}

    [[nodiscard]] std::string sentence(const Dependence& one, const AskedAnswers& answers) const
    {
        std::string text;
        if (one.lacking.empty())
            text = fmt::format("your wrong answers change with {}, and the right ones do not", words(one.wrongly));
        else if (one.wrongly.empty())
            text = fmt::format("your wrong answers do not change with {}, and the right ones do", words(one.lacking));
        else
            text = fmt::format("your wrong answers change with {}, and the right ones with {} instead",
                               words(one.wrongly), words(one.lacking));
        return in_numbers(one.components, answers) + text;
    }

    [[nodiscard]] std::string sentence(const ErrorDependence& one, const MovedTable& answers) const
    {
        const bool is_factor = one.kind == ErrorKind::factor;
        std::string text = in_numbers(one.components, answers.named);
        text += is_factor ? "your wrong answers are multiples of the right ones, and which depends on "
                          : "what your wrong answers are more than the right ones depends on ";
        text += word(one.place) + " alone";
        if (const auto ends = least_and_most(one, answers))
            text += fmt::format(" ({:.3g}{} where it is {:.4g}, {:.3g} where it is {:.4g})", ends->first.error,
                                is_factor ? " times" : "", ends->first.given, ends->second.error, ends->second.given);
        return text;
    }

private:
    /// "in x, y "; empty where it is all numbers of an answer.
    [[nodiscard]] static std::string in_numbers(const std::vector<std::size_t>& components, const AskedAnswers& answers)
    {
        if (components.size() == answers.components) return "";
        std::vector<std::string> names;
        for (const std::size_t i : components)
            if (i < answers.columns.size()) names.push_back(answers.columns[i]);
        return fmt::format("in {} ", fmt::join(names, ", "));
    }

    [[nodiscard]] std::string word(const MovedPlace& one) const
    {
        std::string text = (one.is_length    ? "the length of "
                            : one.is_order   ? "the order of "
                            : one.is_corners ? "which corner comes first in each of "
                                             : "") +
                           in_words(one.place, parameter_names(headers_, one.function));
        if (one.function != function_) text += " of " + std::string(reflect::last_name(one.function));
        return text;
    }

    [[nodiscard]] std::string words(const std::vector<MovedPlace>& places) const
    {
        std::vector<std::string> all;
        for (const MovedPlace& place : places) all.push_back(word(place));
        return joined_with_and(all);
    }

    const std::string& headers_;
    std::string function_;
};

/// May it be said of these numbers? Those without a name of their own are told of only if it is all of them.
bool can_be_named(const std::vector<std::size_t>& components, const AskedAnswers& answers)
{
    if (components.size() == answers.components) return true;
    return components.size() <= most_named &&
           std::ranges::all_of(components, [&](std::size_t i) { return i < answers.columns.size(); });
}

/// Of numbers of which nothing else is told, the first.
std::optional<ErrorDependence> error_to_tell(const MovedTable& answers, const std::vector<MoveReactions>& moves,
                                             const std::vector<Dependence>& told)
{
    for (ErrorDependence& one : error_dependences(moves)) {
        const auto is_told = [&](const Dependence& other) {
            return std::ranges::find_first_of(one.components, other.components) != one.components.end();
        };
        if (std::ranges::none_of(told, is_told) && can_be_named(one.components, answers.named)) return std::move(one);
    }
    return std::nullopt;
}

/// All that is told of answers; empty if there are too few wrong ones.
std::string sentences(const MovedTable& answers, const Words& words)
{
    if (answers.all.wrong.size() < least_moved) return "";
    const std::vector<MoveReactions> moves = reactions(answers.all);
    std::vector<Dependence> found = dependences(moves);
    std::erase_if(found, [&](const Dependence& one) { return !can_be_named(one.components, answers.named); });
    // What a number depends on instead says more than that it depends on something.
    std::ranges::stable_sort(found, {},
                             [](const Dependence& one) { return one.wrongly.empty() || one.lacking.empty(); });
    if (found.size() > most_told) found.resize(most_told);
    std::string text;
    const auto add = [&](const std::string& sentence) { text += (text.empty() ? "" : "; ") + sentence; };
    for (const Dependence& one : found) add(words.sentence(one, answers.named));
    if (const auto error = error_to_tell(answers, moves, found)) add(words.sentence(*error, answers));
    return text;
}

}

std::string wrong_dependence(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    if (!time.is_left() || asked.check.relation || !judge_of(asked.check).plain_values) return "";
    MovedSamples answers(worker, time);
    answers.add(asked, input_seed(asked, 0));
    answers.add(asked, varied_seed(asked, fresh_place));
    if (!asked.exercise.gl) answers.add(asked, varied_seed(asked, fresh_place + 1));
    const MovedTable& table = answers.table();
    if (table.all.moved.empty()) return "";
    const auto is_enough = [&] { return table.all.wrong.size() >= enough_moved || !time.is_left(); };
    if (asked.others)
        asked.others([&](const AskedCheck& other) {
            if (!is_enough()) answers.add(other, input_seed(other, 0));
            return !is_enough();
        });
    const Words words(asked.headers, answers.function());
    std::string text = sentences(table, words);
    if (!text.empty()) return text;
    const auto by_questions = answers.by_questions();
    return by_questions ? sentences(*by_questions, words) : "";
}

}
