#include "explain/answer_lengths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "explain/samples.hpp"
#include "judge/rows/tensor_view.hpp"
#include "question/answer_sizes.hpp"
#include "question/log.hpp"
#include "question/names.hpp"
#include "worker/spent_on_runs.hpp"

#include <umbral/record/reflect.hpp>

namespace umbral::grader {
namespace {

constexpr std::size_t most_told = 2;
constexpr double most_size = 1e15;  ///< a student's run may have written anything

/// The questions that led to rows of the check's table.
std::set<std::uint32_t> questions_of(const QuestionLog& log, const std::string& value)
{
    std::set<std::uint32_t> questions;
    if (const auto rows = log.rows.find(value); rows != log.rows.end())
        for (const std::uint32_t question : rows->second)
            if (question > 0) questions.insert(question - 1);
    return questions;
}

/// Was the same asked in both runs? By what is told of it.
bool is_same_question(const QuestionLog& one, const QuestionLog& other, std::uint32_t question)
{
    const QuestionKind* const a = one.kind_of(question);
    const QuestionKind* const b = other.kind_of(question);
    if (a == nullptr || b == nullptr) return false;
    return a->function == b->function && a->features == b->features &&
           std::ranges::equal(a->questions.at(question), b->questions.at(question), equal_or_both_nan);
}

/// "the answer", "its list edges", "its list polygon.positions".
std::string list_in_words(const std::string& place, const std::vector<std::string>& parameters)
{
    if (place.empty()) return "the answer";
    const bool is_argument = std::isdigit(static_cast<unsigned char>(place.front())) != 0;
    return "its list " + (is_argument ? in_words(place, parameters) : place);
}

/// Does the function return a text? How long it is, is nobody's mistake.
bool returns_text(const std::string& headers, const std::string& function)
{
    return headers.find(fmt::format("std::string {}(", reflect::last_name(function))) != std::string::npos;
}

/// What both sides tell of a check's questions.
struct BothSides {
    const QuestionLog& log;
    QuestionLog told;  ///< by the student's run
    std::set<std::uint32_t> questions{};
    std::set<std::uint32_t> wrong{};
};

/// How long one list is in each answer that can be compared. Empty where that is not what makes answers wrong: what is
/// right with another length may have any, and what is wrong with the right length is wrong by something else.
std::vector<SizePair> lengths_of(const BothSides& sides, const QuestionKind& right, const QuestionKind& yours,
                                 std::size_t list)
{
    std::vector<SizePair> calls;
    for (const auto& [question, sizes] : right.questions) {
        const auto found = yours.questions.find(question);
        if (!sides.questions.contains(question) || found == yours.questions.end()) continue;
        const SizePair pair{found->second.at(list), sizes.at(list)};
        if (!(pair.yours >= 0 && pair.yours < most_size) || !is_same_question(sides.log, sides.told, question))
            continue;
        if ((pair.yours != pair.right) != sides.wrong.contains(question)) return {};
        calls.push_back(pair);
    }
    return calls;
}

std::string sentences(const BothSides& sides, const std::string& headers)
{
    std::string text;
    std::size_t count = 0;
    for (const QuestionKind& right : sides.log.sized) {
        const auto yours = std::ranges::find(sides.told.sized, right.function, &QuestionKind::function);
        if (yours == sides.told.sized.end() || yours->features != right.features) continue;
        for (std::size_t list = 0; list < right.features.size() && count < most_told; ++list) {
            if (right.features[list].empty() && returns_text(headers, right.function)) continue;
            const std::string sentence = sentence_of_sizes(lengths_of(sides, right, *yours, list));
            if (sentence.empty()) continue;
            ++count;
            text += (text.empty() ? "" : "; ") + std::string(reflect::last_name(right.function)) + ": " +
                    list_in_words(right.features[list], parameter_names(headers, right.function)) + " " + sentence;
        }
    }
    return text;
}

}

std::string answer_lengths(Worker& worker, const AskedCheck& asked, SpareTime& time)
{
    if (!time.is_left()) return "";
    const SpentOnRuns spent(time, worker);
    const std::uint64_t seed = input_seed(asked, 0);
    const QuestionLog& log = questions_at(worker, asked, seed);
    BothSides sides{log, {}, questions_of(log, asked.check.value), {}};
    if (log.sized.empty() || sides.questions.empty()) return "";
    for (const AskedAnswer& one : asked_answers(worker, asked, seed).all)
        if (one.answer.wrong) sides.wrong.insert(one.question);
    const RunOutcome& run = asked.runs.told(seed);
    if (run.verdict != Verdict::ok) return "";
    sides.told = read_questions(run.recording.tensors);
    return sentences(sides, asked.headers);
}

}
