// umbral-render: the reference engine as a program. `umbral render` starts it: the grader itself holds no line of the
// reference.

#include <cstdio>
#include <new>
#include <nlohmann/json.hpp>
#include <umbral/core/png.hpp>
#include <umbral/gl/context.hpp>

#include "render/buffers.hpp"
#include "render/opengl.hpp"
#include "render/options.hpp"
#include "render/picture.hpp"
#include "render/report.hpp"
#include "render/software.hpp"
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

Frame draw_by_gl(const DrawList& list, const EffectSet& effects, int width, int height)
{
    const gl::OffscreenContext context;
    return draw_with_opengl(list, effects, width, height);
}

void print(const std::string& text)
{
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
        throw UsageError("cannot write to standard output");
}

int run(const Options& options)
{
    const scene::Scene scene = as_given([&] { return scene::read_scene(options.scene); });
    const int width = options.size.width * options.samples;
    const int height = options.size.height * options.samples;
    const DrawList list = make_draw_list(scene, width, height);
    Report report{.scene = options.scene,
                  .title = scene.title,
                  .renderer = options.compare ? "software against gl" : options.renderer,
                  .width = options.size.width,
                  .height = options.size.height,
                  .samples = options.samples,
                  .out = options.out,
                  .derived = derive_effects(list, scene),
                  .all_effects = options.all_effects,
                  .counters = {},
                  .comparison = {},
                  .agreement = {}};
    const EffectSet effects = options.all_effects ? all_effects : report.derived.set;

    Frame frame;
    if (options.compare || options.renderer == "software") {
        SoftwarePicture picture = draw_in_software(list, effects, width, height);
        report.counters = picture.counters;
        frame = std::move(picture.frame);
    }
    if (options.compare) {
        report.comparison = compare(frame, draw_by_gl(list, effects, width, height));
    } else if (options.renderer == "gl") {
        frame = draw_by_gl(list, effects, width, height);
    }
    as_given([&] {
        if (!options.out.empty()) write_png(options.out, make_picture(frame, scene, options.samples));
        if (!options.buffers.empty()) write_buffers(options.buffers, frame);
    });

    if (options.json) {
        print(to_json(report).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    } else {
        if (options.explain) print(explanation(report));
        if (report.comparison) print(comparison_table(report));
    }
    return report.comparison && !agrees(*report.comparison, report.agreement) ? exit_differ : exit_ok;
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
