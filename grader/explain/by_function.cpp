#include "explain/by_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <map>
#include <string>

#include "explain/some_rows.hpp"
#include "question/log.hpp"

namespace umbral::grader {
namespace {

/// What is known of one function's answers.
struct AnswersOfOne {
    std::vector<FailingCheck> checks;
    std::size_t its_alone = 0;   ///< failing tables whose wrong rows are all of it
    bool beside_others = false;  ///< does any of them hold rows of others, right or wrong?
};

/// Keeps the tables that checks of single functions point to.
struct Parts {
    std::map<std::string, AnswersOfOne> functions;
    std::list<Check> checks;
    std::list<Tensor> tables;
    std::size_t failing = 0;

    const Tensor* part_of(const Tensor* table, const std::vector<std::size_t>& rows)
    {
        if (table == nullptr || table->rows <= rows.back()) return nullptr;
        return &tables.emplace_back(some_rows(*table, rows));
    }
};

/// The rows of a table by the function that was asked for them; those of which nothing is known under no name.
std::map<std::string, std::vector<std::size_t>> rows_by_function(const QuestionLog& log, const std::string& value,
                                                                 std::size_t rows)
{
    std::map<std::string, std::vector<std::size_t>> found;
    for (std::size_t row = 0; row < rows; ++row) {
        const auto question = log.question_of(value, row, rows);
        const QuestionKind* const kind = question ? log.kind_of(*question) : nullptr;
        found[kind == nullptr ? "" : kind->function].push_back(row);
    }
    return found;
}

void take_apart(const QuestionLog& log, const FailingCheck& one, Parts& parts)
{
    if (!has_single_rows(*one.check, one.student, one.expected)) return;
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
        answers.checks.push_back({&check, parts.part_of(one.student, rows), parts.part_of(one.expected, rows),
                                  parts.part_of(one.margin, rows), wrong});
    }
}

/// "In rotate_x: your matrix …"
std::string sentence_of(const std::string& function, std::string sentence)
{
    if (sentence.starts_with("Your ") || sentence.starts_with("The ")) sentence[0] += 'a' - 'A';
    return fmt::format("In {}: {}", function, sentence);
}

}

std::vector<Explanation> by_function(Worker& worker, const Exercise& exercise, std::span<const CaseChecks> groups)
{
    Parts parts;
    for (const CaseChecks& group : groups) {
        if (!group.result->trouble().empty()) continue;
        const QuestionLog& log = worker.questions(exercise, group.name, group.result->seed);
        for (const FailingCheck& one : group.checks) take_apart(log, one, parts);
    }
    std::vector<Explanation> found;
    for (const auto& [function, answers] : parts.functions) {
        if (!answers.beside_others) continue;
        const std::string name = function.substr(function.rfind(':') + 1);
        for (Explanation& one : explain_by_transform(answers.checks)) {
            one.fit = std::min(one.fit, static_cast<double>(answers.its_alone) / static_cast<double>(parts.failing));
            one.name += " in " + name;
            one.sentence = sentence_of(name, std::move(one.sentence));
            found.push_back(std::move(one));
        }
    }
    return found;
}

}
