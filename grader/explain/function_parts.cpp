#include "explain/function_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "explain/some_rows.hpp"
#include "judge/judges.hpp"
#include "question/log.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

/// Which function answered all of these questions; empty if that is not known, or if there are several.
std::string function_of(const QuestionLog& log, const QuestionSpan& asked)
{
    std::string all;
    for (std::uint32_t i = 0; i < asked.count; ++i) {
        const QuestionKind* const kind = log.kind_of(asked.first + i);
        if (kind == nullptr || (i > 0 && kind->function != all)) return "";
        all = kind->function;
    }
    return all;
}

/// The rows of a table by the function that was asked for them; those of which nothing is known under no name.
std::map<std::string, std::vector<std::size_t>> rows_by_function(const QuestionLog& log, const std::string& value,
                                                                 std::size_t rows)
{
    std::map<std::string, std::vector<std::size_t>> found;
    QuestionSpan before;
    std::string function;
    for (std::size_t row = 0; row < rows; ++row) {
        const QuestionSpan asked = log.questions_of(value, row, rows);
        if (!(asked == before)) function = function_of(log, asked);
        before = asked;
        found[function].push_back(row);
    }
    return found;
}

const Tensor* part_of(FunctionParts& parts, const Tensor* table, const std::vector<std::size_t>& rows)
{
    if (table == nullptr || table->rows <= rows.back()) return nullptr;
    return &parts.tables.emplace_back(some_rows(*table, rows));
}

void take_apart(const QuestionLog& log, const CaseChecks& group, const FailingCheck& one, FunctionParts& parts)
{
    const auto functions = rows_by_function(log, one.check->value, one.expected->rows);
    const std::vector<RowState> states = single_rows(*one.check, *one.student, {one.expected, one.margin, nullptr});
    const auto is_wrong = [&](std::size_t row) { return row < states.size() && states[row] == RowState::wrong; };
    const auto with_wrong = std::ranges::count_if(
        functions, [&](const auto& entry) { return std::ranges::any_of(entry.second, is_wrong); });
    parts.failing += one.fails ? 1 : 0;
    for (const auto& [function, rows] : functions) {
        if (function.empty()) continue;
        AnswersOfOne& answers = parts.functions[function];
        const bool wrong = std::ranges::any_of(rows, is_wrong);
        if (one.fails && wrong) {
            answers.its_alone += with_wrong == 1 ? 1 : 0;
            answers.beside_others = answers.beside_others || functions.size() > 1;
        }
        Check& check = parts.checks.emplace_back(*one.check);
        check.pairs = false;
        answers.parts.push_back({&group,
                                 one.check,
                                 {&check, part_of(parts, one.student, rows), part_of(parts, one.expected, rows),
                                  part_of(parts, one.margin, rows), wrong},
                                 rows});
    }
}

void take_whole(const QuestionLog& log, const CaseChecks& group, const FailingCheck& one, FunctionParts& parts)
{
    if (one.expected == nullptr || one.expected->rows == 0 || judge_of(*one.check).look != Look::none) return;
    const auto functions = rows_by_function(log, one.check->value, one.expected->rows);
    if (functions.size() != 1 || functions.begin()->first.empty()) return;
    parts.failing += one.fails ? 1 : 0;
    AnswersOfOne& answers = parts.functions[functions.begin()->first];
    answers.its_alone += one.fails ? 1 : 0;
    answers.parts.push_back({&group, one.check, one});
}

}

FunctionParts parts_by_function(Worker& worker, const Exercise& exercise, std::span<const CaseChecks> groups)
{
    FunctionParts parts;
    for (const CaseChecks& group : groups) {
        if (!group.result->cause().empty()) continue;
        const QuestionLog& log = worker.questions(exercise, group.name, group.result->seed);
        for (const FailingCheck& one : group.checks)
            if (has_single_rows(*one.check, one.student, one.expected))
                take_apart(log, group, one, parts);
            else
                take_whole(log, group, one, parts);
    }
    for (auto& [function, answers] : parts.functions)
        std::ranges::stable_partition(answers.parts, [](const PartOfCheck& one) { return one.part.fails; });
    return parts;
}

std::string sentence_about(const std::vector<std::string>& functions, std::string sentence)
{
    if (sentence.starts_with("Your ") || sentence.starts_with("The ")) sentence[0] += 'a' - 'A';
    std::vector<std::string_view> names;
    for (const std::string& function : functions) names.push_back(reflect::last_name(function));
    return fmt::format("Seen in {}: {}", fmt::join(names, " and "), sentence);
}

}
