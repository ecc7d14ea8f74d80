#include <string>
#include <utility>

#include "worker/worker.hpp"

#include <umbral/record/questions.hpp>

// Runs of students' code beside the one that is graded.
namespace umbral::grader {
namespace {

/// What is looked at of what a run tells of its questions and of the lists in their answers.
constexpr std::size_t most_sized = 16;           ///< functions
constexpr std::size_t most_sized_calls = 20000;  ///< of each
constexpr std::size_t most_sized_text = 65536;   ///< bytes of names

}

RunOutcome Worker::run_past(const Exercise& exercise, const Built& built, const std::string& case_name,
                            std::uint64_t seed, const PassedOver& passed_over, double wall_seconds)
{
    RunRequest wanted = students_request(exercise, built, case_name, seed);
    wanted.limits.wall_seconds = wall_seconds;
    wanted.passed_over = passed_over;
    return spare_time_.spent_on(run_students(exercise, wanted));
}

RunOutcome Worker::run_limited(const Exercise& exercise, const Built* built, const std::string& case_name,
                               std::uint64_t seed, const CostLimit& costs)
{
    RunRequest wanted = built != nullptr ? students_request(exercise, *built, case_name, seed)
                                         : trusted_request(exercise, Answers::reference, case_name, seed);
    wanted.costs = costs;
    return built != nullptr ? run_students(exercise, wanted) : run_now(exercise, wanted);
}

RunOutcome Worker::run_told(const Exercise& exercise, const Built& built, const std::string& case_name,
                            std::uint64_t seed)
{
    RunRequest wanted = students_request(exercise, built, case_name, seed);
    wanted.inquiry.questions = true;
    for (const auto& [name, most] : WantedTensors(wanted.wanted))
        wanted.wanted.emplace(std::string(question_names::rows) + name, most);
    wanted.wanted.emplace(question_names::sized, most_sized_text);
    wanted.wanted.emplace(question_names::functions, most_sized_text);
    for (std::size_t i = 0; i < most_sized; ++i)
        for (const std::string_view table : {question_names::sizes, question_names::features})
            wanted.wanted.emplace(std::string(table) + std::to_string(i), most_sized_calls);
    return spare_time_.spent_on(run_students(exercise, wanted));
}

RunOutcome Worker::run_moved(const Exercise& exercise, const Built& built, const std::string& case_name,
                             std::uint64_t seed, const std::vector<OtherQuestion>& others, const std::string& value)
{
    RunRequest wanted = students_request(exercise, built, case_name, seed);
    const std::size_t most = std::exchange(wanted.wanted, {})[value];
    for (std::size_t i = 0; i < others.size(); ++i) wanted.wanted.emplace(question_names::with_other(i, value), most);
    wanted.inquiry.others = others;
    // What the unit's mistakes take is nobody's time.
    return built.mistake.empty() ? spare_time_.spent_on(run_students(exercise, wanted)) : run_now(exercise, wanted);
}

RunOutcome Worker::run_coarse(const Exercise& exercise, const Built& built, const std::string& case_name,
                              std::uint64_t seed, const Grain& grain, const RunOutcome& expected,
                              const PassedOver& passed_over)
{
    RunRequest wanted = students_request(exercise, built, case_name, seed);
    wanted.passed_over = passed_over;
    for (auto& [value, cells] : wanted.wanted)
        if (const Tensor* tensor = tensor_of(expected, value)) cells = tensor->cells();
    wanted.inquiry.grain = grain;
    return spare_time_.spent_on(run_students(exercise, wanted));
}

}
