#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "batch/grade_class.hpp"
#include "build/submission.hpp"
#include "cli/application.hpp"
#include "cli/grading.hpp"
#include "cli/secret.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Without these, a submission could read this user's files or start programs.
void refuse_weak_sandbox(const Application& application, const std::vector<Exercise>& exercises, bool allowed)
{
    Workshop workshop(application.tools);
    const auto& active = workshop.spawner(exercises.front().gl).protections();
    const auto has = [&](std::string_view name) {
        return std::any_of(active.begin(), active.end(), [&](const std::string& one) { return one.starts_with(name); });
    };
    if (allowed || (has("seccomp") && has("landlock"))) return;
    throw UsageError(
        "this machine lacks seccomp or Landlock, so that submissions could read your files (`umbral doctor` says more); grade on a Linux 5.13 or "
        "newer with both, or add --allow-weak-sandbox if you trust every submission");
}

/// The units of which some submission has a file.
std::vector<Exercise> handed_in(const std::vector<Exercise>& exercises, const fs::path& submissions)
{
    const std::vector<std::string> ids = submission_ids(submissions);
    std::vector<Exercise> result;
    std::ranges::copy_if(exercises, std::back_inserter(result), [&](const Exercise& exercise) {
        return std::ranges::any_of(ids, [&](const std::string& id) { return !collect(submissions / id, exercise).files.empty(); });
    });
    if (result.empty()) throw UsageError(fmt::format("{}: nobody handed in a file of any unit", submissions.string()));
    return result;
}

}

void grade_and_print(Application& application, const GradeCommand& command)
{
    if (!fs::is_directory(command.submissions)) throw UsageError(fmt::format("{}: expected a folder with one folder a submission", command.submissions));
    std::vector<Exercise> exercises = application.chosen(command.units);
    if (command.handed_in) exercises = handed_in(exercises, command.submissions);
    refuse_weak_sandbox(application, exercises, command.allow_weak_sandbox);
    ClassOptions options;
    options.submissions = command.submissions;
    options.out = command.out;
    options.secret = secret_from(command.secret_file);
    options.course = command.course;
    options.attempt = command.attempt;
    options.instructor_edition = command.with_hidden;
    options.jobs = command.jobs != 0 ? command.jobs : std::max(1U, std::thread::hardware_concurrency());
    fs::create_directories(options.out);

    const std::size_t total = submission_ids(options.submissions).size();
    std::size_t finished = 0;
    const bool live = application.style.color;
    const ClassResult result = grade_class(application.tools, exercises, options, [&](const SubmissionResult& submission) {
        ++finished;
        const Paint paint(application.style);
        if (live)
            fmt::print("\r\x1b[K{} {}/{}  {}", paint.bar(static_cast<Millipoints>(finished), static_cast<Millipoints>(total), 24, Tone::good), finished, total,
                       submission.id);
        else if (!command.json)
            fmt::print("graded {} ({}/{})\n", submission.id, finished, total);
        (void)std::fflush(stdout);
    });
    if (live) fmt::print("\r\x1b[K");
    if (command.json)
        fmt::print("{}\n", to_json(result).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    else
        fmt::print("\n{}\nIn a browser: {}\n              {}\nAs data:      {}\n              {} (for students: report.student.json)\n",
                   class_table(result, application.style), (options.out / "index.html").string(), (options.out / "ID" / "report.html").string(),
                   (options.out / "class.json").string(), (options.out / "ID" / "report.json").string());
    for (const SubmissionResult& submission : result.submissions)
        for (const UnitResult& unit : submission.units)
            if (unit.verdict == Verdict::grader_fault) application.exit_status = exit_fault;
}

void add_grade(CLI::App& parser, Application& application)
{
    auto options = std::make_shared<GradeCommand>();
    CLI::App* command = parser.add_subcommand("grade", "Grades a class: a folder with one folder a submission");
    command->add_option("CLASS_DIR", options->submissions, "The class")->required();
    command->add_option("--out", options->out, "Where reports go")->required();
    command->add_option("--jobs", options->jobs, "Submissions at a time; 0: one for each processor")->capture_default_str();
    command->add_option("--unit", options->units, "Only these units");
    command->add_flag("--handed-in", options->handed_in, "Only units that somebody handed in");
    command->add_option("--course", options->course, "Part of what hidden seeds follow from")->capture_default_str();
    command->add_option("--attempt", options->attempt, "Another number gives other random inputs")->capture_default_str();
    command->add_option("--secret-file", options->secret_file,
                        "The secret that hidden seeds follow from; made if missing. Default: umbral/secret in your configuration folder");
    command->add_flag("--allow-weak-sandbox", options->allow_weak_sandbox, "Grade even where the sandbox is incomplete");
    command->add_flag("--json", options->json, "Print class.json instead of a table");
    command->add_flag("--with-hidden", options->with_hidden, "Also write report.instructor.html, in which hidden checks show their values: not for students");
    command->callback([&application, options] { grade_and_print(application, *options); });
}

}
