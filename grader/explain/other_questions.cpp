#include "explain/other_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>

#include "judge/explain/thresholds.hpp"
#include "question/names.hpp"
#include "worker/spare_time.hpp"

#include <umbral/record/questions.hpp>

namespace umbral::grader {
namespace {

/// How many questions a case is asked, by what one of them costs: what is tried must take no longer than people wait,
/// about a second for a case. Structs of many vectors can be misunderstood in hundreds of ways: of them `least` are
/// asked if that takes `most_seconds` at most, and `fewest` whatever it takes. Pictures cost a hundred times what
/// numbers do, and say less.
struct Patience {
    double seconds;
    double most_seconds;
    std::size_t fewest;
    std::size_t least;
    std::size_t most;
};
constexpr Patience for_numbers{.seconds = 1, .most_seconds = 3, .fewest = 8, .least = 200, .most = 1500};
constexpr Patience for_pictures{.seconds = 1, .most_seconds = 1, .fewest = 8, .least = 8, .most = 24};
constexpr std::size_t most_asked_cases = 3;

/// A case that passes is asked only if it is small and takes no longer than this for all questions: it can speak
/// against a question, but others do too.
constexpr std::size_t most_passing_cells = 10'000;
constexpr double most_passing_seconds = 1;

/// All questions of a unit together take no longer than this. A changed mesh may make the reference walk round it for
/// ever, and each such run takes all that it may: rather no reason than one that is waited for.
constexpr double most_seconds_in_all = 10;

/// What one run can hold.
constexpr std::size_t most_tensors = 240;
constexpr std::size_t most_tensor_bytes = std::size_t{32} << 20U;

struct Candidate {
    OtherQuestion question;
    Tally tally{};
    std::size_t failing = 0;  ///< checks in which its function was asked
    bool fits = false;        ///< a failing check of the case looked at speaks for it
};

/// May a question to this function change what the check holds? Not if all its rows are known to be answers of others.
bool may_concern(const QuestionLog& log, const FailingCheck& one, std::string_view function)
{
    const auto rows = log.rows.find(one.check->value);
    if (rows == log.rows.end() || function.empty()) return true;
    return std::ranges::any_of(rows->second, [&](std::uint32_t question) {
        const QuestionKind* const kind = question == 0 ? nullptr : log.kind_of(question - 1);
        return kind == nullptr || kind->function == function;
    });
}

/// Takes what the checks of one case say of the reference's answers to the other question. Where one mistake was made
/// in two functions, each has a reason of its own.
void weigh(const CaseChecks& group, const QuestionLog& log, const RunOutcome& run, Candidate& candidate)
{
    candidate.fits = false;
    for (const FailingCheck& one : group.checks) {
        if (!may_concern(log, one, candidate.question.function)) continue;
        const Resemblance said = says_of(one, *group.result, run);
        candidate.tally += said;
        candidate.failing += one.fails ? 1 : 0;
        candidate.fits = candidate.fits || said.says == Says::for_it;
    }
}

/// How many other questions one run of this case can be asked: what it can hold, and within a fifth of its time, which
/// a busy machine stretches.
std::size_t room(const RunOutcome& plain, const Limits& limits)
{
    std::size_t bytes = 1;
    for (const auto& [name, tensor] : plain.recording.tensors) bytes += tensor.bytes.size() + tensor.present.size();
    const std::size_t tensors = std::max<std::size_t>(1, plain.recording.tensors.size());
    const auto in_time = static_cast<std::size_t>(0.2 * limits.wall_seconds / std::max(plain.cpu_seconds, 1e-3));
    return std::clamp<std::size_t>(std::min({most_tensors / tensors, most_tensor_bytes / bytes, in_time}), 1, 64);
}

/// Asks one case each of the questions, as many as a run can hold at a time. Where a run does not end well, its
/// questions are asked in halves, until the one that does not bear asking is alone: some never end, such as a vector
/// without length.
void weigh_all(Worker& worker, const Exercise& exercise, const CaseChecks& group, std::span<Candidate> candidates,
               SpareTime& time)
{
    if (candidates.empty() || !time.is_left()) return;
    const RunOutcome& plain = worker.trusted(exercise, Answers::reference, group.name, group.result->seed);
    // What one draw leaves in OpenGL's state must not reach the next.
    const std::size_t most = exercise.gl && leaves_picture(plain) ? 1 : room(plain, exercise.limits);
    if (candidates.size() > most) {
        weigh_all(worker, exercise, group, candidates.first(most), time);
        weigh_all(worker, exercise, group, candidates.subspan(most), time);
        return;
    }
    Inquiry inquiry;
    for (const Candidate& candidate : candidates) inquiry.others.push_back(candidate.question);
    const Limits limits = limits_for(exercise.limits, plain.cpu_seconds * static_cast<double>(1 + candidates.size()));
    const RunOutcome run =
        time.spent_on(worker.inquire(exercise, Answers::reference, group.name, group.result->seed, inquiry, limits));
    if (run.verdict != Verdict::ok && candidates.size() > 1) {
        weigh_all(worker, exercise, group, candidates.first(candidates.size() / 2), time);
        weigh_all(worker, exercise, group, candidates.subspan(candidates.size() / 2), time);
        return;
    }
    std::vector<RunOutcome> runs(candidates.size());
    for (RunOutcome& one : runs) one.verdict = run.verdict;
    for (const auto& [name, tensor] : run.recording.tensors) {
        const std::size_t mark = name.find(question_names::of_other);
        if (mark == std::string::npos || mark == 0) continue;
        runs.at(std::stoul(name.substr(0, mark))).recording.tensors[name.substr(mark + 1)] = tensor;
    }
    const QuestionLog& log = worker.questions(exercise, group.name, group.result->seed);
    for (std::size_t i = 0; i < candidates.size(); ++i) weigh(group, log, runs[i], candidates[i]);
}

std::size_t questions_in_time(const RunOutcome& plain)
{
    const Patience& patience = leaves_picture(plain) ? for_pictures : for_numbers;
    const double cost = std::max(plain.cpu_seconds, 1e-4);
    const double least = std::clamp(patience.most_seconds / cost, double(patience.fewest), double(patience.least));
    return static_cast<std::size_t>(std::clamp(patience.seconds / cost, least, double(patience.most)));
}

/// Those that a failing check of this case speaks for.
std::vector<Candidate> fitting(Worker& worker, const Exercise& exercise, const CaseChecks& group, SpareTime& time)
{
    const RunOutcome& plain = worker.trusted(exercise, Answers::reference, group.name, group.result->seed);
    const std::size_t most = questions_in_time(plain);
    std::vector<Candidate> found;
    for (const OtherQuestion& other : worker.questions(exercise, group.name, group.result->seed).others)
        if (found.size() < most && std::ranges::find(found, other, &Candidate::question) == found.end())
            found.push_back({other});
    weigh_all(worker, exercise, group, found, time);
    std::erase_if(found, std::not_fn(&Candidate::fits));
    return found;
}

/// Would asking so many questions of a case that passes take longer than it may?
bool is_too_long(Worker& worker, const Exercise& exercise, const CaseChecks& group, std::size_t questions)
{
    if (group.cells > most_passing_cells) return true;
    const RunOutcome& plain = worker.trusted(exercise, Answers::reference, group.name, group.result->seed);
    return plain.cpu_seconds * static_cast<double>(questions) > most_passing_seconds;
}

/// Of questions that fit alike, the one that is most easily mistaken for what was asked: an argument that is not looked
/// at at all explains any other change of it.
int far_fetched(const OtherQuestion& question)
{
    if (question.change.starts_with("taken as") || question.change.starts_with("without its translation")) return 0;
    if (question.change.empty() || question.change.starts_with("normalised")) return 1;
    return 2;
}

bool same(const Tally& a, const Tally& b)
{
    return a.for_it == b.for_it && a.against_it == b.against_it && a.bits == b.bits;
}

/// Of questions of which all cases so far say the same, the first: where an argument is not looked at at all, any
/// change of it fits. What tells them apart is not worth the time.
void keep_first_of_equals(std::vector<Candidate>& candidates)
{
    std::vector<Candidate> kept;
    for (Candidate& one : candidates)
        if (std::ranges::none_of(kept, [&](const Candidate& other) { return same(other.tally, one.tally); }))
            kept.push_back(std::move(one));
    candidates = std::move(kept);
}

/// Those of one function, or of all, whose reason explains most.
void keep_best_function(std::vector<Candidate>& candidates)
{
    const auto best = std::ranges::max_element(
        candidates, {}, [](const Candidate& one) { return confidence(one.tally) * static_cast<double>(one.failing); });
    const std::string function = best->question.function;
    std::erase_if(candidates, [&](const Candidate& one) { return one.question.function != function; });
}

/// "Your results are the right ones if …"
std::string sentence(const OtherQuestion& question, const std::string& words)
{
    if (question.function.empty())
        return fmt::format(
            "Your results are the right ones for other questions: with {} in all of them. Look at how "
            "your code uses what it is given.",
            words);
    const std::string function = question.function.substr(question.function.rfind(':') + 1);
    return fmt::format(
        "Your results are the right ones for another question: {} with {}. Look at how your code uses "
        "what it is given.",
        function, words);
}

}

std::string interface_text(const Worker& worker, const Exercise& exercise)
{
    const std::filesystem::path& framework = worker.tools().framework;
    std::vector<std::filesystem::path> files;
    for (const auto* headers : {&exercise.interfaces, &exercise.used_interfaces})
        for (const std::string& header : *headers) files.push_back(framework / header);
    std::error_code none;
    std::set<std::filesystem::path> others;
    for (const auto& entry : std::filesystem::directory_iterator(framework / "umbral" / exercise.topic, none))
        if (entry.path().extension() == ".hpp" && std::ranges::find(files, entry.path()) == files.end())
            others.insert(entry.path());
    files.insert(files.end(), others.begin(), others.end());
    std::ostringstream text;
    for (const std::filesystem::path& file : files) text << std::ifstream(file).rdbuf() << '\n';
    return text.str();
}

std::string in_words(const OtherQuestion& question, const std::string& headers)
{
    if (question.function.empty()) {
        const std::string field = question.place.substr(question.place.rfind(':') + 1);
        return fmt::format("{} {}", field, question.change);
    }
    const std::vector<std::string> parameters = parameter_names(headers, question.function);
    const std::string place = in_words(question.place, parameters);
    if (!question.other.empty()) return fmt::format("{} and {} exchanged", place, in_words(question.other, parameters));
    return fmt::format("{} {}", place, question.change);
}

std::vector<Explanation> by_other_questions(Worker& worker, const Exercise& exercise,
                                            std::span<const CaseChecks> groups)
{
    // Pictures cost a hundred times what numbers do, and say less: they are asked where nothing else fails.
    const auto has_numbers = [&](const CaseChecks& group) {
        return !leaves_picture(worker.trusted(exercise, Answers::reference, group.name, group.result->seed));
    };
    std::vector<CaseChecks> asked;
    std::ranges::copy_if(groups, std::back_inserter(asked), has_numbers);
    if (std::ranges::none_of(asked, [](const CaseChecks& group) { return group.failing > 0; }))
        asked.assign(groups.begin(), groups.end());
    SpareTime time;
    time.allow(most_seconds_in_all);
    std::vector<Candidate> candidates;
    std::size_t tried = 0;
    for (const CaseChecks& group : asked) {
        if (group.failing == 0 || !group.result->trouble().empty() || tried++ == most_asked_cases) continue;
        for (Candidate& candidate : fitting(worker, exercise, group, time))
            if (std::ranges::find(candidates, candidate.question, &Candidate::question) == candidates.end())
                candidates.push_back({std::move(candidate.question)});
    }
    std::ranges::stable_sort(candidates, {}, [](const Candidate& one) { return far_fetched(one.question); });
    std::size_t failing = 0;
    for (const CaseChecks& group : asked) failing += group.failing;
    std::size_t undecided = failing;
    std::size_t weighed = 0;
    for (const CaseChecks& group : asked) {
        undecided -= group.failing;
        if (group.failing == 0 && is_too_long(worker, exercise, group, candidates.size())) continue;
        if (weighed++ == most_asked_cases) keep_first_of_equals(candidates);
        weigh_all(worker, exercise, group, candidates, time);
        std::erase_if(candidates, [&](const Candidate& one) {
            return most_confidence(one.tally, undecided) < thresholds::least_sure;
        });
    }
    keep_first_of_equals(candidates);
    std::vector<Explanation> found;
    // What not all cases were asked about might be spoken against by the others.
    if (candidates.empty() || !time.is_left()) return found;
    keep_best_function(candidates);
    const std::string headers = interface_text(worker, exercise);
    for (const Candidate& candidate : candidates) {
        const std::string words = in_words(candidate.question, headers);
        const double share = static_cast<double>(candidate.failing) / static_cast<double>(failing);
        found.push_back({"question: " + words, sentence(candidate.question, words), confidence(candidate.tally),
                         fit(candidate.tally) * std::min(share, 1.0)});
    }
    return found;
}

}
