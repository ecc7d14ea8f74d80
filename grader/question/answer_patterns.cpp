#include "question/answer_patterns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <span>

#include "judge/rows/tensor_view.hpp"
#include "question/alike.hpp"
#include "question/answer_columns.hpp"
#include "question/answer_places.hpp"
#include "question/answer_range.hpp"
#include "question/answer_relations.hpp"
#include "question/list_patterns.hpp"
#include "question/matrix_lines.hpp"
#include "question/nearly_right.hpp"
#include "question/number_changes.hpp"
#include "question/wrong_numbers.hpp"

namespace umbral::grader {
namespace {

using Pairs = std::vector<const AnswerPair*>;

Pairs wrong_pairs(const AnswerTable& table)
{
    Pairs wrong;
    for (const AnswerPair& one : table.answers)
        if (one.wrong) wrong.push_back(&one);
    return wrong;
}

bool all_equal(const Pairs& pairs, const std::vector<double> AnswerPair::*side)
{
    return std::ranges::all_of(pairs,
                               [&](const AnswerPair* one) { return alike_rows(one->*side, pairs.front()->*side); });
}

/// "0", "(0, 0, 1)"
std::string in_words(std::span<const double> numbers)
{
    if (numbers.size() == 1) return number_text(numbers.front());
    std::vector<std::string> all;
    for (const double number : numbers) all.push_back(number_text(number));
    return fmt::format("({})", fmt::join(all, ", "));
}

void add(std::vector<std::string> words, std::vector<AnswerPattern>& found)
{
    for (std::string& one : words) found.push_back({std::move(one)});
}

auto first_vague(std::vector<AnswerPattern>& found)
{
    return std::ranges::find_if(found, [](const AnswerPattern& one) { return is_vague(one.tells); });
}

bool is_missing(const AnswerPair* one) { return one->yours.empty(); }
bool is_too_much(const AnswerPair* one) { return one->expected.empty(); }
bool is_finite_number(double x) { return std::isfinite(x); }

/// Whether there is an answer, and whether it is one at all; nothing if all are answers.
std::optional<std::vector<AnswerPattern>> presence(const AnswerTable& table, const Pairs& wrong)
{
    if (std::ranges::all_of(wrong, &AnswerPair::refused)) return std::vector<AnswerPattern>{{all_refused}};
    const bool missing = std::ranges::all_of(wrong, is_missing);
    if (missing || std::ranges::all_of(wrong, is_too_much)) {
        // That events are missing is plain to see; which they are is not.
        if (table.kinds.empty()) return std::vector<AnswerPattern>{{missing ? none_given : "should be empty"}};
        std::vector<AnswerPattern> kinds;
        add(kind_patterns(table, wrong), kinds);
        return kinds;
    }
    const auto is_no_number = [&](const AnswerPair* one) { return !std::ranges::all_of(one->yours, is_finite_number); };
    if (!std::ranges::all_of(wrong, is_no_number)) return std::nullopt;
    const auto is_filled = [](const AnswerPair* one) {
        return std::ranges::all_of(one->yours, [](double x) { return std::isnan(x); });
    };
    const bool may_be_filled = table.several && std::ranges::all_of(wrong, is_filled);
    return std::vector<AnswerPattern>{
        {may_be_filled ? "is no number (NaN), or was not given at all" : "is not finite"}};
}

/// Where all have the same size and are finite.
bool can_be_compared(const Pairs& wrong)
{
    return std::ranges::all_of(wrong, [](const AnswerPair* one) {
        return !one->expected.empty() && one->yours.size() == one->expected.size() &&
               std::ranges::all_of(one->yours, is_finite_number) &&
               std::ranges::all_of(one->expected, is_finite_number);
    });
}

void add_constant(const Pairs& wrong, std::vector<AnswerPattern>& found)
{
    constexpr std::size_t most_numbers = 4;
    if (wrong.front()->yours.size() > most_numbers || wrong.front()->yours.empty()) return;
    if (all_equal(wrong, &AnswerPair::yours) && !all_equal(wrong, &AnswerPair::expected))
        found.push_back({"is " + in_words(wrong.front()->yours), CommonTells::constant});
}

/// Is each of them what stands in the row before: the right answer there, or the student's own?
bool are_of_rows_before(const AnswerTable& table, const Pairs& wrong, std::vector<double> AnswerPair::*whose)
{
    std::set<std::vector<double>> different;
    for (const AnswerPair* one : wrong) {
        if (one == table.answers.data() || !alike_rows(one->yours, (one - 1)->*whose)) return false;
        different.insert(one->yours);
    }
    return different.size() >= least_wrong;
}

/// State that a call leaves behind for the next; or, where a question has several answers, so that the row before is
/// another one of the same call, an index that was not moved on.
std::optional<AnswerPattern> before_once_more(const AnswerTable& table, const Pairs& wrong)
{
    if (!table.several && are_of_rows_before(table, wrong, &AnswerPair::expected))
        return AnswerPattern{"is the right one to the question before"};
    if (table.several && are_of_rows_before(table, wrong, &AnswerPair::yours))
        return AnswerPattern{"is your row before it once more"};
    return std::nullopt;
}

/// What each wrong number is, where a row has several, if it is the same for all.
void add_change_of_all(const AnswerTable& table, const Pairs& wrong, const std::vector<std::size_t>& which,
                       const std::string& place, std::vector<AnswerPattern>& found)
{
    const NumberPairs numbers = numbers_in(wrong, table.components, which);
    const auto change = change_of_numbers(numbers.yours, numbers.right);
    if (!change) return;
    if (which.size() == table.components)
        found.push_back({fmt::format("is {}, in each of its numbers", change->words)});
    if (!place.empty()) found.push_back({fmt::format("{}, where each number is {}", place, change->words)});
}

/// Other inputs of the same kind may be those where all are nearly right.
void add_mostly_nearly_right(const AnswerTable& table, const Pairs& wrong, std::vector<AnswerPattern>& found)
{
    if (!table.picture && are_mostly_nearly_right(table, wrong))
        found.push_back({mostly_nearly_right, CommonTells::mostly});
}

/// On which side of the right numbers all wrong ones lie.
void add_side(const AnswerTable& table, const Pairs& wrong, const std::vector<std::size_t>& which,
              const std::string& place, std::vector<AnswerPattern>& found)
{
    constexpr std::size_t least_answers = 8;  ///< of fewer, all may lie on one side by chance
    if (wrong.size() < least_answers || table.picture) return;
    const NumberPairs numbers = numbers_in(wrong, table.components, which);
    const auto side = side_of_numbers(numbers.yours, numbers.right);
    if (!side) return;
    if (table.components == 1)
        found.push_back({"is " + *side, CommonTells::side});
    else if (which.size() == 1 && !place.empty())
        found.push_back({fmt::format("{}, which is {}", place, *side), CommonTells::side});
    else if (which.size() > 1 && table.keys == 0 && table.components <= 4)
        found.push_back({fmt::format("is {} in each number that differs", *side), CommonTells::side});
}

/// Which numbers of a row are wrong, in words; empty where a row is one number, or no words say it.
std::string place_of_wrong(const AnswerTable& table, const Pairs& wrong, const std::vector<std::size_t>& which)
{
    return table.components == 1 ? "" : place_of(table, which, columns_of_wrong_rows(table, wrong));
}

/// Bounds that no answer passes. That right ones are cut stands before what it makes of the wrong ones: these may all
/// be 0, say.
void add_range(const AnswerTable& table, const Pairs& wrong, std::vector<AnswerPattern>& found)
{
    if (table.picture || !table.kinds.empty()) return;
    const std::vector<std::size_t> which = wrong_components(wrong, table.components);
    const auto range = range_of_answers(table, wrong, which);
    if (!range) return;
    const std::string place = which.size() == 1 ? place_of_wrong(table, wrong, which) : "";
    std::string words = place.empty() ? range->words : fmt::format("{}, which {}", place, range->words);
    found.insert(range->is_cut ? found.begin() : first_vague(found), {std::move(words)});
}

/// Of so few anything may be true, but not that a number has wrapped round; and that the same numbers of a row are
/// wrong is what is seen.
void add_to_few(const AnswerTable& table, const Pairs& wrong, std::vector<AnswerPattern>& found)
{
    if (wrong.empty() || !can_be_compared(wrong)) return;
    const std::vector<std::size_t> which = wrong_components(wrong, table.components);
    const std::string place = place_of_wrong(table, wrong, which);
    const NumberPairs numbers = numbers_in(wrong, table.components, which);
    if (const auto change = wrapped_numbers(numbers.yours, numbers.right))
        found.push_back({place.empty() ? "is " + *change : fmt::format("{}, which is {}", place, *change)});
    else if (wrong.size() > 1 && !place.empty())
        found.push_back({place, CommonTells::place});
}

/// What is so of the numbers of an answer, the most telling first.
void add_components(const AnswerTable& table, const Pairs& wrong, std::vector<AnswerPattern>& found)
{
    const std::vector<std::size_t> which = wrong_components(wrong, table.components);
    const std::vector<std::string> columns = columns_of_wrong_rows(table, wrong);
    const auto change = which.size() == 1 ? change_of(table, wrong, which.front(), columns) : std::nullopt;
    std::string place = table.components == 1 ? "" : place_of(table, which, columns);
    if (place.empty()) place = all_but_one(table, wrong, which, columns);
    if (which.size() > 1 && table.components <= 4) {
        WrongVectors vectors = wrong_vectors(table, wrong, 0, table.components);
        if (table.columns.size() == table.components) vectors.names = table.columns;
        if (auto relation = relation_of(vectors, table.facts)) found.push_back(std::move(*relation));
    }
    if (which.size() > 1)
        if (const auto distance = distance_of(table, wrong, which, columns)) found.push_back({"is " + *distance});
    for (AnswerPattern& one : matrix_line_patterns(table, wrong, which)) found.push_back(std::move(one));
    if (which.size() > 1) add_change_of_all(table, wrong, which, place, found);
    if (which.size() > 1 && !place.empty())
        if (const auto other = of_another_name(table, wrong, which, columns))
            found.push_back({fmt::format("{}, which is {}", place, *other)});
    if (change && table.components == 1) found.push_back({"is " + change->words, change->tells});
    if (change && !place.empty()) found.push_back({fmt::format("{}, which is {}", place, change->words)});
    if (const char* const nearly = nearly_right(table, wrong))
        found.push_back({place.empty() ? nearly : fmt::format("{}, and {}", place, nearly), CommonTells::nearly});
    add_mostly_nearly_right(table, wrong, found);
    add_side(table, wrong, which, place, found);
    if (!place.empty()) found.push_back({place, CommonTells::place});
}

}

bool are_comparable(const AnswerTable& table) { return can_be_compared(wrong_pairs(table)); }

std::vector<AnswerPattern> answer_patterns(const AnswerTable& table)
{
    const Pairs wrong = wrong_pairs(table);
    std::vector<AnswerPattern> found;
    if (wrong.size() < least_wrong) {
        add_to_few(table, wrong, found);
        return found;
    }
    if (auto said = presence(table, wrong)) return std::move(*said);
    if (!table.picture) add_constant(wrong, found);
    add(list_patterns(table, wrong), found);
    add(kind_patterns(table, wrong), found);
    if (can_be_compared(wrong)) {
        add_components(table, wrong, found);
        // An argument may be the right answer to the question before: that explains more simply.
        if (auto before = before_once_more(table, wrong)) found.insert(first_vague(found), *std::move(before));
        add_range(table, wrong, found);
    } else {
        add_mostly_nearly_right(table, wrong, found);
    }
    return found;
}

}
