#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "class/grade_class.hpp"
#include "class/handed_in.hpp"
#include "cli/application.hpp"
#include "cli/checkout.hpp"
#include "cli/commands.hpp"
#include "cli/grading.hpp"
#include "cli/paths.hpp"
#include "cli/secret.hpp"
#include "model/caps.hpp"
#include "model/faults.hpp"
#include "report/layout.hpp"
#include "report/paint.hpp"
#include "store/distinct_folders.hpp"
#include "store/refused_folder.hpp"
#include "worker/crew.hpp"
#include "worker/fingerprint.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

/// Without these, a submission could read this user's files or start programs.
void refuse_weak_sandbox(const Fingerprint& machine, bool allowed)
{
    const auto has = [&](std::string_view name) {
        return std::any_of(machine.protections.begin(), machine.protections.end(),
                           [&](const std::string& one) { return one.starts_with(name); });
    };
    if (allowed || (has("seccomp") && has("landlock"))) return;
    throw UsageError(
        "this machine lacks seccomp or Landlock, so that submissions could read your files (`umbral doctor` says "
        "more); grade on a Linux 5.13 or "
        "newer with both, or add --allow-weak-sandbox if you trust every submission");
}

constexpr std::size_t most_roster_bytes = std::size_t{16} << 20U;

/// The folders of the class. What is wrong with them, or with the roster, is a UsageError.
std::vector<SubmissionFolder> folders_of(const GradeCommand& command)
{
    try {
        return class_folder(command.submissions, command.roster).submissions;
    } catch (const std::exception& error) {
        throw UsageError(error.what());
    }
}

/// Without a unit that enough submissions have files of there is nothing to grade for all.
void refuse_no_task(const GradeCommand& command, const HandedIn& handed)
{
    if (!handed.task.empty()) return;
    if (handed.too_few.empty())
        throw UsageError(fmt::format("{}: nobody handed in a file of any unit", command.submissions));
    std::vector<std::string> units;
    for (const LeftOut& one : handed.too_few)
        units.push_back(fmt::format("{} ({})", one.unit, listed(one.submissions)));
    throw UsageError(
        fmt::format("{}: no unit is handed in by enough submissions to be the class's task: {}. Name the "
                    "units of the task by --unit",
                    command.submissions, listed(units)));
}

/// The units that anybody began.
std::vector<Exercise> begun(const std::vector<Exercise>& exercises, const HandedIn& handed)
{
    std::vector<Exercise> units = handed.task;
    std::ranges::copy_if(exercises, std::back_inserter(units), [&](const Exercise& exercise) {
        return std::ranges::find(handed.too_few, exercise.id, &LeftOut::unit) != handed.too_few.end();
    });
    return units;
}

/// Tells how far a class is: one line that is written over and over on a terminal, otherwise a line for each
/// submission.
class Teller {
public:
    Teller(const TerminalStyle& style, bool silent) : style_(style), live_(style.color && !silent), silent_(silent) {}
    ~Teller()
    {
        if (live_) fmt::print("\r\x1b[K");
    }
    Teller(const Teller&) = delete;
    Teller& operator=(const Teller&) = delete;

    void operator()(const ClassProgress& progress)
    {
        const Paint paint(style_);
        if (live_) {
            if (!progress.finished.empty()) last_ = progress.finished;
            const std::string bar = paint.bar(static_cast<Millipoints>(progress.units_graded),
                                              static_cast<Millipoints>(progress.units_to_grade), 16, Tone::good);
            const std::string text = progress_text(progress) + (last_.empty() ? "" : "  " + paint.safe(last_));
            fmt::print("\r\x1b[K{} {}", bar, shorten(text, style_.width - 20, paint.ellipsis()));
        } else if (!silent_ && !progress.finished.empty()) {
            fmt::print("graded {}{}  {}\n", progress.again ? "again, alone: " : "", paint.safe(progress.finished),
                       progress_text(progress));
        }
        (void)std::fflush(stdout);
    }

private:
    TerminalStyle style_;
    bool live_;
    bool silent_;
    std::string last_;
};

/// What the run did, in a few lines below the table.
void print_summary(const ClassGrading& graded, const Paint& paint)
{
    if (graded.units_kept > 0) fmt::print("\n{} units kept, {} graded\n", graded.units_kept, graded.units_graded);
    if (graded.earlier > 0)
        fmt::print("{} {} not asked for: their results stay as they are\n", graded.earlier,
                   graded.earlier == 1 ? "submission was" : "submissions were");
    if (!graded.changed.empty()) fmt::print("\nOther points than before:\n");
    for (const std::string& line : graded.changed) fmt::print("  {}\n", paint.safe(line));
    if (!graded.ignored.empty()) fmt::print("\nIgnored, since no submissions:\n");
    for (std::size_t i = 0; i < std::min(graded.ignored.size(), caps::listed); ++i)
        fmt::print("  {}: {}\n", paint.safe(graded.ignored[i].path), paint.safe(graded.ignored[i].reason));
    if (graded.ignored.size() > caps::listed) fmt::print("  and {} more\n", graded.ignored.size() - caps::listed);
}

void print(const ClassGrading& graded, const fs::path& out, const TerminalStyle& style)
{
    const Paint paint(style);
    fmt::print("{}\n{}", class_notices(graded.result, style), class_table(graded.result, style));
    print_summary(graded, paint);
    const auto path = [&](const fs::path& below) { return paint.safe((out / below).string()); };
    fmt::print(
        "\nIn a browser: {}\n              {}\nAs data:      {}\n              {} (for students: "
        "report.student.json)\n",
        path("index.html"), path("ID/report.html"), path("class.json"), path("ID/report.json"));
}

ClassOptions options_of(const Application& application, const GradeCommand& command)
{
    ClassOptions options;
    options.submissions = command.submissions;
    options.roster = command.roster;
    options.out = command.out;
    options.only = command.only;
    options.fresh = command.fresh;
    options.course_units = application.exercises;
    options.course = command.course;
    options.attempt = command.attempt;
    options.instructor_edition = command.with_hidden;
    options.jobs = command.jobs != 0 ? command.jobs : default_jobs_of_class();
    return options;
}

}

void grade_and_print(Application& application, const GradeCommand& command)
{
    // `umbral grade … | head` has read enough, and the class is still to be graded to its end.
    (void)std::signal(SIGPIPE, SIG_IGN);
    expect_folder(command.submissions, "a folder with one folder a submission");
    try {
        expect_distinct(command.submissions, command.out);
        if (!command.roster.empty()) (void)read_given("--roster", command.roster, most_roster_bytes);
        if (!command.secret_file.empty()) {
            expect_outside("the submissions", command.submissions, "--secret-file", command.secret_file);
            expect_outside("the reports", command.out, "--secret-file", command.secret_file);
        }
        std::vector<Exercise> exercises = application.chosen(command.units);
        std::vector<LeftOut> left_out;
        if (command.handed_in || !are_built(application, exercises)) {
            // Known mistakes explain what is wrong: they are built of units that somebody handed in.
            HandedIn handed = handed_in(folders_of(command), exercises, archive_tools(application.tools));
            if (command.handed_in) {
                refuse_no_task(command, handed);
                exercises = std::move(handed.task);
                left_out = std::move(handed.too_few);
                have_built(application, exercises);
            } else {
                have_built(application, begun(exercises, handed));
            }
        }
        have_built(application, exercises, UnitParts::answers);
        // Reports hold the values of hidden checks: they are nobody else's to read.
        umask(S_IRWXG | S_IRWXO);
        make_folder(command.out);
        ClassOptions options = options_of(application, command);
        options.left_out = std::move(left_out);
        options.secret = secret_from(command.secret_file);
        options.fingerprint = [&] {
            Worker first(application.tools);
            return fingerprint(first, exercises);
        }();
        refuse_weak_sandbox(*options.fingerprint, command.allow_weak_sandbox);
        const ClassGrading graded = [&] {
            Teller teller(application.style, command.json);
            return grade_class(application.tools, exercises, options, std::ref(teller));
        }();
        if (command.json)
            fmt::print("{}\n", to_json(graded.result).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
        else
            print(graded, options.out, application.style);
        if (!graded.written || !faults(graded.result).empty()) application.exit_status = exit_fault;
    } catch (const RefusedFolder& refused) {
        throw UsageError(refused.what());
    }
}

void add_grade(Command command, Application& application)
{
    auto options = std::make_shared<GradeCommand>();
    command.option("CLASS_DIR", options->submissions, "The class").required();
    command.option("--out", options->out, "Where reports go").required();
    command.option("--only", options->only, "Only these submissions, by id; the others' results stay as they are");
    command.option("--roster", options->roster,
                   "A CSV file with the columns folder,id or folder,id,name: how folders are called in reports");
    command.flag("--fresh", options->fresh, "Grade everything again, also what has not changed since the last time");
    command.option("--jobs", options->jobs, "Submissions at a time; 0: a quarter more than there are processors")
        .between(0, most_jobs)
        .with_default();
    command.option("--unit", options->units, "Only these units");
    command.flag("--handed-in", options->handed_in,
                 "Only units that a tenth of the class handed in, and two submissions at least if there are two");
    command.option("--course", options->course, "Part of what hidden seeds follow from").with_default();
    command.option("--attempt", options->attempt, "Another number gives other random inputs").with_default();
    command.option("--secret-file", options->secret_file,
                   "The secret that hidden seeds follow from; made if missing. Default: umbral/secret in your "
                   "configuration folder");
    command.flag("--allow-weak-sandbox", options->allow_weak_sandbox, "Grade even where the sandbox is incomplete");
    command.flag("--json", options->json, "Print class.json instead of a table");
    command.flag("--with-hidden", options->with_hidden,
                 "Also write report.instructor.html, in which hidden checks show their values: not for students");
    command.runs([&application, options] { grade_and_print(application, *options); });
}

}
