#include "render/agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "render/normals.hpp"
#include "render/opengl_fixed.hpp"

namespace umbral::render {
namespace {

/// Rays know no grid of 1/256 pixel, to which rasterisers move the corners of triangles: edges lie elsewhere by that,
/// and where two instances meet along the centres of pixels, either may be seen: no more pixels than a line across the
/// picture has.
Agreement for_rays(int height) { return {.edge_fraction = 1.0 / height}; }

struct Pictures {
    Frame frame;
    Grid<glm::vec3> normals;
};

Pictures draw_all(Studio& studio, const Renderer& renderer, const Job& job, const std::array<DrawList, 2>& normals)
{
    // Without textures and highlights there is less to do; that a kernel may have more makes no difference.
    const auto shown = [&](const DrawList& list) {
        Job other{.list = list, .effects = job.effects, .width = job.width, .height = job.height, .effort = job.effort};
        return studio.draw(renderer, other).frame;
    };
    return {studio.draw(renderer, job).frame, normals_of(shown(normals[0]), shown(normals[1]))};
}

template <class Asks>
bool any_seen(const DrawList& list, const Asks& asks)
{
    return std::ranges::any_of(list.draws,
                               [&](const Draw& draw) { return draw.visibility != Visibility::outside && asks(draw); });
}

std::vector<std::string> differences_of(const DrawList& list, const EffectSet& effects)
{
    std::vector<std::string> all;
    if (!list.lights.empty())
        all.emplace_back(
            "light at vertices: gl-fixed computes light at the corners of triangles and interpolates its colours, so "
            "highlights smaller than a triangle are smeared or lost");
    all.emplace_back(
        "silhouettes: gl-fixed multiplies its matrices before it places vertices, which rounds otherwise; a pixel "
        "whose centre an edge passes within a subpixel may fall to the other side");
    if (effects.textured)
        all.emplace_back(
            "texture filtering: texture coordinates differ in their last bits, which shows where they cross the edge "
            "of a texel");
    if (effects.clipped)
        all.emplace_back(
            "clipping: OpenGL clips at the picture's sides and the engine at a guard band; the new corners are rounded "
            "to the subpixel grid, which moves edges by less than that");
    all.emplace_back(
        "rays: they meet triangles where these are; rasterisers move corners to 1/256 of a pixel first. Shadows, "
        "mirrors, glass, bump maps, lenses and light between surfaces, which rays alone draw, are left out here");
    if (any_seen(list, [](const Draw& d) { return d.specular && d.material.exponent > fixed_function_exponent; }))
        all.emplace_back("exponents: OpenGL's fixed function takes 128 at most, and draws larger ones as that");
    if (any_seen(list, [](const Draw& d) { return d.texture && d.material.emission != glm::vec3(0); }))
        all.emplace_back("emission: the fixed function multiplies it by the texture, the others do not");
    return all;
}

double percent(std::size_t part, std::size_t of)
{
    return of == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(of);
}

}

SceneAgreement compare_renderers(Studio& studio, const scene::Scene& scene, bool all_kernels, int width, int height)
{
    const DrawList list = make_draw_list(scene, width, height);
    const EffectSet derived = derive_effects(list, scene).set;
    // Of rays, what the others can draw too.
    const Job job{.list = list,
                  .effects = all_kernels ? all_effects : derived,
                  .width = width,
                  .height = height,
                  .effort = {.local_only = true}};
    const std::array<DrawList, 2> normals = {normals_list(list, false), normals_list(list, true)};
    SceneAgreement agreement{scene.title, {}, differences_of(list, derived), {}};

    std::map<std::string, Pictures> drawn;
    for (const Renderer& renderer : all_renderers()) {
        try {
            drawn.emplace(renderer.name, draw_all(studio, renderer, job, normals));
        } catch (const std::runtime_error& error) {
            agreement.missing.emplace_back(error.what());
        }
    }
    struct Pair {
        const char* first;
        const char* second;
        bool same_light;
        Agreement allowed = {};
    };
    for (const auto& [first, second, same_light, allowed] :
         {Pair{"software", "gl", true}, Pair{"software", "gl-fixed", false}, Pair{"gl", "gl-fixed", false},
          Pair{"vertices", "gl-fixed", true}, Pair{"software", "raytrace", true, for_rays(height)}}) {
        const auto a = drawn.find(first);
        const auto b = drawn.find(second);
        if (a == drawn.end() || b == drawn.end()) continue;
        agreement.pairs.push_back(
            {first, second, same_light, allowed, compare(a->second.frame, b->second.frame, allowed),
             compare_normals(a->second.normals, b->second.normals, a->second.frame, b->second.frame)});
    }
    return agreement;
}

bool agrees(const PairComparison& pair)
{
    return pair.same_light ? agrees(pair.comparison, pair.allowed) : agrees_in_shape(pair.comparison, pair.allowed);
}

bool agrees(const SceneAgreement& agreement)
{
    return std::ranges::all_of(agreement.pairs, [](const PairComparison& pair) { return agrees(pair); });
}

std::string agreement_head()
{
    return "| scene | renderers | coverage | ids | depth: largest / mean | normals: largest / mean, degrees | "
           "colour inside: largest / mean / beyond 1 | colour at edges: RMS |\n|---|---|---|---|---|---|---|---|\n";
}

std::string agreement_rows(const SceneAgreement& agreement)
{
    std::string text;
    for (const PairComparison& pair : agreement.pairs) {
        const Comparison& c = pair.comparison;
        text += fmt::format(
            "| {} | {}, {} | {} | {} | {:.1e} / {:.1e} | {:.2g} / {:.1g} | {:.3g} / {:.2g} / {:.2f} % | {:.2g} |\n",
            agreement.title, pair.first, pair.second, c.coverage_differs, c.ids_differ, c.depth_max, c.depth_mean,
            pair.normals.largest, pair.normals.mean, c.color_max, c.color_mean, percent(c.color_beyond, c.interior),
            c.color_edge_rmse);
    }
    return text;
}

std::string agreement_notes(const SceneAgreement& agreement)
{
    std::string text;
    for (const std::string& difference : agreement.differences) text += "  " + difference + "\n";
    for (const std::string& missing : agreement.missing) text += "  not drawn: " + missing + "\n";
    for (const PairComparison& pair : agreement.pairs)
        text += fmt::format("  {} and {}: {}\n", pair.first, pair.second,
                            !agrees(pair)     ? "THEY DIFFER by more than is allowed"
                            : pair.same_light ? "they agree"
                                              : "they agree in coverage, ids and depth; light is computed elsewhere");
    return text;
}

nlohmann::json to_json(const SceneAgreement& agreement)
{
    nlohmann::json pairs = nlohmann::json::array();
    for (const PairComparison& pair : agreement.pairs) {
        const Comparison& c = pair.comparison;
        pairs.push_back({{"first", pair.first},
                         {"second", pair.second},
                         {"same_light", pair.same_light},
                         {"agree", agrees(pair)},
                         {"pixels", c.pixels},
                         {"covered_first", c.covered_first},
                         {"covered_second", c.covered_second},
                         {"coverage_differs", c.coverage_differs},
                         {"ids_differ", c.ids_differ},
                         {"interior_pixels", c.interior},
                         {"depth_max", c.depth_max},
                         {"depth_mean", c.depth_mean},
                         {"normal_degrees_max", pair.normals.largest},
                         {"normal_degrees_mean", pair.normals.mean},
                         {"color_max", c.color_max},
                         {"color_mean", c.color_mean},
                         {"color_beyond", c.color_beyond},
                         {"color_rmse", c.color_rmse},
                         {"color_edge_rmse", c.color_edge_rmse}});
    }
    return {{"title", agreement.title},
            {"pairs", pairs},
            {"differences", agreement.differences},
            {"missing", agreement.missing},
            {"agree", agrees(agreement)}};
}

}
