#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "explain/asked_answers.hpp"
#include "question/dependence.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

/// The numbers of a question.
struct GivenNumbers {
    const QuestionKind* kind;
    std::uint32_t question;

    /// The one that stands at this place; nothing if there stands more than one, or none.
    [[nodiscard]] std::optional<double> at(const MovedPlace& place) const;
};

/// Answers of a check with the inputs of several seeds, and of other checks of the same function, and what becomes of
/// them as each argument of the function is moved a little. Numbers that a question led to one a row stand in one row,
/// where all questions led to as many. Not to be used when the worker has let go of its runs.
class MovedSamples {
public:
    MovedSamples(Worker& worker, SpareTime& time) : worker_(worker), time_(time) {}

    /// Asks with the inputs of a seed, and adds the answers behind those that are there. Nothing is added where that
    /// takes too long, or where the answers are none that can be compared row by row.
    void add(const AskedCheck& asked, std::uint64_t seed);

    [[nodiscard]] const std::string& function() const noexcept { return function_; }
    /// The first that were added.
    [[nodiscard]] const AskedAnswers& named() const noexcept { return named_; }
    [[nodiscard]] const AnswersToMoves& all() const noexcept { return all_; }
    /// What the wrong rows of all() answer, one by one.
    [[nodiscard]] const std::vector<GivenNumbers>& given() const noexcept { return given_; }

private:
    void add_rows(const AskedAnswers& answers, const QuestionLog& log, const Tensor& right, const Tensor* yours,
                  std::vector<MovedAnswers> moved);

    Worker& worker_;
    SpareTime& time_;
    std::string function_;
    AskedAnswers named_;
    AnswersToMoves all_;
    std::vector<GivenNumbers> given_;
};

}
