#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>

#include "bench/unforeseen/unforeseen.hpp"
#include "cli/application.hpp"
#include "cli/authors/commands.hpp"
#include "cli/checkout.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {
namespace {

struct UnforeseenOptions {
    std::vector<std::string> units;
    UnforeseenPlan plan;
    std::size_t jobs = default_jobs();
    bool quick = false;
};

/// A look of some seconds: one unit, few bugs.
void make_quick(UnforeseenOptions& options)
{
    options.plan.bugs = 2;
    options.plan.pairs = 0;
    if (options.units.empty()) options.units = {"sphere"};
}

void measure(Application& application, const UnforeseenOptions& options)
{
    application.require_answers();
    std::vector<Exercise> exercises = application.chosen(options.units);
    std::erase_if(exercises, [](const Exercise& exercise) { return !exercise.is_cpp(); });
    const std::filesystem::path finder = have_finder(application, "bench unforeseen makes bugs");
    have_built(application, exercises);
    std::mutex mutex;
    std::vector<UnforeseenBug> bugs;
    std::size_t finished = 0;
    Crew(application.tools, options.jobs).share_out(exercises.size(), [&](Worker& worker, std::size_t index) {
        std::vector<UnforeseenBug> some = explain_unforeseen(worker, exercises[index], finder, options.plan);
        const std::lock_guard lock(mutex);
        fmt::print(stderr, "{} of {}: {}\n", ++finished, exercises.size(), exercises[index].id);
        std::ranges::move(some, std::back_inserter(bugs));
    });
    // Workers finish in any order; what people compare has one.
    std::ranges::stable_sort(bugs, {}, &UnforeseenBug::unit);
    fmt::print("{} units\n\n{}", exercises.size(), unforeseen_table(bugs));
    if (!meets_targets(bugs)) application.exit_status = exit_not_right;
}

}

void add_bench_unforeseen(Command bench, Application& application)
{
    auto options = std::make_shared<UnforeseenOptions>();
    const Command command = bench.command(
        "unforeseen", "What is said of bugs that are in no list, and whether it is true with other inputs");
    command.has_help();
    command.option("UNIT", options->units, "Only these units");
    command.option("--bugs", options->plan.bugs, "How many bugs of each unit").between(0, 1000).with_default();
    command.option("--pairs", options->plan.pairs, "How many pairs of them").between(0, 1000).with_default();
    command.option("--seed", options->plan.seed, "Which bugs").between(0, 1'000'000).with_default();
    command.option("--jobs", options->jobs, "How many at a time").between(1, most_jobs).with_default();
    command.flag("--quick", options->quick, "A look of some seconds: two bugs of the sphere, if no unit is named");
    command.footer(
        "Exit status: 0 the targets are met (65 % get a true sentence about what or where, less than 1 % a false one), "
        "1 they are not.");
    command.runs([&application, options] {
        if (options->quick) make_quick(*options);
        measure(application, *options);
    });
}

}
