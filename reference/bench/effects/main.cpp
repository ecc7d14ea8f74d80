// bench-effects: each renderer draws each scene with all effects and with those that the scene calls for, in turns.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "render/renderers.hpp"
#include "render/scene_files.hpp"
#include "scene/scene_json.hpp"

namespace {

using namespace umbral;
using namespace umbral::render;

/// What this thread has spent of the processor, in milliseconds; nothing that is measured starts threads.
double processor_milliseconds()
{
    timespec now{};
    (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Medians over rounds; the ratio is that of a round's two pictures, so that what disturbs both is left out.
struct Saved {
    double derived = 0;  ///< milliseconds a picture
    double ratio = 0;    ///< all effects over derived ones
};

Saved measure(Studio& studio, const Renderer& renderer, const DrawList& list, const EffectSet& effects, int size,
              int rounds)
{
    const auto time_of = [&](const EffectSet& set) {
        const double start = processor_milliseconds();
        (void)studio.draw(renderer, {list, set, size, size});
        return processor_milliseconds() - start;
    };
    (void)time_of(effects);  // warms caches, and makes the context
    (void)time_of(all_effects);
    std::vector<double> derived;
    std::vector<double> ratios;
    for (int round = 0; round < rounds; ++round) {
        const bool derived_first = round % 2 == 0;
        const double first = time_of(derived_first ? effects : all_effects);
        const double second = time_of(derived_first ? all_effects : effects);
        derived.push_back(derived_first ? first : second);
        ratios.push_back(derived_first ? second / first : first / second);
    }
    return {median(derived), median(ratios)};
}

std::string absent_effects(const EffectSet& effects)
{
    std::string names;
    for (std::size_t i = 0; i < effect_flags.size(); ++i)
        if (!(effects.*effect_flags[i])) names += (names.empty() ? "" : ", ") + std::string(effect_names[i]);
    return names.empty() ? "none" : names;
}

/// The same things in the same places, matt, flat, one-sided, without textures, in lights from far away: what it saves
/// then is the most that can be saved.
scene::Scene without_effects(scene::Scene scene)
{
    scene.title += ", without them";
    for (scene::Light& light : scene.lights) light.positional = false;
    for (scene::Material& material : scene.materials) {
        material.specular = glm::vec3(0);
        material.texture.reset();
    }
    for (scene::Instance& instance : scene.instances) {
        instance.smooth = false;
        instance.sides = scene::Sides::front;
    }
    return scene;
}

void print_row(Studio& studio, const scene::Scene& scene, const std::vector<const Renderer*>& renderers, int size,
               int rounds)
{
    const DrawList list = make_draw_list(scene, size, size);
    const EffectSet effects = derive_effects(list, scene).set;
    fmt::print("| {} | {} |", scene.title, absent_effects(effects));
    for (const Renderer* renderer : renderers) {
        try {
            const Saved saved = measure(studio, *renderer, list, effects, size, rounds);
            fmt::print(" {:.0f} | {:.2f} |", saved.derived, saved.ratio);
        } catch (const std::runtime_error&) {
            fmt::print(" not drawn | |");
        }
        (void)std::fflush(stdout);
    }
    fmt::print("\n");
}

int run(const std::filesystem::path& scenes, int size, int rounds)
{
    const std::vector<const Renderer*> renderers = {&renderer_named("software"), &renderer_named("gl"),
                                                    &renderer_named("gl-fixed")};
    std::string head = "| scene | effects not called for |";
    std::string line = "\n|---|---|";
    for (const Renderer* renderer : renderers) {
        head += fmt::format(" {}: ms | all over derived |", renderer->name);
        line += "---|---|";
    }
    fmt::print("{}{}\n", head, line);
    Studio studio;
    for (const std::filesystem::path& file : scenes_of(scenes)) {
        scene::Scene scene = scene::read_scene(file);
        if (scene.title.empty()) scene.title = file.stem().string();
        print_row(studio, scene, renderers, size, rounds);
        print_row(studio, without_effects(scene), renderers, size, rounds);
    }
    return 0;
}

}

int main(int count, char** words)
{
    CLI::App app(
        "Measures what the engine saves by drawing without the effects that a scene does not call for: processor time "
        "of a picture, its shaders compiled anew and its objects made, and the ratio of all effects to the derived "
        "ones, in turns, medians.",
        "umbral bench effects");
    std::string scenes;
    int size = 512;
    int rounds = 11;
    app.add_option("SCENES", scenes, "A scene, or a folder of them")->required();
    app.add_option("--size", size, "Pixels a side")->check(CLI::Range(1, 4096))->capture_default_str();
    app.add_option("--rounds", rounds, "Pairs of pictures")->check(CLI::Range(1, 1000))->capture_default_str();
    CLI11_PARSE(app, count, words);
    try {
        return run(scenes, size, rounds);
    } catch (const std::runtime_error& error) {
        fmt::print(stderr, "umbral bench effects: {}\n", error.what());
        return 2;
    }
}
