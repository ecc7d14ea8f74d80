#include <fmt/format.h>

#include <array>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>

#include "bench/judges/resolutions.hpp"
#include "bench/judges/results.hpp"
#include "bench/judges/scene_pairs.hpp"
#include "bench/judges/unit_pairs.hpp"
#include "cli/application.hpp"
#include "cli/authors/commands.hpp"
#include "cli/checkout.hpp"
#include "cli/paths.hpp"
#include "judge/judges.hpp"
#include "model/scratch.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {
namespace {

struct JudgesOptions {
    std::vector<std::string> units;
    std::string scenes;
    std::string json;
    std::string markdown;
    unsigned seeds = 1;
    std::size_t jobs = default_jobs();
    bool no_units = false;
    bool no_scenes = false;
    bool quick = false;
    bool sizes = false;
};

/// A look of some seconds: one unit's pictures.
void make_quick(JudgesOptions& options)
{
    options.no_scenes = true;
    if (options.units.empty()) options.units = {"sphere"};
}

void write(const std::string& file, const std::string& text)
{
    if (!file.empty()) write_output(file, text);
}

/// Pixels on the side of most pictures; the thresholds were set on 256.
constexpr std::array sides{64, 96, 128, 192, 256, 384, 512};

/// The scenes in one size after the other.
void bench_sizes(Application& application, const JudgesOptions& options)
{
    expect_writable(options.markdown);
    std::vector<JudgedSize> sizes;
    for (const int side : sides) {
        const ScratchFolder scratch(std::filesystem::temp_directory_path() / "umbral-scenes");
        draw_scenes(have_program(application, "umbral-bench-scenes"), scratch.path(), side);
        sizes.push_back(judge_scenes(scratch.path(), side));
    }
    const std::string text = resolution_table(sizes);
    fmt::print("{}", text);
    write(options.markdown, text);
}

void bench_judges(Application& application, const JudgesOptions& options)
{
    application.require_answers();
    expect_writable(options.markdown);
    expect_writable(options.json);
    JudgeBench bench;
    std::mutex mutex;
    const VisitPair keep = [&](const PicturePair& pair) {
        MeasuredPair measured = measure(pair);
        const std::lock_guard lock(mutex);
        bench.pairs.push_back(std::move(measured));
    };
    const std::vector<Exercise> exercises =
        options.no_units ? std::vector<Exercise>{} : application.chosen(options.units);
    have_built(application, exercises);
    for (const Exercise& exercise : exercises)
        bench.pictures_per_submission += static_cast<double>(std::ranges::count_if(
            exercise.checks, [](const Check& check) { return judge_of(check).look == Look::colours; }));

    std::optional<ScratchFolder> scratch;
    std::filesystem::path folder = options.scenes;
    if (folder.empty() && !options.no_scenes) {
        scratch.emplace(std::filesystem::temp_directory_path() / "umbral-scenes");
        folder = scratch->path();
        draw_scenes(have_program(application, "umbral-bench-scenes"), folder);
    }
    // The scenes are one task, each unit's seed is another.
    const std::size_t tasks = exercises.size() * options.seeds + (options.no_scenes ? 0 : 1);
    Crew(application.tools, options.jobs).share_out(tasks, [&](Worker& worker, std::size_t index) {
        if (!options.no_scenes && index == 0) return visit_scenes(folder, keep);
        const std::size_t unit = options.no_scenes ? index : index - 1;
        Worker egl(application.tools, "egl");
        visit_unit(worker, egl, exercises[unit / options.seeds], static_cast<unsigned>(unit % options.seeds), keep);
    });
    // Workers finish in any order; the report has one.
    std::ranges::stable_sort(bench.pairs, {},
                             [](const MeasuredPair& pair) { return std::tie(pair.scene, pair.change); });
    bench.times = time_image_rule();
    const std::string text = as_markdown(bench);
    fmt::print("{}", text);
    write(options.markdown, text);
    if (!options.json.empty()) write(options.json, as_json(bench).dump());
}

}

void add_bench_judges(Command bench, Application& application)
{
    auto options = std::make_shared<JudgesOptions>();
    const Command command = bench.command(
        "judges", "How often the image rule catches wrong pictures, and blames right ones, beside other rules");
    command.also_called("judge");
    command.has_help();
    command.option("UNIT", options->units, "Only these units' pictures");
    command.option("--scenes", options->scenes, "Scenes that umbral-bench-scenes has drawn already")
        .called("FOLDER")
        .existing_folder();
    command.flag("--no-units", options->no_units, "Only the scenes drawn for this, and no unit");
    command.flag("--no-scenes", options->no_scenes, "Only the units");
    command.option("--seeds", options->seeds, "How many sets of random inputs of each unit")
        .between(1, most_seeds)
        .with_default();
    command.option("--jobs", options->jobs, "How many at a time").between(1, most_jobs).with_default();
    command.flag("--sizes", options->sizes,
                 "Instead: what pictures of 64 to 512 pixels cost to judge, and which bugs they show");
    command.option("--markdown", options->markdown, "Write the tables to this file too").called("FILE");
    command.option("--json", options->json, "Write every pair's measures to this file").called("FILE");
    command.flag("--quick", options->quick,
                 "A look of some seconds: no scenes, and of the units the sphere, if no other is named");
    command.runs([&application, options] {
        if (options->sizes) return bench_sizes(application, *options);
        if (options->quick) make_quick(*options);
        bench_judges(application, *options);
    });
}

}
