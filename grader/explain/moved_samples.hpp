#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "explain/asked_answers.hpp"
#include "question/reactions.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// The numbers of a question.
struct GivenNumbers {
    const QuestionKind* kind;
    std::uint32_t question;

    /// The one that stands at this place; nothing if there stands more than one, or none.
    [[nodiscard]] std::optional<double> at(const MovedPlace& place) const;
};

/// Answers, and what becomes of them as each argument of the function is moved a little.
struct MovedTable {
    AskedAnswers named{};  ///< the first of them, as they were asked
    AnswersToMoves all{};
    std::vector<GivenNumbers> given{};  ///< what the wrong rows of `all` answer, one by one
};

/// Collects answers of a check with the inputs of several seeds, and of other checks of the same function. Not to be
/// used when the worker has let go of its runs.
class MovedSamples {
public:
    MovedSamples(Worker& worker, SpareTime& time) : worker_(worker), time_(time) {}

    /// Asks with the inputs of a seed, and adds the answers behind those that are there. Nothing is added where that
    /// takes too long, or where the answers are none that can be compared row by row.
    void add(const AskedCheck& asked, std::uint64_t seed);

    [[nodiscard]] const std::string& function() const noexcept { return function_; }
    [[nodiscard]] const MovedTable& table() const noexcept { return table_; }
    /// The table where the numbers that a question led to, one a row, are those of one row: each may depend on other
    /// things. Nothing where not all questions led to as many, two or a few more.
    [[nodiscard]] std::optional<MovedTable> by_questions() const;

private:
    void add_rows(const AskedAnswers& answers, const QuestionLog& log, const Tensor& right, const Tensor* yours,
                  std::vector<MovedAnswers> moved);

    Worker& worker_;
    SpareTime& time_;
    std::string function_;
    MovedTable table_;
    std::optional<std::size_t> rows_of_each_;  ///< question; 1 where it is not the same number everywhere
};

}
