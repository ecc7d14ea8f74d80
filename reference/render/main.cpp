// umbral-render: the reference engine as a program. `umbral render` starts it: the grader itself holds no line of the
// reference.

#include <cstdio>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <umbral/core/png.hpp>
#include <utility>

#include "render/agreement.hpp"
#include "render/budget/draw.hpp"
#include "render/buffers.hpp"
#include "render/film.hpp"
#include "render/options.hpp"
#include "render/picture.hpp"
#include "render/rays/shutter.hpp"
#include "render/renderers.hpp"
#include "render/report.hpp"
#include "render/scene_files.hpp"
#include "scene/motion.hpp"
#include "scene/scene_json.hpp"

namespace umbral::render {
namespace {

/// What goes wrong inside is the user's to mend: a scene, a folder, a disk.
template <class Action>
auto as_given(const Action& action)
{
    try {
        return action();
    } catch (const std::runtime_error& error) {
        throw UsageError(error.what());
    }
}

void print(const std::string& text)
{
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
        throw UsageError("cannot write to standard output");
}

std::string dumped(const nlohmann::json& json)
{
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

int run_comparison(const Options& options)
{
    Studio studio;
    bool all_agree = true;
    nlohmann::json all = nlohmann::json::array();
    std::string notes;
    if (!options.json) print(agreement_head());
    for (const std::filesystem::path& file : as_given([&] { return scenes_of(options.scene); })) {
        scene::Scene scene = as_given([&] { return scene::read_scene(file); });
        if (scene.title.empty()) scene.title = file.filename().string();
        const SceneAgreement agreement =
            compare_renderers(studio, scene, options.all_effects, options.size.width, options.size.height);
        all_agree = all_agree && agrees(agreement);
        all.push_back(to_json(agreement));
        notes += scene.title + "\n" + agreement_notes(agreement);
        if (!options.json) print(agreement_rows(agreement));
    }
    print(options.json ? dumped({{"format", "umbral-render-agreement"},
                                 {"version", 1},
                                 {"width", options.size.width},
                                 {"height", options.size.height},
                                 {"kernel", options.all_effects ? "all" : "derived"},
                                 {"agree", all_agree},
                                 {"scenes", all}})
                       : "\n" + notes);
    return all_agree ? exit_ok : exit_differ;
}

/// The scene at a time, by a renderer; by one that follows rays, for as long as its shutter is open.
Drawn draw_at(Studio& studio, const Options& options, const scene::Scene& scene, double seconds,
              const rays::Effort& effort)
{
    const int width = options.size.width * options.samples;
    const int height = options.size.height * options.samples;
    const Renderer& renderer = renderer_named(options.renderer);
    if (renderer.follows_rays && rays::is_blurred_by_motion(scene)) {
        rays::RayCounts counts;
        Frame frame = rays::draw_with_open_shutter(scene, seconds, width, height, effort, &counts);
        return {std::move(frame), rays::counts_of(counts)};
    }
    const scene::Scene still = scene::at_time(scene, seconds);
    const DrawList list = make_draw_list(still, width, height, renderer.follows_rays);
    const EffectSet effects = options.all_effects ? all_effects : derive_effects(list, still).set;
    return studio.draw(renderer, {list, effects, width, height, options.explain, effort});
}

/// Pictures of the scene at even steps of time.
int run_film(const Options& options)
{
    const scene::Scene scene = as_given([&] { return scene::read_scene(options.scene); });
    const float seconds = as_given([&] { return film_seconds(options.film, scene); });
    Studio studio;
    Progress progress(options.progress);
    for (int i = 0; i < options.film.pictures; ++i) {
        const double share = static_cast<double>(i) / options.film.pictures;
        as_given([&] {
            const Drawn drawn = draw_at(studio, options, scene, share * seconds, options.effort);
            write_png(numbered(options.out, i), make_picture(drawn.frame, scene, options.samples));
        });
        progress.tell(static_cast<double>(i + 1) / options.film.pictures);
    }
    if (!options.film.film.empty()) as_given([&] { join_pictures(options.film, seconds, options.out); });
    return exit_ok;
}

int run(const Options& options)
{
    if (options.compare) return run_comparison(options);
    if (options.film.pictures > 0) return run_film(options);
    const scene::Scene scene = as_given([&] { return scene::read_scene(options.scene); });
    const int width = options.size.width * options.samples;
    const int height = options.size.height * options.samples;
    const Renderer& renderer = renderer_named(options.renderer);
    const DrawList list = make_draw_list(scene, width, height, renderer.follows_rays);
    Report report{.scene = options.scene,
                  .title = scene.title,
                  .renderer = options.renderer,
                  .width = options.size.width,
                  .height = options.size.height,
                  .samples = options.samples,
                  .out = options.out,
                  .derived = derive_effects(list, scene),
                  .ray_effects = rays::ray_effects(scene),
                  .follows_rays = renderer.follows_rays,
                  .all_effects = options.all_effects,
                  .how = renderer.effects,
                  .counts = {}};
    Studio studio;
    nlohmann::json budget;
    if (options.wish && rays::is_blurred_by_motion(scene))
        throw UsageError("--error and --time choose for pictures of one moment, and the scene's shutter is open for " +
                         std::to_string(scene.camera.shutter_seconds) + " s: choose --rays yourself");
    Drawn drawn = as_given([&] {
        if (options.wish) {
            budget::Result within = budget::draw_within(*options.wish, scene, list, width, height,
                                                        options.effort.threads, budget::wall_seconds);
            if (!options.json) print(text_of(within));
            budget = to_json(within);
            return Drawn{std::move(within.frame), {}};
        }
        Progress progress(options.progress);
        rays::Effort effort = options.effort;
        if (options.progress) effort.progress = [&](double done) { progress.tell(done); };
        Drawn frame = draw_at(studio, options, scene, 0, effort);
        progress.tell(1);
        return frame;
    });
    report.counts = std::move(drawn.counts);
    as_given([&] {
        if (!options.out.empty()) write_png(options.out, make_picture(drawn.frame, scene, options.samples));
        if (!options.buffers.empty()) write_buffers(options.buffers, drawn.frame);
    });
    if (options.json) {
        nlohmann::json said = to_json(report);
        if (options.wish) said["budget"] = budget;
        print(dumped(said));
    } else if (options.explain)
        print(explanation(report));
    return exit_ok;
}

}
}

int main(int count, char** words)
{
    using namespace umbral::render;
    try {
        int status = exit_ok;
        const auto options = parse_options(count, words, status);
        return options ? run(*options) : status;
    } catch (const UsageError& error) {
        (void)std::fprintf(stderr, "umbral render: %s\n", error.what());
        return exit_usage;
    } catch (const std::bad_alloc&) {
        (void)std::fputs("umbral render: not enough memory: choose a smaller --size or a smaller scene\n", stderr);
        return exit_usage;
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral render: a fault of Umbral's own: %s\n", error.what());
        return exit_fault;
    }
}
