#include "validate/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <tuple>

#include "cli/application.hpp"
#include "cli/authors/commands.hpp"
#include "cli/authors/gaps.hpp"
#include "cli/authors/idle.hpp"
#include "cli/authors/mutants.hpp"
#include "cli/authors/unit_pages.hpp"
#include "cli/checkout.hpp"
#include "cli/paths.hpp"
#include "report/paint.hpp"
#include "validate/validation_table.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {
namespace {

struct ValidateOptions {
    std::vector<std::string> units;
    unsigned seeds = 2;
    std::size_t jobs = default_jobs();
    bool json = false;
    bool quiet = false;
    bool without_mistakes = false;
    std::string table;
    bool mutants = false;
    bool slips = false;
    bool idle = false;
    bool gaps = false;
    std::string markdown;
};

void print(const Finding& finding, const Paint& paint)
{
    const std::string mark =
        finding.holds ? paint(Tone::good, paint.symbol("✓", "ok")) : paint(Tone::bad, paint.symbol("✗", "NO"));
    fmt::print("{} {:<24} {:<38} seed {}  {:6.1f} %  expected {:<16} {}\n", mark, finding.unit, finding.subject,
               finding.seed, finding.credit, finding.expected, paint.safe(finding.message));
    (void)std::fflush(stdout);
}

void validate(Application& application, const ValidateOptions& options)
{
    const Paint paint(application.style);
    application.require_answers();
    expect_writable(options.table);
    std::vector<Exercise> exercises =
        options.units.empty() ? application.readable() : application.chosen(options.units);
    std::mutex mutex;
    std::vector<Finding> findings;
    // What has no reference cannot be built; the others can.
    std::erase_if(exercises, [&](const Exercise& exercise) {
        const Finding reference = expect_reference(application.tools.reference, exercise, 0);
        if (reference.holds) return false;
        findings.push_back(reference);
        if (!options.json) print(reference, paint);
        return true;
    });
    have_built(application, exercises, options.without_mistakes ? UnitParts::answers : UnitParts::all);
    // Units that may run longest begin first, so that none of them runs alone at the end.
    std::vector<const Exercise*> order;
    for (const Exercise& exercise : exercises) order.push_back(&exercise);
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [](const Exercise* exercise) { return exercise->limits.wall_seconds; });
    // The slowest units have the most seeds to wait for: seeds are shared out, not units.
    Crew(application.tools, options.jobs)
        .share_out(exercises.size() * options.seeds, [&](Worker& worker, std::size_t index) {
            validate_unit(
                worker, *order[index / options.seeds], static_cast<unsigned>(index % options.seeds),
                [&](const Finding& finding) {
                    const std::lock_guard lock(mutex);
                    findings.push_back(finding);
                    if (!options.json && (!options.quiet || !finding.holds)) print(finding, paint);
                },
                options.without_mistakes ? KnownMistakes::passed_over : KnownMistakes::graded);
        });
    // Workers finish in any order; what other programs read has one.
    std::ranges::stable_sort(findings, {}, [](const Finding& finding) { return std::tie(finding.unit, finding.seed); });
    const auto failing = std::ranges::count(findings, false, &Finding::holds);
    nlohmann::json rows = nlohmann::json::array();
    for (const Finding& finding : findings)
        rows.push_back({{"unit", finding.unit},
                        {"subject", finding.subject},
                        {"seed", finding.seed},
                        {"holds", finding.holds},
                        {"credit", finding.credit},
                        {"expected", finding.expected},
                        {"message", finding.message},
                        {"blind", finding.blind},
                        {"hard_share", finding.hard_share ? nlohmann::json(*finding.hard_share) : nlohmann::json()}});
    if (options.json)
        fmt::print("{}\n", nlohmann::json{{"format", "umbral-validation"}, {"version", 1}, {"findings", rows}}.dump(
                               2, ' ', false, nlohmann::json::error_handler_t::replace));
    else
        fmt::print("{} findings with {} seeds, {} of them not as they should be\n", findings.size(), options.seeds,
                   failing);
    if (!options.table.empty()) {
        const std::string table = validation_table(findings, exercises);
        write_unit_page(application, options.table, table);
    }
    const bool all_read = !options.units.empty() || application.broken.empty();
    if (failing != 0 || findings.empty() || !all_read) application.exit_status = exit_not_right;
}

}

void add_validate(Command command, Application& application)
{
    auto options = std::make_shared<ValidateOptions>();
    command.option("UNIT", options->units, "Only these units");
    command.option("--seeds", options->seeds, "How many sets of random inputs").between(1, most_seeds).with_default();
    command.option("--jobs", options->jobs, "How many at a time").between(1, most_jobs).with_default();
    command.flag("--quiet", options->quiet, "Print only what fails");
    command.flag("--without-mistakes", options->without_mistakes,
                 "Not the known mistakes: only that right work gets everything, controls and stub nothing");
    command.flag("--json", options->json, "As JSON");
    command
        .option("--table", options->table,
                "Write what each mistake got, and what it is told, as Markdown; of other units stays "
                "what the file says")
        .called("FILE");
    command.flag("--mutants", options->mutants, "Instead: small changes of each reference must lose points");
    command.flag("--slips", options->slips,
                 "Instead: what students write by a slip in each reference (another component, variable or order, a "
                 "tolerance, a kept answer) must lose points");
    command.flag("--idle", options->idle,
                 "Instead: a program whose functions do nothing, or give back what they are given, must earn nothing");
    command.flag(
        "--gaps", options->gaps,
        "Instead: print what the functions are never asked: numbers that are never 0, arguments that are never "
        "equal, and the like");
    command
        .option("--markdown", options->markdown,
                "With --mutants or --slips: write what came of them as Markdown; of other units stays what the file "
                "says")
        .called("FILE");
    command.runs([&application, options] {
        if (options->mutants && options->slips) throw UsageError("--mutants and --slips: one after the other");
        if (options->gaps && (options->mutants || options->slips || options->idle || options->json || options->quiet ||
                              !options->markdown.empty() || !options->table.empty()))
            throw UsageError("--gaps goes with --jobs and --seeds only");
        if (options->gaps) return print_gaps(application, options->units, options->jobs, options->seeds);
        if (options->idle && (options->mutants || options->slips || options->json || !options->markdown.empty() ||
                              !options->table.empty()))
            throw UsageError("--idle goes with --jobs and --quiet only");
        if (options->idle) return validate_idle(application, options->units, options->jobs, options->quiet);
        if (options->mutants || options->slips)
            return validate_mutants(application,
                                    {options->units, options->jobs, options->json, options->quiet, options->markdown,
                                     options->slips ? MutantFamily::slips : MutantFamily::syntax});
        if (options->without_mistakes && !options->table.empty())
            throw UsageError("--table tells what each mistake got; take --without-mistakes away");
        if (!options->markdown.empty())
            throw UsageError("--markdown goes with --mutants or --slips; mistakes have --table");
        validate(application, *options);
    });
}

}
