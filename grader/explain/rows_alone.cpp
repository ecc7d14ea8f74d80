#include "explain/rows_alone.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "explain/samples.hpp"
#include "question/lost_rows.hpp"
#include "worker/spent_on_runs.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t confirming_place = 13;  ///< of inputs that nothing else is confirmed on
constexpr std::size_t most_confirming = 2;
constexpr std::size_t most_rows_of_call = 400;

/// The names of a row's numbers that most rows without a partner can have; nothing if they have none.
struct Naming {
    std::vector<std::string> columns{};
    bool has_code = false;  ///< the first number says of what kind the row is, and is left out
};

const std::vector<std::string>* columns_of(const AskedAnswers& answers, double code)
{
    const auto kind = answers.kinds.find(code);
    return kind == answers.kinds.end() || kind->second.columns.empty() ? nullptr : &kind->second.columns;
}

Naming naming_of(const AskedAnswers& answers)
{
    if (answers.kinds.empty())
        return {answers.columns.size() == answers.components ? answers.columns : Naming().columns};
    std::map<std::vector<std::string>, std::size_t> count;
    for (const AskedAnswer& one : answers.all)
        for (std::size_t i = 0; one.answer.wrong && i < one.answer.expected.size(); i += answers.components)
            if (const auto* const columns = columns_of(answers, one.answer.expected[i])) ++count[*columns];
    const auto most = std::ranges::max_element(count, {}, [](const auto& one) { return one.second; });
    if (most == count.end()) return {};
    return {{most->first.begin() + 1, most->first.end()}, true};
}

/// The rows of a table that these names are of.
std::vector<std::vector<double>> rows_among(const std::vector<double>& numbers, const AskedAnswers& answers,
                                            const Naming& naming)
{
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i + answers.components <= numbers.size() && rows.size() < most_rows_of_call;
         i += answers.components) {
        const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(i);
        std::vector<double> row(first, first + static_cast<std::ptrdiff_t>(answers.components));
        if (naming.has_code) {
            const auto* const columns = columns_of(answers, row.front());
            if (columns == nullptr ||
                !std::equal(columns->begin() + 1, columns->end(), naming.columns.begin(), naming.columns.end()))
                continue;
            row.erase(row.begin());
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<RowsOfCall> calls_in(const AskedAnswers& answers, const Naming& naming)
{
    std::vector<RowsOfCall> calls;
    for (const AskedAnswer& one : answers.all)
        if (!one.row && !one.answer.refused)
            calls.push_back(
                {rows_among(one.answer.yours, answers, naming), rows_among(one.answer.expected, answers, naming)});
    return calls;
}

}

std::string rows_alone(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    if (!time.is_left()) return "";
    const SpentOnRuns spent(time, worker);
    const AskedAnswers seen = asked_answers(worker, asked, input_seed(asked, 0));
    const Naming naming = naming_of(seen);
    const std::vector<RowsOfCall> calls = calls_in(seen, naming);
    std::string text;
    for (const Side side : {Side::expected, Side::yours}) {
        if (calls.empty() || naming.columns.empty() || !text.empty()) break;
        const std::optional<Condition> condition = condition_of_alone(told_rows(calls, side, naming.columns));
        std::size_t confirmed = 0;
        bool holds = condition.has_value();
        for (std::size_t i = 0; i < most_confirming && holds; ++i) {
            const AskedAnswers fresh = asked_answers(worker, asked, varied_seed(asked, confirming_place + i));
            const ToldRows rows = told_rows(calls_in(fresh, naming), side, naming.columns);
            if (std::ranges::count(rows.alone, true) == 0) continue;
            holds = parts(*condition, rows.facts, rows.alone);
            ++confirmed;
        }
        if (holds && confirmed > 0) text = sentence_of_alone(side, *condition);
    }
    return text;
}

}
