#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <tuple>

#include "bench/explanations/explanations.hpp"
#include "bench/held_out.hpp"
#include "cli/application.hpp"
#include "cli/authors/commands.hpp"
#include "cli/checkout.hpp"
#include "cli/paths.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {
namespace {

struct ExplanationsOptions {
    std::vector<std::string> units;
    unsigned seeds = 2;
    std::size_t jobs = default_jobs();
    std::string json;
    bool quick = false;
};

/// A look of some seconds: one unit, whose work is explained quickly, and one set of inputs.
void make_quick(ExplanationsOptions& options)
{
    options.seeds = 1;
    if (options.units.empty()) options.units = {"frames"};
}

nlohmann::json to_json(const ExplainedWork& work)
{
    nlohmann::json said = nlohmann::json::array();
    for (const Explanation& one : work.explanations)
        said.push_back(
            {{"name", one.name}, {"confidence", one.confidence}, {"fit", one.fit}, {"ambiguous", one.ambiguous}});
    return {{"unit", work.unit},
            {"seed", work.seed},
            {"held_out", held_out(work.unit)},
            {"kind", to_string(work.kind)},
            {"subject", work.subject},
            {"outcome", to_string(work.said)},
            {"said", said}};
}

void write_json(const std::string& file, const std::vector<ExplainedWork>& work, unsigned seeds)
{
    nlohmann::json all = nlohmann::json::array();
    for (const ExplainedWork& one : work) all.push_back(to_json(one));
    write_output(
        file,
        nlohmann::json{{"format", "umbral-explanations"}, {"version", 1}, {"seeds", seeds}, {"work", all}}.dump(1) +
            "\n");
}

void measure(Application& application, const ExplanationsOptions& options)
{
    application.require_answers();
    expect_writable(options.json);
    const std::vector<Exercise> exercises = application.chosen(options.units);
    have_built(application, exercises);
    std::mutex mutex;
    std::vector<ExplainedWork> work;
    std::size_t finished = 0;
    const std::size_t total = exercises.size() * options.seeds;
    Crew(application.tools, options.jobs).share_out(total, [&](Worker& worker, std::size_t index) {
        const Exercise& exercise = exercises[index / options.seeds];
        std::vector<ExplainedWork> some =
            explain_known_work(worker, exercise, static_cast<unsigned>(index % options.seeds));
        const std::lock_guard lock(mutex);
        fmt::print(stderr, "{} of {}: {}\n{}", ++finished, total, exercise.id, explanation_misses(some));
        std::ranges::move(some, std::back_inserter(work));
    });
    // Workers finish in any order; what people compare has one.
    std::ranges::stable_sort(work, {}, [](const ExplainedWork& one) { return std::tie(one.unit, one.seed); });
    fmt::print("{} units, {} seeds\n\n{}", exercises.size(), options.seeds, explanation_table(work));
    if (!options.json.empty()) write_json(options.json, work, options.seeds);
    if (!meets_targets(work, false)) application.exit_status = exit_not_right;
}

}

void add_bench_explanations(Command bench, Application& application)
{
    auto options = std::make_shared<ExplanationsOptions>();
    const Command command = bench.command(
        "explanations", "How often the right reason is given for a mistake, and a wrong one for other work");
    command.has_help();
    command.option("UNIT", options->units, "Only these units");
    command.option("--seeds", options->seeds, "How many sets of random inputs").between(1, most_seeds).with_default();
    command.option("--jobs", options->jobs, "How many at a time").between(1, most_jobs).with_default();
    command.option("--json", options->json, "Write everything that was said, too").called("FILE");
    command.flag("--quick", options->quick,
                 "A look of some seconds: one set of inputs, of frames if no other unit is named");
    command.footer(
        "Exit status: 0 the targets are met (95 % right; less than 1 % wrong of work that matches no reason), 1 they "
        "are not.");
    command.runs([&application, options] {
        if (options->quick) make_quick(*options);
        measure(application, *options);
    });
}

}
