#include "worker/worker.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <umbral/record/cost.hpp>

#include "build/build_cache.hpp"
#include "judge/judges.hpp"
#include "model/caps.hpp"
#include "model/digest.hpp"
#include "run/inquiry_json.hpp"
#include "worker/ask_question.hpp"
#include "worker/case_results.hpp"
#include "worker/kept_outcomes.hpp"
#include "worker/known_solutions.hpp"
#include "worker/packaged_unit.hpp"
#include "worker/run_roots.hpp"
#include "worker/seeds.hpp"
#include "worker/unit_key.hpp"

namespace umbral::grader {
namespace {

/// Of runs, questions and their code SharedRuns has its own bounds.
constexpr std::size_t most_bases = 50'000;

std::string key_of(const Exercise& exercise, const std::string& who, const std::string& case_name, std::uint64_t seed)
{
    return fmt::format("{}\n{}\n{}\n{}", exercise.id, who, case_name, seed);
}

std::string library_of_mistake(const std::string& name) { return "mistakes/" + name; }

const char* to_string(Answers solution) { return solution == Answers::reference ? "reference" : "oracle"; }

/// How many cells of a value are read where `expected` were: so many more that any honest mistake can be shown.
std::size_t most_cells(const Check& check, std::size_t expected)
{
    return caps::rows_factor * expected + judge_of(check).more_cells;
}

}

Worker::Worker(Toolchain tools, std::string gl_backend)
    : tools_(std::move(tools)), gl_backend_(std::move(gl_backend)), roots_(run_roots(tools_))
{
}

Spawner& Worker::spawner(bool gl)
{
    std::unique_ptr<Spawner>& wanted = gl ? gl_ : plain_;
    const char* const program = gl ? "umbral-spawner-gl" : "umbral-spawner";
    if (!wanted) wanted = std::make_unique<Spawner>(tools_.programs / program, gl_backend_);
    return *wanted;
}

RunOutcome Worker::run_now(const Exercise& exercise, const RunRequest& request)
{
    RunOutcome outcome = spawner(exercise.gl).run(request);
    run_seconds_ += SpareTime::cost_of(outcome);
    return outcome;
}

RunRequest Worker::request(const Exercise& exercise, const std::string& case_name, std::uint64_t seed) const
{
    RunRequest wanted;
    wanted.driver = unit_folder(tools_, exercise.id) / "driver.so";
    wanted.case_name = case_name;
    wanted.stream = stream_of(exercise, case_name, seed);
    wanted.limits = exercise.limits;
    wanted.roots = roots_;
    wanted.roots.push_back(wanted.driver.parent_path().string());
    return wanted;
}

WantedTensors Worker::wanted(const Exercise& exercise, const std::string& case_name, std::uint64_t seed)
{
    WantedTensors wanted;
    for (const Check& check : exercise.checks) {
        if (check.case_name != case_name) continue;
        const RunOutcome& expected = trusted(exercise, judged_against(check), case_name, seed);
        for (const std::string& value : values_of(check)) {
            const Tensor* tensor = tensor_of(expected, value);
            std::size_t& most = wanted[value];
            most = std::max(most, most_cells(check, tensor == nullptr ? 0 : tensor->cells()));
            wanted[value + std::string(refusals::suffix)] = refusals::most_bytes;
            wanted[std::string(rows_without_answer) + value] = most;
            if (judge_of(check).counts_work) wanted[value + std::string(cost_answers_suffix)] = most;
        }
    }
    return wanted;
}

RunRequest Worker::students_request(const Exercise& exercise, const Built& built, const std::string& case_name,
                                    std::uint64_t seed)
{
    RunRequest wanted = request(exercise, case_name, seed);
    wanted.solution = built.mistake.empty() || !exercise.is_cpp()
                          ? built.library
                          : library_of(exercise, library_of_mistake(built.mistake));
    wanted.mutant = built.mutant;
    wanted.fresh_memory = built.fresh_memory;
    wanted.wanted = this->wanted(exercise, case_name, seed);
    if (!built.library.empty()) wanted.roots.push_back(built.library.parent_path().string());
    // Only what the unit asks for: other files are nothing to the driver.
    for (const auto& [name, text] : built.sources)
        if (std::ranges::find(exercise.files, name) != exercise.files.end()) wanted.sources.emplace(name, text);
    return wanted;
}

std::filesystem::path Worker::library_of(const Exercise& exercise, const std::string& name)
{
    if (!unveiled_ && is_veiled(tools_, exercise, name)) unveiled_ = std::make_unique<ScratchFolder>(tools_.cache);
    return answer_library(tools_, exercise, name, unveiled_ ? unveiled_->path() : std::filesystem::path());
}

RunRequest Worker::trusted_request(const Exercise& exercise, Answers solution, const std::string& case_name,
                                   std::uint64_t seed)
{
    RunRequest wanted = request(exercise, case_name, seed);
    if (exercise.is_cpp()) wanted.solution = library_of(exercise, to_string(solution));
    wanted.sources = texts_of(reference_shaders(tools_, exercise));
    return wanted;
}

RunOutcome Worker::run(const Exercise& exercise, const Built& built, const std::string& case_name, std::uint64_t seed)
{
    if (!built.mistake.empty())
        return run_known(exercise, library_of_mistake(built.mistake), built.sources, case_name, seed);
    return run_students(exercise, students_request(exercise, built, case_name, seed));
}

RunOutcome Worker::trusted_past(const Exercise& exercise, Answers solution, const std::string& case_name,
                                std::uint64_t seed, const PassedOver& passed_over, const Grain& grain)
{
    RunRequest wanted = trusted_request(exercise, solution, case_name, seed);
    wanted.passed_over = passed_over;
    wanted.inquiry.grain = grain;
    return run_now(exercise, wanted);
}

const RunOutcome& Worker::trusted(const Exercise& exercise, Answers solution, const std::string& case_name,
                                  std::uint64_t seed)
{
    const char* name = to_string(solution);
    return known(exercise, name, case_name, seed, [&] {
        RunOutcome outcome = run_now(exercise, trusted_request(exercise, solution, case_name, seed));
        if (outcome.verdict != Verdict::ok)
            throw std::runtime_error(fmt::format("{}: the {} did not finish case '{}' ({}): {}", exercise.id, name,
                                                 case_name, to_string(outcome.verdict), outcome.message));
        return outcome;
    });
}

RunOutcome Worker::inquire(const Exercise& exercise, Answers solution, const std::string& case_name, std::uint64_t seed,
                           const Inquiry& inquiry, const std::optional<Limits>& limits)
{
    RunRequest wanted = trusted_request(exercise, solution, case_name, seed);
    wanted.inquiry = inquiry;
    if (limits) wanted.limits = *limits;
    return run_now(exercise, wanted);
}

MadeOnce<RunOutcome>::Pointer Worker::answers_to_others(const Exercise& exercise, Answers solution,
                                                        const std::string& case_name, std::uint64_t seed,
                                                        std::vector<OtherQuestion> others,
                                                        const std::optional<Limits>& limits)
{
    const Inquiry inquiry{.others = std::move(others)};
    const std::string who = fmt::format("{} asked {}", to_string(solution), to_json(inquiry).dump());
    const auto ask = [&] { return inquire(exercise, solution, case_name, seed, inquiry, limits); };
    const std::string key = sha256_hex(key_of(exercise, who, case_name, seed));
    auto answers = runs_->answers_to_others.get(key, ask);
    // The machine may have been the reason.
    if (answers->verdict != Verdict::ok) runs_->answers_to_others.forget(key);
    return answers;
}

const QuestionLog& Worker::questions(const Exercise& exercise, const std::string& case_name, std::uint64_t seed)
{
    const std::string key = key_of(exercise, "questions", case_name, seed);
    if (const auto found = used_questions_.find(key); found != used_questions_.end()) return *found->second;
    bool ended_well = true;
    const auto ask = [&] {
        const RunOutcome told = inquire(exercise, Answers::reference, case_name, seed, {.questions = true});
        ended_well = told.verdict == Verdict::ok;
        return ended_well ? read_questions(told.recording.tensors) : QuestionLog{};
    };
    const auto place = used_questions_.emplace(key, runs_->questions.get(key, ask)).first;
    if (!ended_well) runs_->questions.forget(key);
    return *place->second;
}

std::map<std::uint32_t, std::string> Worker::code_of(const Exercise& exercise, const std::string& case_name,
                                                     std::uint64_t seed, std::vector<std::uint32_t> questions)
{
    const std::string who = fmt::format("code of {}", fmt::join(questions, " "));
    const auto ask = [&] {
        const RunOutcome told =
            inquire(exercise, Answers::reference, case_name, seed, {.wanted = std::move(questions)});
        return told.verdict == Verdict::ok ? read_questions(told.recording.tensors).code : SharedRuns::Texts();
    };
    const std::string key = key_of(exercise, who, case_name, seed);
    const auto codes = runs_->codes.get(key, ask);
    if (codes->empty()) runs_->codes.forget(key);
    return *codes;
}

RunOutcome Worker::answer_of(const Exercise& exercise, const std::filesystem::path& library,
                             const std::filesystem::path& driver)
{
    RunRequest wanted = request(exercise, asked_case, 0);
    wanted.driver = driver;
    wanted.solution = library;
    // What the unit's own driver brings along of the units that it uses.
    if (!exercise.uses.empty()) wanted.used = unit_folder(tools_, exercise.id) / "driver.so";
    wanted.roots.push_back(driver.parent_path().string());
    wanted.roots.push_back(library.parent_path().string());
    return run_now(exercise, wanted);
}

RunOutcome Worker::answer(const Exercise& exercise, Answers solution, const std::filesystem::path& driver)
{
    return answer_of(exercise, library_of(exercise, to_string(solution)), driver);
}

const RunOutcome& Worker::run_known(const Exercise& exercise, const std::string& library, const Sources& sources,
                                    const std::string& case_name, std::uint64_t seed)
{
    return known(exercise, library, case_name, seed, [&] {
        RunRequest wanted = request(exercise, case_name, seed);
        if (exercise.is_cpp()) wanted.solution = library_of(exercise, library);
        wanted.sources = texts_of(sources);
        wanted.wanted = this->wanted(exercise, case_name, seed);
        return run_now(exercise, wanted);
    });
}

const RunOutcome& Worker::run_known(const Exercise& exercise, const KnownSolution& mistake,
                                    const std::string& case_name, std::uint64_t seed)
{
    return run_known(exercise, library_of_mistake(mistake.name), mistake.sources, case_name, seed);
}

const CheckBasis& Worker::basis(const Exercise& exercise, const Check& check, std::uint64_t seed)
{
    const std::string key = key_of(exercise, "basis of " + check.name, check.case_name, seed);
    if (const auto found = bases_.find(key); found != bases_.end()) return found->second;
    const RunOutcome& expected = trusted(exercise, judged_against(check), check.case_name, seed);
    const RunOutcome& reference = trusted(exercise, Answers::reference, check.case_name, seed);
    return bases_.emplace(key, basis_of(check, expected, reference, seed)).first->second;
}

std::filesystem::path Worker::kept_file(const Exercise& exercise, const std::string& who, const std::string& case_name,
                                        std::uint64_t seed) const
{
    if (!keys_ || is_hidden_case(exercise, case_name)) return {};
    return entry_of(runs_folder(tools_.cache), keys_->of_unit(exercise)) /
           sha256_hex(key_of(exercise, who, case_name, seed));
}

const RunOutcome& Worker::known(const Exercise& exercise, const std::string& who, const std::string& case_name,
                                std::uint64_t seed, const std::function<RunOutcome()>& run)
{
    const std::string key = key_of(exercise, who, case_name, seed);
    if (const auto found = used_.find(key); found != used_.end()) return *found->second;
    const auto kept_or_run = [&] {
        const std::filesystem::path file = kept_file(exercise, who, case_name, seed);
        if (file.empty()) return run();
        if (std::optional<RunOutcome> kept = kept_outcome(file)) return *std::move(kept);
        RunOutcome outcome = run();
        if (outcome.verdict == Verdict::ok && outcome.recording.oversized.empty()) try_to_keep(file, outcome);
        return outcome;
    };
    return *used_.emplace(key, runs_->runs.get(key, kept_or_run)).first->second;
}

Worker* Worker::second()
{
    if (!may_have_second_) return nullptr;
    if (!second_) second_ = std::make_unique<Worker>(tools_, gl_backend_);
    second_->keep_runs(keys_);
    second_->share_runs(runs_);
    return second_.get();
}

void Worker::let_go()
{
    if (second_) second_->let_go();
    used_.clear();
    used_questions_.clear();
    if (bases_.size() > most_bases) bases_.clear();
}

}
