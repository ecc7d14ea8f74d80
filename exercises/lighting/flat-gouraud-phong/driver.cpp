#include <array>
#include <string>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "knot.hpp"
#include "scenes.hpp"

namespace umbral {
namespace {

using namespace lighting;

constexpr int size = 20;
// Targets are wider than high.
constexpr int width = 22;

using Model = glm::vec3 (*)(const SurfacePoint&);

// Illumination models that show what they are asked.
glm::vec3 its_place(const SurfacePoint& at) { return at.position; }
glm::vec3 its_normal(const SurfacePoint& at) { return at.normal; }
// Sharp, and up to 50: not linear in place or normal.
glm::vec3 its_highlight(const SurfacePoint& at)
{
    const float cosine = std::max(0.0F, dot(at.normal, glm::vec3(0.48F, 0.6F, 0.64F)));
    return {50 * cosine * cosine * cosine * cosine, cosine, at.position.x * cosine};
}

// What such a model sends as light.
std::string words_of(Model model)
{
    if (model == its_place) return "light: the place";
    if (model == its_normal) return "light: the normal";
    if (model == its_highlight) return "light: a sharp highlight";
    return "light: the normal + 2";
}

// A scene and what is in the target before.
struct Scene {
    StagedMesh mesh;
    pipeline::Layer target = empty_layer(width, size);
};

// Draws, and records the light of the pixels that changed, as fragments of that scene's number, and their depth. How
// often light was asked for.
template <auto draw>
int record(Recorder& out, std::string_view name, const Scene& scene, Model model, std::size_t number)
{
    pipeline::Layer layer = scene.target;
    int asked = 0;
    const Illumination illumination = [&](const SurfacePoint& at) {
        ++asked;
        return model(at);
    };
    ask_in_words(out, [&] {
        const std::string words = "a draw by the method \"" + std::string(name) + "\" of " +
                                  std::to_string(scene.mesh.triangles.size()) + " triangles with " +
                                  std::to_string(scene.mesh.vertices.size()) + " vertices, " + words_of(model);
        if (scene.mesh.triangles.size() > 4) return words;
        return words + "\n" + literal::of_value(scene.mesh.vertices, true, {}) + "\n" +
               literal::of_value(scene.mesh.triangles, true, {});
    });
    draw(scene.mesh.vertices, scene.mesh.triangles, illumination, layer);
    // So that reports say "pixel (4, 4) of draw 10".
    out.columns(name, "draw");
    out.columns(std::string(name) + " depths", "draw");
    if (layer.colors.cells.size() != width * size || layer.depths.cells.size() != width * size) return asked;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < width; ++x) {
            const glm::vec3 light = layer.colors.at(x, y);
            if (light == scene.target.colors.at(x, y) && layer.depths.at(x, y) == scene.target.depths.at(x, y))
                continue;
            const float row[] = {
                static_cast<float>(number), static_cast<float>(x), static_cast<float>(y), light.x, light.y, light.z};
            out.append(name, row);
            const float depth[] = {row[0], row[1], row[2], layer.depths.at(x, y)};
            out.append(std::string(name) + " depths", depth);
        }
    return asked;
}

// One scene by all three methods, with all three models.
void record_all(Recorder& out, const Scene& scene, std::size_t number)
{
    const Model models[] = {its_place, its_normal, its_highlight};
    for (std::size_t i = 0; i < 3; ++i) {
        record<draw_flat>(out, "flat", scene, models[i], 3 * number + i);
        record<draw_gouraud>(out, "gouraud", scene, models[i], 3 * number + i);
        record<draw_phong>(out, "phong", scene, models[i], 3 * number + i);
    }
}

// Joins two meshes; the second one is drawn later.
StagedMesh joined(StagedMesh first, const StagedMesh& second)
{
    const auto offset = static_cast<std::uint32_t>(first.vertices.size());
    first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
    for (const glm::uvec3& triangle : second.triangles) first.triangles.push_back(triangle + offset);
    return first;
}

// A square; varied, it is never as large as it is written, and turned in the world.
StagedMesh some_square(Variation& vary, float low, float high, float depth, float lean, float inverse_w = 1)
{
    const float varied_low = vary.one_of(low, std::array{low - 1});
    const float varied_high = vary.one_of(high, std::array{high - 3, high - 2, high + 1});
    return turned_in_world(vary, square(varied_low, varied_high, depth, lean, inverse_w));
}

void by_hand(Variation& vary, Recorder& out)
{
    const StagedMesh tilted = some_square(vary, 2, 18, 0.5F, 0.75F, 0.25F);
    StagedMesh turned = some_square(vary, 4, 16, 0.5F, 0.3F);
    for (glm::uvec3& triangle : turned.triangles) std::swap(triangle[0], triangle[1]);
    const Scene scenes[] = {
        {some_square(vary, 4, 16, 0.5F, 0)}, {some_square(vary, 3, 17, 0.25F, 2)}, {tilted}, {turned}};
    for (std::size_t i = 0; i < std::size(scenes); ++i) {
        record_all(out, scenes[i], i);
        // How often each method asks, where all is drawn.
        out.columns("evaluations", "flat, gouraud, phong");
        const int flat = record<draw_flat>(out, "flat", scenes[i], its_place, 100 + i);
        const int gouraud = record<draw_gouraud>(out, "gouraud", scenes[i], its_place, 100 + i);
        const int phong = record<draw_phong>(out, "phong", scenes[i], its_place, 100 + i);
        out.append("evaluations", glm::vec3(flat, gouraud, phong));
    }
    // To the right end of the target, and beyond it.
    record_all(out, {some_square(vary, 5, 27, 0.5F, 0.3F)}, std::size(scenes));
}

// Every third vertex lies where the one before it does, as along a crease, with a normal of its own; half of the
// triangles end in the corner in which the one before them does.
StagedMesh with_creases(Random& random, StagedMesh mesh)
{
    for (std::size_t v = 2; v < mesh.vertices.size(); v += 3)
        mesh.vertices[v].at.position = mesh.vertices[v - 1].at.position;
    for (std::size_t t = 1; t < mesh.triangles.size(); ++t) {
        const std::uint32_t last = mesh.triangles[t - 1][2];
        glm::uvec3& triangle = mesh.triangles[t];
        if (random.below(2) == 0 && triangle[0] != last && triangle[1] != last) triangle[2] = last;
    }
    return mesh;
}

void at_random(Random& random, Recorder& out)
{
    for (std::size_t i = 0; i < 6; ++i) {
        StagedMesh mesh = with_creases(random, random_mesh(random, size, i == 5 ? 600 : 9, 12));
        // One of them is a line; the others are drawn all the same.
        mesh.triangles[4][0] = mesh.triangles[4][1 + i % 2];
        record_all(out, {mesh}, i);
    }
    record_all(out, {random_mesh(random, size, 9, 0)}, 6);
}

// Where the others leave the window free, with other places in the world.
StagedMesh square_elsewhere()
{
    StagedMesh mesh = square(15, 19, 0.3F, 0.5F);
    for (StagedVertex& vertex : mesh.vertices) vertex.at.position += glm::vec3(3, 4, 5);
    return mesh;
}

// Squares before and behind each other, far or by a little, in either order, and targets that are not empty: nothing
// that is hidden may show, and light is asked for what passes the depth test at its turn only. The last one's vertices
// and those of a square elsewhere have numbers whose last 16 bits are the same.
void record_occlusion(Random& random, Variation& vary, Recorder& out)
{
    for (std::size_t i = 0; i < 19; ++i) {
        // Every fourth one lies in the near plane.
        const float near_depth = i % 4 == 3 ? 0 : random.uniform(0.2F, 0.4F);
        const StagedMesh near = some_square(vary, 6, 14, near_depth, 0.5F);
        // The last ones are hardly deeper: by 5 ulps and more.
        const float beyond = std::pow(10.0F, i % 2 == 0 ? random.uniform(-6.5F, -6.1F) : random.uniform(-6, -2.5F));
        const float far_depth = i < 12 ? random.uniform(0.5F, 0.7F) : near_depth + beyond;
        const StagedMesh far = some_square(vary, 2, 12, far_depth, 1);
        Scene scene{i < 12 && i % 2 == 0 ? joined(near, far) : joined(far, near)};
        if (i == 18) scene.mesh = joined(square_elsewhere(), behind_many_others(scene.mesh, 65'536 - 4));
        if (i < 12 && i % 3 == 1)  // the left part of the target hides all, its middle the far one
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < 11; ++x) scene.target.depths.at(x, y) = x < 8 ? 0.1F : 0.45F;
        if (i < 12 && i % 3 == 2)  // as deep as the near one: "less" is what passes
            for (int y = 0; y < 10; ++y)
                for (int x = 0; x < width; ++x) scene.target.depths.at(x, y) = near.vertices[0].window.depth;
        record<draw_flat>(out, "flat", scene, its_place, i);
        record<draw_gouraud>(out, "gouraud", scene, its_place, i);
        out.append("phong evaluations", record<draw_phong>(out, "phong", scene, its_place, i));
    }
}

// Triangles too small for the products of floats, or of no area in the world; normals that are null.
void record_degenerate(Random& random, Variation& vary, Recorder& out)
{
    for (std::size_t i = 0; i < 8; ++i) {
        StagedMesh mesh = square(2, 18, 0.5F, random.uniform(0.2F, 1));
        for (StagedVertex& vertex : mesh.vertices) {
            if (i < 3) vertex.at.position *= std::pow(10.0F, -20.0F - 3.5F * static_cast<float>(i));
            if (i == 3) vertex.at.position = glm::vec3(0.5F);
            if (i == 4) vertex.at.position.y = 2 * vertex.at.position.x;
            if (i >= 5) vertex.at.normal = glm::vec3(0);
        }
        // Of the last two scenes one vertex has a normal.
        if (i >= 6) mesh.vertices[i - 6].at.normal = random.unit_vector();
        mesh = turned_in_world(vary, std::move(mesh));
        const auto with_light = [](const SurfacePoint& at) { return at.normal + 2.0F; };
        record<draw_flat>(out, "flat", {mesh}, with_light, i);
        record<draw_phong>(out, "phong", {mesh}, with_light, i);
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { at_random(c.random, out); }},
    {"occlusion", [](Case& c, Recorder& out) { record_occlusion(c.random, c.vary, out); }},
    {"degenerate", [](Case& c, Recorder& out) { record_degenerate(c.random, c.vary, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("knot", knot(400, 260, c.vary)); }},
};

}
