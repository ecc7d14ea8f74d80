#include "unit/long_questions.hpp"

#include <filesystem>
#include <span>

#include "question/log.hpp"
#include "unit/artefacts.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_files = 3;
constexpr std::size_t most_bytes = std::size_t{1} << 20U;

/// Does code leave elements of lists out? It says "… 12 more" in their place.
bool is_shortened(const std::string& code) { return code.find("…") != std::string::npos; }

/// The question behind a check's first wrong value with all elements of its lists; empty if that is not known.
std::string in_full(Worker& worker, const Exercise& exercise, const Check& check, const CaseResult& one,
                    const Difference& first)
{
    if (!first.cell) return "";
    const Tensor* expected =
        tensor_of(worker.trusted(exercise, Answers::reference, check.case_name, one.seed), check.value);
    const auto question = worker.questions(exercise, check.case_name, one.seed)
                              .question_of(check.value, *first.cell, expected == nullptr ? 0 : expected->cells());
    if (!question) return "";
    const RunOutcome told = worker.inquire(exercise, Answers::reference, check.case_name, one.seed,
                                           {.wanted = {*question}, .in_full = true});
    if (told.verdict != Verdict::ok) return "";
    const QuestionLog log = read_questions(told.recording.tensors);
    const auto found = log.code.find(*question);
    return found == log.code.end() ? std::string() : found->second;
}

}

void save_long_questions(Worker& worker, const Exercise& exercise, const CaseResults& cases,
                         const GradeOptions& options, UnitResult& result)
{
    std::size_t saved = 0;
    for (std::size_t i = 0; i < exercise.checks.size() && saved < most_files; ++i) {
        const Check& check = exercise.checks[i];
        CheckResult& found = result.checks[i];
        // What is shown in full needs no file, and finding that out a run.
        if (check.hidden || !found.first_difference || !is_shortened(found.first_difference->question)) continue;
        const std::string code = in_full(worker, exercise, check, cases.at(check.case_name), *found.first_difference);
        if (code.empty() || code == found.first_difference->question || code.size() > most_bytes) continue;
        const std::filesystem::path file = options.artefacts / artefact_name(exercise, check, ".txt");
        const std::string text = code + '\n';
        try {
            write_artefact(file, std::as_bytes(std::span(text)));
        } catch (const std::exception&) {
            continue;  // a file too few disturbs nobody: the question itself is shown
        }
        std::error_code failed;
        found.artefacts["question"] = std::filesystem::relative(file, options.relative_to, failed).string();
        ++saved;
    }
}

}
