#include "worker/shared_runs.hpp"

namespace umbral::grader {
namespace {

/// Enough for the visible cases of a good part of a course; hidden seeds differ by student and push old runs out.
constexpr std::size_t most_in_runs = std::size_t{256} << 20U;
constexpr std::size_t most_in_answers = std::size_t{128} << 20U;
constexpr std::size_t most_in_questions = std::size_t{192} << 20U;
constexpr std::size_t most_in_codes = std::size_t{16} << 20U;
/// What a question takes beside its numbers: its place in a map, and a list's head.
constexpr std::size_t bytes_of_a_question = 96;

std::size_t bytes_of(const RunOutcome& outcome)
{
    std::size_t bytes = sizeof outcome;
    for (const auto& [name, tensor] : outcome.recording.tensors) bytes += tensor.bytes.size() + tensor.present.size();
    return bytes;
}

std::size_t bytes_of(const QuestionLog& log)
{
    std::size_t bytes = sizeof log;
    for (const QuestionKind& kind : log.kinds)
        bytes += kind.questions.size() * (bytes_of_a_question + kind.features.size() * sizeof(double));
    return bytes;
}

std::size_t bytes_of(const SharedRuns::Texts& texts)
{
    std::size_t bytes = sizeof texts;
    for (const auto& [question, text] : texts) bytes += bytes_of_a_question + text.size();
    return bytes;
}

template <class Value>
MadeOnce<Value> remembering(std::size_t most)
{
    return MadeOnce<Value>(most, [](const Value& value) { return bytes_of(value); });
}

}

SharedRuns::SharedRuns()
    : runs(remembering<RunOutcome>(most_in_runs)),
      answers_to_others(remembering<RunOutcome>(most_in_answers)),
      questions(remembering<QuestionLog>(most_in_questions)),
      codes(remembering<Texts>(most_in_codes))
{
}

}
