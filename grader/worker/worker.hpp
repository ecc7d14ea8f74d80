#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <umbral/record/block_trace.hpp>
#include <vector>

#include "build/builder.hpp"
#include "build/toolchain.hpp"
#include "model/scratch.hpp"
#include "model/time_budget.hpp"
#include "question/log.hpp"
#include "run/spawner.hpp"
#include "worker/check_basis.hpp"
#include "worker/seeds.hpp"
#include "worker/shared_runs.hpp"
#include "worker/spare_time.hpp"

namespace umbral::grader {

class UnitKeys;
struct KnownSolution;

/// Whose answers a run gives.
enum class Answers { reference, oracle };

/// The solution that a check is judged against.
[[nodiscard]] inline Answers judged_against(const Check& check)
{
    return check.hard ? Answers::oracle : Answers::reference;
}

/// Grades: has the tools, its own spawners (started when first needed), and the trusted runs it has
/// seen. Not for use by several threads at once.
class Worker {
public:
    /// `gl_backend` draws ("osmesa" or "egl"); if it is empty, what UMBRAL_GL holds.
    explicit Worker(Toolchain tools, std::string gl_backend = {});

    [[nodiscard]] const Toolchain& tools() const noexcept { return tools_; }

    /// The spawner for a unit: with a warm OpenGL context if it draws.
    [[nodiscard]] Spawner& spawner(bool gl);

    /// From now on trusted runs of visible cases are kept in the user's cache too, under the unit's key, and not run
    /// again as long as that holds. Null: they are not.
    void keep_runs(std::shared_ptr<const UnitKeys> keys) noexcept { keys_ = std::move(keys); }

    /// From now on trusted runs are remembered together with other workers.
    void share_runs(std::shared_ptr<SharedRuns> runs) noexcept { runs_ = std::move(runs); }

    /// Whether a second one may be had.
    void allow_second(bool allowed) noexcept { may_have_second_ = allowed; }
    /// Another worker that remembers trusted runs together with this one, for a thread of its own; null where there may
    /// be none.
    [[nodiscard]] Worker* second();

    /// Lets go of the runs that were used, which are forgotten if too many are remembered; references to them end.
    /// Called between units.
    void let_go();

    /// From now on students' code runs for another unit, of whose time all its runs take.
    void bound_runs(UnitBudget budget) { budget_ = std::move(budget); }
    [[nodiscard]] const UnitBudget& budget() const noexcept { return budget_; }

    /// What is left for running students' code again: all runs but `run` take from it.
    [[nodiscard]] SpareTime& spare_time() noexcept { return spare_time_; }
    /// Allows so many seconds, if the unit has them.
    void allow_spare_time(double seconds) { spare_time_.allow(std::min(seconds, budget_.left())); }
    /// What all runs until now took, trusted ones too (SpareTime::cost_of).
    [[nodiscard]] double run_seconds() const noexcept { return run_seconds_; }

    /// Runs one case with a student's (or a solution's) build, after the trusted runs that it is judged against: of its
    /// recording only what the case's checks look at is read, and not if it is far larger than expected. Throws
    /// std::runtime_error for faults of the grader's and for what the machine lacks.
    [[nodiscard]] RunOutcome run(const Exercise& exercise, const Built& built, const std::string& case_name,
                                 std::uint64_t seed);

    /// The same, once more.
    [[nodiscard]] RunOutcome run_again(const Exercise& exercise, const Built& built, const std::string& case_name,
                                       std::uint64_t seed)
    {
        return spare_time_.spent_on(run(exercise, built, case_name, seed));
    }

    /// The same without some questions, in so many seconds; of the recording is read, too, which rows lack an answer
    /// for that.
    [[nodiscard]] RunOutcome run_past(const Exercise& exercise, const Built& built, const std::string& case_name,
                                      std::uint64_t seed, const PassedOver& passed_over, double wall_seconds);

    /// A trusted solution's run without some questions; nothing is kept of it.
    [[nodiscard]] RunOutcome trusted_past(const Exercise& exercise, Answers solution, const std::string& case_name,
                                          std::uint64_t seed, const PassedOver& passed_over, const Grain& grain = {});

    /// The same, while the case runs in turns with it in the same process, with the inputs of `beside` and with nearly
    /// its own: before each of its questions two others are asked.
    [[nodiscard]] RunOutcome run_beside(const Exercise& exercise, const Built& built, const std::string& case_name,
                                        std::uint64_t seed, std::uint64_t beside)
    {
        RunRequest wanted = students_request(exercise, built, case_name, seed);
        wanted.beside = stream_of(exercise, case_name, beside);
        return spare_time_.spent_on(run_students(exercise, wanted));
    }

    /// Runs one case with a student's build, or with the reference if there is none, working on these counted costs
    /// only. Nothing is kept.
    [[nodiscard]] RunOutcome run_limited(const Exercise& exercise, const Built* built, const std::string& case_name,
                                         std::uint64_t seed, const CostLimit& costs);

    /// The recording of a trusted solution; kept for the next submission with the same seed. Throws std::runtime_error
    /// if that run fails: a grader fault.
    [[nodiscard]] const RunOutcome& trusted(const Exercise& exercise, Answers solution, const std::string& case_name,
                                            std::uint64_t seed);

    /// Runs one case with a trusted solution, which also tells what `inquiry` wants to know of its questions, or
    /// answers others in their place: then it may end as any run may, or not at all, and may have limits of its own.
    /// Nothing is kept.
    [[nodiscard]] RunOutcome inquire(const Exercise& exercise, Answers solution, const std::string& case_name,
                                     std::uint64_t seed, const Inquiry& inquiry,
                                     const std::optional<Limits>& limits = std::nullopt);

    /// What a trusted solution answers to others in place of a case's questions, as inquire() says, but remembered if
    /// it ended well: the same mistake is looked for in the work of many.
    [[nodiscard]] MadeOnce<RunOutcome>::Pointer answers_to_others(const Exercise& exercise, Answers solution,
                                                                  const std::string& case_name, std::uint64_t seed,
                                                                  std::vector<OtherQuestion> others,
                                                                  const std::optional<Limits>& limits = std::nullopt);

    /// The reference's questions in one case, without their code; remembered as other trusted runs are, but on no disk.
    [[nodiscard]] const QuestionLog& questions(const Exercise& exercise, const std::string& case_name,
                                               std::uint64_t seed);

    /// Some of these questions as code that can be pasted into a program; those that the run did not come to are not
    /// there. Remembered as the questions are.
    [[nodiscard]] std::map<std::uint32_t, std::string> code_of(const Exercise& exercise, const std::string& case_name,
                                                               std::uint64_t seed,
                                                               std::vector<std::uint32_t> questions);

    /// Runs one case with a student's build, and has it say as well which of its rows each question led to.
    [[nodiscard]] RunOutcome run_told(const Exercise& exercise, const Built& built, const std::string& case_name,
                                      std::uint64_t seed);

    /// What a student's build answers to others in place of a case's questions; read is only this value. They must hold
    /// nothing that its own run does not: its process sees them.
    [[nodiscard]] RunOutcome run_moved(const Exercise& exercise, const Built& built, const std::string& case_name,
                                       std::uint64_t seed, const std::vector<OtherQuestion>& others,
                                       const std::string& value);

    /// Runs one case with what build_traced (build/traced.hpp) made of a student's files, and has it say as well
    /// through which blocks of its code each question went.
    [[nodiscard]] RunOutcome run_traced(const Exercise& exercise, const Built& traced, const std::string& case_name,
                                        std::uint64_t seed)
    {
        RunRequest wanted = students_request(exercise, traced, case_name, seed);
        wanted.inquiry.blocks = true;
        wanted.wanted.emplace(std::string(blocks_of_questions), BlockTrace::most_rows);
        wanted.wanted.emplace(std::string(blocks_of_loop), BlockTrace::blocks_in_loop);
        return spare_time_.spent_on(run_students(exercise, wanted));
    }

    /// Runs one case with a student's build on inputs of this grain, of which is read what `expected` holds too.
    /// Nothing is kept.
    [[nodiscard]] RunOutcome run_coarse(const Exercise& exercise, const Built& built, const std::string& case_name,
                                        std::uint64_t seed, const Grain& grain, const RunOutcome& expected,
                                        const PassedOver& passed_over = {});

    /// Runs the only case, "question", of a driver of its own (ask_question.hpp) with a student's build, or with a
    /// trusted solution. Nothing is kept.
    [[nodiscard]] RunOutcome answer(const Exercise& exercise, const Built& built, const std::filesystem::path& driver)
    {
        return answer_of(exercise, built.library, driver);
    }
    [[nodiscard]] RunOutcome answer(const Exercise& exercise, Answers solution, const std::filesystem::path& driver);

    /// What the trusted recordings decide of a check: worked out once.
    [[nodiscard]] const CheckBasis& basis(const Exercise& exercise, const Check& check, std::uint64_t seed);

    /// The recording of a solution that was compiled when the project was built, by its library's name
    /// ("mistakes/in_float"), or of shaders, which `sources` holds; kept as well.
    [[nodiscard]] const RunOutcome& run_known(const Exercise& exercise, const std::string& library,
                                              const Sources& sources, const std::string& case_name, std::uint64_t seed);
    /// The same of one of the unit's mistakes.
    [[nodiscard]] const RunOutcome& run_known(const Exercise& exercise, const KnownSolution& mistake,
                                              const std::string& case_name, std::uint64_t seed);

private:
    [[nodiscard]] RunOutcome run_now(const Exercise& exercise, const RunRequest& request);
    [[nodiscard]] RunOutcome run_students(const Exercise& exercise, const RunRequest& request)
    {
        RunOutcome outcome = run_now(exercise, request);
        budget_.take(SpareTime::cost_of(outcome));
        return outcome;
    }
    [[nodiscard]] RunRequest request(const Exercise& exercise, const std::string& case_name, std::uint64_t seed) const;
    [[nodiscard]] RunRequest students_request(const Exercise& exercise, const Built& built,
                                              const std::string& case_name, std::uint64_t seed);
    [[nodiscard]] RunRequest trusted_request(const Exercise& exercise, Answers solution, const std::string& case_name,
                                             std::uint64_t seed);
    [[nodiscard]] std::filesystem::path library_of(const Exercise& exercise, const std::string& name);
    [[nodiscard]] WantedTensors wanted(const Exercise& exercise, const std::string& case_name, std::uint64_t seed);
    [[nodiscard]] std::filesystem::path kept_file(const Exercise& exercise, const std::string& who,
                                                  const std::string& case_name, std::uint64_t seed) const;
    /// The outcome of a run of known code, from memory, from the disk, or from running it now.
    [[nodiscard]] const RunOutcome& known(const Exercise& exercise, const std::string& who,
                                          const std::string& case_name, std::uint64_t seed,
                                          const std::function<RunOutcome()>& run);
    [[nodiscard]] RunOutcome answer_of(const Exercise& exercise, const std::filesystem::path& library,
                                       const std::filesystem::path& driver);

    Toolchain tools_;
    std::string gl_backend_;
    std::vector<std::string> roots_;  ///< folders of this machine that no text of a run may show
    std::unique_ptr<ScratchFolder>
        unveiled_;  ///< libraries of answers, where the installation has them veiled; made when first needed
    std::unique_ptr<Spawner> plain_;
    std::unique_ptr<Spawner> gl_;
    std::shared_ptr<const UnitKeys> keys_;
    UnitBudget budget_;
    SpareTime spare_time_;
    double run_seconds_ = 0;
    std::shared_ptr<SharedRuns> runs_ = std::make_shared<SharedRuns>();
    std::map<std::string, MadeOnce<RunOutcome>::Pointer> used_;
    std::map<std::string, MadeOnce<QuestionLog>::Pointer> used_questions_;
    std::map<std::string, CheckBasis> bases_;
    bool may_have_second_ = false;
    std::unique_ptr<Worker> second_;
};

}
