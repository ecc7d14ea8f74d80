#include <algorithm>
#include <glm/ext/matrix_relational.hpp>
#include <kit/varied.hpp>
#include <umbral/gl/record_trace.hpp>
#include <umbral/record/driver.hpp>

#include "chessboard.hpp"
#include "graphs.hpp"

namespace umbral {
namespace {

using namespace lighting;

std::string code_of(const Recipe& recipe)
{
    return "make_material(" + literal::of_value(recipe.reflection, false, literal::in_full) +
           (recipe.texture ? ", texture)" : ", nullptr)");
}

void record_activation(Recorder& out, Random& random, const std::unique_ptr<SurfaceMaterial>& material)
{
    if (!material) return;
    RecordingPipeline pipeline(random);
    material->activate(pipeline);
    Row row;
    append(row, pipeline.now.reflection);
    row.insert(row.end(), {static_cast<float>(pipeline.now.texture), static_cast<float>(pipeline.reflections_set),
                           static_cast<float>(pipeline.textures_set)});
    out.columns("active",
                "emission/3, ambient/3, diffuse/3, specular/3, shininess, texture, calls of set_reflection, calls of "
                "set_texture");
    out.append("active", std::span<const float>(row));
}

void activations(Recorder& out, Random& random, const std::vector<Recipe>& all)
{
    for (const Recipe& recipe : all) {
        ask_in_words(out, [&] { return code_of(recipe) + "->activate(pipeline);"; });
        record_activation(out, random, make_material(recipe.reflection, recipe.texture));
        const float k[] = {random.uniform(), random.uniform(), random.uniform(), any_material(random).shininess};
        ask_in_words(out, [&] {
            std::string text = "make_gray_material(";
            for (const float number : k) text += literal::of_value(number, false, literal::in_full) + ", ";
            return text + (recipe.texture ? "texture" : "nullptr") + ")->activate(pipeline);";
        });
        record_activation(out, random, make_gray_material(k[0], k[1], k[2], k[3], recipe.texture));
    }
}

// Varied, colours are others, and exponents smaller.
void materials_by_hand(Case& c, Recorder& out)
{
    const auto texture = std::make_shared<NamedTexture>(7);
    std::vector<Recipe> all = {
        {{}, nullptr},
        {{{0.125F, 0, 0.25F}, {0.25F, 0.5F, 0.125F}, {0.5F, 0.25F, 1}, {0.5F, 1, 0.25F}, 2}, texture},
        {{{}, {}, {}, glm::vec3(1), 0}, nullptr},
        {{{4, 0, 0}, {}, {}, {}, 10'000}, texture}};
    for (auto& [reflection, one] : all) {
        for (glm::vec3* const color :
             {&reflection.emission, &reflection.ambient, &reflection.diffuse, &reflection.specular})
            *color *= c.vary.near(glm::vec3(1), 0.25F);
        reflection.shininess *= c.vary.one_of(1.0F, std::array{0.5F, 0.75F});
    }
    activations(out, c.random, all);
}

// One after the other on one pipeline, and by turns on two; the materials know nothing of that.
void in_turn(Recorder& out, Random& random)
{
    const auto materials = made(recipes(random, 6));
    if (materials.empty()) return;
    RecordingPipeline pipelines[] = {RecordingPipeline(random), RecordingPipeline(random)};
    for (int i = 0; i < 60; ++i) {
        const std::uint32_t m = random.below(6);
        const std::uint32_t p = random.below(2);
        ask_in_words(out,
                     [&] { return "material" + std::to_string(m) + "->activate(pipeline" + std::to_string(p) + ");"; });
        materials[m]->activate(pipelines[p]);
        for (const RecordingPipeline& pipeline : pipelines) {
            Row row;
            append(row, pipeline.now.reflection);
            row.push_back(static_cast<float>(pipeline.now.texture));
            out.columns("active", "emission/3, ambient/3, diffuse/3, specular/3, shininess, texture");
            out.append("active", std::span<const float>(row));
        }
    }
}

// Two textures, three materials; what is let go, and in which order, is drawn by lot. A row after each step: which
// textures live. A material is activated only while its texture does.
void ownership(Recorder& out, Random& random)
{
    for (int round = 0; round < 12; ++round) {
        std::shared_ptr<SharedTexture> textures[] = {std::make_shared<NamedTexture>(1),
                                                     std::make_shared<NamedTexture>(2)};
        const std::weak_ptr<SharedTexture> watched[] = {textures[0], textures[1]};
        ask_in_words(out, [] {
            return "a = make_material(…, texture1);\nb = make_gray_material(…, texture1);\nc = make_material(…, "
                   "texture2);";
        });
        std::unique_ptr<SurfaceMaterial> materials[] = {make_material(random_material(random), textures[0]),
                                                        make_gray_material(0.2F, 0.8F, 0, 1, textures[0]),
                                                        make_material(random_material(random), textures[1])};
        const auto record = [&] {
            const float alive[] = {watched[0].expired() ? 0.0F : 1.0F, watched[1].expired() ? 0.0F : 1.0F};
            out.columns("textures", "texture 1 lives, texture 2 lives");
            out.append("textures", std::span<const float>(alive));
        };
        record();
        for (const int step : in_random_order(random, std::vector{0, 1, 2, 3, 4})) {
            ask_in_words(out, [&] {
                return std::string(step < 2 ? "texture" : "material ") +
                       (step < 2 ? std::to_string(step + 1) : std::string(1, "abc"[step - 2])) + ".reset();";
            });
            step < 2 ? textures[step].reset() : materials[step - 2].reset();
            record();
        }
    }
}

/// How often a node and those below it activate a material at most: for entries that name another than the active one,
/// and where they end.
std::uint32_t most_activations(const MaterialGraph& graph, std::uint32_t node, const SurfaceMaterial* active)
{
    const SurfaceMaterial* const before = active;
    std::uint32_t count = 0;
    for (const GraphEntry& entry : graph.nodes[node]) {
        if (entry.kind == GraphEntry::Kind::node) count += most_activations(graph, entry.index, active);
        if (entry.kind != GraphEntry::Kind::material || graph.materials[entry.index].get() == active) continue;
        active = graph.materials[entry.index].get();
        ++count;
    }
    return active == before ? count : count + 1;
}

void record_graph(Recorder& out, Random& random, MaterialGraph graph,
                  const std::vector<std::shared_ptr<const SurfaceMaterial>>& materials, bool lighting)
{
    graph.materials = materials;
    const std::unique_ptr<SurfaceMaterial> standard = make_gray_material(0.2F, 0.8F, 0, 1, nullptr);
    if (materials.empty() || !standard) return;
    RecordingPipeline pipeline(random);
    if (lighting) standard->activate(pipeline);
    const std::uint32_t most =
        pipeline.reflections_set + (lighting ? most_activations(graph, graph.root, standard.get()) : 0);
    // Without light too, somebody may have left a material there, which is not looked at.
    const bool has_material = lighting || random.below(2) == 0;
    DrawingContext context{pipeline, lighting, has_material ? standard.get() : nullptr};
    const glm::dmat4 matrix = pipeline.now.modelview;
    constexpr double rounding = 1e-4;  // of its entries, where it is brought back by other matrices
    ask_in_words(out, [&] { return code_of(graph) + (lighting ? "" : " // context.lighting is false"); });
    draw_graph(graph, context);
    record_drawn(out, pipeline);
    // A graph of nothing draws nothing, and leaves all as it was: only together with what was drawn is that an answer.
    const float left[] = {context.material == standard.get() ? 1.0F
                          : context.material == nullptr      ? 0.0F
                                                             : 2.0F,
                          pipeline.now.reflection.diffuse.b,
                          static_cast<float>(pipeline.now.texture),
                          static_cast<float>(pipeline.drawn.size()),
                          static_cast<float>(std::max(most, pipeline.reflections_set) - most),
                          glm::all(glm::equal(pipeline.now.modelview, matrix, rounding)) ? 1.0F : 0.0F};
    out.columns(
        "pointer",
        "context.material: 1 for the default one; 0 for none; 2 for another, diffuse blue on the pipeline, "
        "texture on the pipeline, objects drawn, activations without need, matrix (0: another one; 1: as before)");
    out.append("pointer", std::span<const float>(left));
}

void graphs(Recorder& out, Random& random, int count, bool lighting)
{
    out.text("drawn.names", event_names);
    for (int i = 0; i < count; ++i) {
        auto materials = made(recipes(random, 7));
        if (materials.empty()) return;
        // The last one is the first one again.
        materials.push_back(materials.front());
        record_graph(out, random, random_graph(random, 8), materials, lighting);
    }
}

void graph_by_hand_case(Recorder& out, Random& random)
{
    out.text("drawn.names", event_names);
    const auto materials = made(recipes(random, 4));
    // Often, so that the long graph below does not outweigh it.
    for (int i = 0; i < 10; ++i) record_graph(out, random, graph_by_hand(), made(recipes(random, 4)), true);
    record_graph(out, random, graph_by_hand(), materials, false);
    MaterialGraph empty;
    empty.nodes = {{}};
    record_graph(out, random, empty, materials, true);
    record_graph(out, random, deep_graph(300, 3), materials, true);
}

// What real OpenGL is told.
void calls(Recorder& out)
{
    const LinearFrame frame(32, 32);
    const Board board;
    if (!board.complete()) return;
    ask_in_words(out, [] { return "draw_graph(chessboard(), context);"; });
    gl::begin_trace();
    board.draw();
    gl::record_trace(out, "calls", gl::end_trace());
}

// Varied, the board is turned.
void picture(Variation& vary, Recorder& out)
{
    constexpr int size = 288;
    const LinearFrame frame(2 * size, 2 * size);
    frame.clear(board_background);
    const Board board;
    if (!board.complete()) return;
    ask_in_words(out, [] { return "draw_graph(chessboard(), context);"; });
    board.draw(vary.turn({0, 1, 0}, 0.6F));
    out.image("board", frame.picture());
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { materials_by_hand(c, out); }},
    {"random", [](Case& c, Recorder& out) { activations(out, c.random, recipes(c.random, 12)); }},
    {"in turn", [](Case& c, Recorder& out) { in_turn(out, c.random); }},
    {"ownership", [](Case& c, Recorder& out) { ownership(out, c.random); }},
    {"graph", [](Case& c, Recorder& out) { graph_by_hand_case(out, c.random); }},
    {"random graphs", [](Case& c, Recorder& out) { graphs(out, c.random, 8, true); }},
    {"without light", [](Case& c, Recorder& out) { graphs(out, c.random, 4, false); }},
    {"calls", [](Case&, Recorder& out) { calls(out); }},
    {"picture", [](Case& c, Recorder& out) { picture(c.vary, out); }},
};

}
