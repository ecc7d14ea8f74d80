#include "explain/other_answers.hpp"

#include <algorithm>
#include <charconv>

#include "explain/weighed_questions.hpp"
#include "worker/at_once.hpp"

#include <umbral/record/questions.hpp>

namespace umbral::grader {
namespace {

/// As many as one run of each side can hold.
void ask_at_once(Worker& worker, const AskedCheck& asked, std::uint64_t seed, std::span<OtherAnswers> others,
                 SpareTime& time)
{
    if (others.empty() || !time.is_left()) return;
    std::vector<OtherQuestion> questions;
    for (const OtherAnswers& one : others) questions.push_back(one.question);
    const Check& check = asked.check;
    MadeOnce<RunOutcome>::Pointer right;
    RunOutcome yours;
    at_once(
        worker,
        [&](Worker& one) {
            yours = one.run_moved(asked.exercise, asked.runs.built(), check.case_name, seed, questions, check.value);
        },
        [&](Worker& one) {
            right = one.answers_to_others(asked.exercise, judged_against(check), check.case_name, seed, questions);
        });
    time.spend(SpareTime::cost_of(*right) + SpareTime::cost_of(yours));
    if (right->verdict != Verdict::ok || yours.verdict != Verdict::ok) {
        if (others.size() == 1) return;
        ask_at_once(worker, asked, seed, others.first(others.size() / 2), time);
        ask_at_once(worker, asked, seed, others.subspan(others.size() / 2), time);
        return;
    }
    std::vector<RunOutcome> right_runs = runs_of_others(*right, others.size());
    std::vector<RunOutcome> your_runs = runs_of_others(yours, others.size());
    for (std::size_t i = 0; i < others.size(); ++i) {
        others[i].answered = true;
        others[i].right = std::move(right_runs[i]);
        others[i].yours = std::move(your_runs[i]);
    }
}

}

std::vector<RunOutcome> runs_of_others(const RunOutcome& run, std::size_t count)
{
    std::vector<RunOutcome> runs(count);
    for (RunOutcome& one : runs) one.verdict = run.verdict;
    for (const auto& [name, tensor] : run.recording.tensors) {
        const std::size_t mark = name.find(question_names::of_other);
        if (mark == std::string::npos) continue;
        std::size_t number = count;
        const auto end = std::from_chars(name.data(), name.data() + mark, number);
        if (end.ec != std::errc() || end.ptr != name.data() + mark || number >= count) continue;
        runs[number].recording.tensors[name.substr(mark + 1)] = tensor;
    }
    return runs;
}

double seconds_of_other(const RunOutcome& plain, const QuestionLog& log)
{
    constexpr double seconds_of_a_call = 2.5e-6;
    std::size_t calls = 0;
    for (const QuestionKind& kind : log.kinds) calls += kind.questions.size();
    return plain.cpu_seconds + seconds_of_a_call * static_cast<double>(calls);
}

void ask_both(Worker& worker, const AskedCheck& asked, std::uint64_t seed, std::span<OtherAnswers> others,
              SpareTime& time)
{
    const RunOutcome& expected =
        worker.trusted(asked.exercise, judged_against(asked.check), asked.check.case_name, seed);
    const std::size_t at_a_time = questions_of_a_run(asked.exercise, expected);
    for (std::size_t i = 0; i < others.size(); i += at_a_time)
        ask_at_once(worker, asked, seed, others.subspan(i, std::min(at_a_time, others.size() - i)), time);
}

}
