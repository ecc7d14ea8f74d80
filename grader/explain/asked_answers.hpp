#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "question/answer_patterns.hpp"
#include "question/log.hpp"
#include "worker/case_results.hpp"
#include "worker/case_runs.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// One failing check, and the questions of its case.
struct AskedCheck {
    const Exercise& exercise;
    const Check& check;
    CaseRuns& runs;  ///< of the check's case
    const CaseResult& result;
    const QuestionLog& log;
    const std::string& headers;  ///< the text of the unit's interface headers, where its parameters have names
    /// Calls `look` with checks of other visible cases, which may fail or not, until it says that no more is wanted:
    /// first of what is recorded under the same name; null where there are none.
    std::function<void(const std::function<bool(const AskedCheck&)>& look)> others{};
};

/// A question, and the student's answer to it beside the right one.
struct AskedAnswer {
    std::uint32_t question = 0;
    std::optional<std::size_t> row{};  ///< of the expected table, where rows are compared one by one
    AnswerPair answer{};
};

/// The first question of which all rows together are wrong.
struct WrongGroup {
    std::uint32_t question = 0;
    std::optional<Difference> first{};  ///< within its rows; the cell is one of the whole table
    std::string words{};    ///< "row 12: expected crowded edge (5, 6), nothing came"; empty if the check's own say more
    bool as_first = false;  ///< the words say what stands in `first`, and no more
};

/// What a check's questions were answered.
struct AskedAnswers {
    std::vector<AskedAnswer> all{};
    std::size_t components = 1;
    std::size_t keys = 0;                ///< of them, those that say what the row is about
    std::vector<std::string> columns{};  ///< what the numbers of a row are called
    bool optional = false;               ///< an answer may be that there is none
    bool picture = false;                ///< they are the cells of a picture or a buffer
    /// Where rows are events: what they are called, by their first number.
    std::map<double, NamedRows> kinds{};
    std::optional<WrongGroup> first_wrong{};  ///< where the rows of a question are judged together
};

/// The questions that the check's case asks with the inputs of a seed.
[[nodiscard]] const QuestionLog& questions_at(Worker& worker, const AskedCheck& asked, std::uint64_t seed);

/// The answers with the inputs of a seed: row by row where rows are compared so, else, where their number is free or
/// another one than expected, all rows of a question together. Empty where neither can be said. The student's code may
/// be run again.
[[nodiscard]] AskedAnswers asked_answers(Worker& worker, const AskedCheck& asked, std::uint64_t seed);

/// The function that most wrong answers were asked of; empty where that is not known.
[[nodiscard]] std::string function_asked_most(const AskedAnswers& answers, const QuestionLog& log);
/// The function that most rows of a value are answers of, or the only one that is asked; else empty.
[[nodiscard]] std::string function_asked_most(const QuestionLog& log, const std::string& value);

/// The first question of which the rows together are wrong, and what is wrong in them: what came in a call stands
/// beside what was expected of that call, where a table as a whole only shows what is lacking and too much.
[[nodiscard]] std::optional<WrongGroup> first_wrong_group(Worker& worker, const AskedCheck& asked, std::uint64_t seed);

}
