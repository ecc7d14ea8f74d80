#pragma once

#include <optional>
#include <string>
#include <vector>

#include "build/submission.hpp"
#include "worker/case_results.hpp"
#include "worker/worker.hpp"

namespace umbral::grader {

/// Runs a case that crashed, found no memory or did not end again, without the questions in which it did, and keeps in
/// `one` what that gives, so that one edge case does not cost what has nothing to do with it. Of a function that
/// crashes too often, or is endless (is_endless), nothing more is asked; a question that is endless and is no known
/// function's ends the case. Nothing is kept where the same happens without them.
void go_past_crashes(Worker& worker, const Exercise& exercise, const Built& built, const std::string& case_name,
                     CaseResult& one);

/// The functions in which the cases that were endless ended, and those that call these; none if that is not known of
/// one of them.
[[nodiscard]] std::vector<std::string> functions_that_hung(const Exercise& exercise, const CaseResults& cases);

/// Runs a case that is not reached, because too many before it were endless, without asking these functions: what
/// others answer is judged. Nothing is if it does not end well without them either, or no time is left.
void run_without(Worker& worker, const Exercise& exercise, const Built& built, const std::string& case_name,
                 const std::vector<std::string>& functions, CaseResult& one);

/// The question in which a visible case ended, as code; empty if that is not known.
[[nodiscard]] std::string question_of_end(Worker& worker, const Exercise& exercise, const std::string& case_name,
                                          const CaseResult& one);

/// The rows of a check that the run itself says have no answer. Whoever forges them names others of their own rows.
[[nodiscard]] std::vector<std::uint32_t> rows_without_answers(const Check& check, const RunOutcome& run);

/// What a case that crashed, or reached a stub, recorded for a check.
struct AnswersPastCrashes {
    Tensor tensor;                  ///< of the expected shape
    std::vector<std::size_t> lost;  ///< rows that follow from no answer, in order: made wrong, whatever they hold
};

/// Nothing if the check's rows are not compared one by one, or none were recorded.
[[nodiscard]] std::optional<AnswersPastCrashes> answers_past_crashes(const Check& check, const CaseResult& one,
                                                                     const Tensor& expected);

}
