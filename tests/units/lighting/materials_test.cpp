#include <gtest/gtest.h>

#include <lighting/materials/graphs.hpp>

// Linked with the reference. What is expected is found for each object alone, by walking back from it to the root.

using namespace umbral;
using namespace umbral::lighting;

namespace {

/// The way from the root to an object: at which entry of which node it goes on.
struct Step {
    std::uint32_t node;
    std::size_t entry;
};

struct Expected {
    std::uint32_t object;
    glm::dmat4 matrix;
    const SurfaceMaterial* material;
};

/// The course's rule: the first material entry found on the way back; the default one if there is none.
const SurfaceMaterial* found_backwards(const MaterialGraph& graph, const std::vector<Step>& way,
                                       const SurfaceMaterial* standard)
{
    for (std::size_t s = way.size(); s-- > 0;)
        for (std::size_t i = way[s].entry; i-- > 0;) {
            const GraphEntry& entry = graph.nodes[way[s].node][i];
            if (entry.kind == Kind::material) return graph.materials[entry.index].get();
        }
    return standard;
}

glm::dmat4 product(const MaterialGraph& graph, const std::vector<Step>& way, const glm::dmat4& first)
{
    glm::dmat4 matrix = first;
    for (const auto& [node, end] : way)
        for (std::size_t i = 0; i < end; ++i) {
            const GraphEntry& entry = graph.nodes[node][i];
            if (entry.kind == Kind::transformation) matrix = matrix * glm::dmat4(graph.transformations[entry.index]);
        }
    return matrix;
}

/// All objects by all their ways, in order.
std::vector<Expected> expected_of(const MaterialGraph& graph, const glm::dmat4& first, const SurfaceMaterial* standard)
{
    std::vector<Expected> all;
    std::vector<Step> way = {{graph.root, 0}};
    while (!way.empty()) {
        const std::vector<GraphEntry>& entries = graph.nodes[way.back().node];
        if (way.back().entry == entries.size()) {
            way.pop_back();
            if (!way.empty()) ++way.back().entry;
            continue;
        }
        const auto [kind, index] = entries[way.back().entry];
        if (kind == Kind::node) {
            way.push_back({index, 0});
            continue;
        }
        if (kind == Kind::object)
            all.push_back({index, product(graph, way, first), found_backwards(graph, way, standard)});
        ++way.back().entry;
    }
    return all;
}

bool same(const Material& a, const Material& b)
{
    return a.emission == b.emission && a.ambient == b.ambient && a.diffuse == b.diffuse && a.specular == b.specular &&
           a.shininess == b.shininess;
}

void expect_drawn(const MaterialGraph& graph, Random& random)
{
    const auto standard = make_gray_material(0.2F, 0.8F, 0, 1, nullptr);
    RecordingPipeline pipeline(random);
    standard->activate(pipeline);
    const Standing before = pipeline.now;
    const std::size_t depth = pipeline.stack.size();
    DrawingContext context{pipeline, true, standard.get()};
    draw_graph(graph, context);

    const std::vector<Expected> expected = expected_of(graph, before.modelview, standard.get());
    ASSERT_EQ(pipeline.drawn.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto& [object, standing] = pipeline.drawn[i];
        ASSERT_EQ(object, expected[i].object);
        RecordingPipeline alone(random);
        expected[i].material->activate(alone);
        ASSERT_TRUE(same(standing.reflection, alone.now.reflection)) << "object " << object;
        ASSERT_EQ(standing.texture, alone.now.texture);
        for (int column = 0; column < 4; ++column)
            ASSERT_LE(glm::length(standing.modelview[column] - expected[i].matrix[column]), 1e-9);
    }
    EXPECT_EQ(context.material, standard.get());
    EXPECT_TRUE(same(pipeline.now.reflection, before.reflection));
    EXPECT_EQ(pipeline.now.texture, before.texture);
    EXPECT_EQ(pipeline.now.modelview, before.modelview);
    EXPECT_EQ(pipeline.stack.size(), depth);
}

}

TEST(Materials, an_object_has_the_first_material_on_the_way_back_to_the_root)
{
    constexpr std::uint64_t seed = 20451;
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", graph " << i);
        MaterialGraph graph = random_graph(random, 7);
        graph.materials = made(recipes(random, 7));
        expect_drawn(graph, random);
    }
    MaterialGraph graph = deep_graph(3000, 4);
    graph.materials = made(recipes(random, 4));
    graph.nodes.resize(3000);
    expect_drawn(graph, random);
}

// The statement's example: which material each object has, and how often one is activated.
TEST(Materials, known_answers)
{
    Random random(1);
    const std::vector<Recipe> all = recipes(random, 3);
    MaterialGraph graph;
    graph.materials = made(all);
    graph.nodes = {{{Kind::object, 'a'},
                    {Kind::material, 0},
                    {Kind::object, 'b'},
                    {Kind::node, 1},
                    {Kind::object, 'c'},
                    {Kind::node, 2},
                    {Kind::material, 1},
                    {Kind::node, 2}},
                   {{Kind::object, 'd'}, {Kind::material, 2}, {Kind::object, 'e'}},
                   {{Kind::object, 'f'}}};
    expect_drawn(graph, random);
    RecordingPipeline pipeline(random);
    const auto standard = make_gray_material(0.25F, 0.5F, 1, 8, nullptr);
    standard->activate(pipeline);
    const Material gray{glm::vec3(0), glm::vec3(0.25F), glm::vec3(0.5F), glm::vec3(1), 8};
    EXPECT_TRUE(same(pipeline.now.reflection, gray));
    EXPECT_EQ(pipeline.now.texture, 0U);
    DrawingContext context{pipeline, true, standard.get()};
    draw_graph(graph, context);
    EXPECT_EQ(pipeline.reflections_set - 1, 5U);
    const std::pair<char, Material> expected[] = {{'a', gray},
                                                  {'b', all[0].reflection},
                                                  {'d', all[0].reflection},
                                                  {'e', all[2].reflection},
                                                  {'c', all[0].reflection},
                                                  {'f', all[0].reflection},
                                                  {'f', all[1].reflection}};
    ASSERT_EQ(pipeline.drawn.size(), std::size(expected));
    for (std::size_t i = 0; i < std::size(expected); ++i) {
        EXPECT_EQ(pipeline.drawn[i].object, static_cast<std::uint32_t>(expected[i].first));
        EXPECT_TRUE(same(pipeline.drawn[i].standing.reflection, expected[i].second)) << expected[i].first;
    }
}

TEST(Materials, nothing_is_activated_without_lighting)
{
    Random random(2);
    MaterialGraph graph = graph_by_hand();
    graph.materials = made(recipes(random, 4));
    RecordingPipeline pipeline(random);
    DrawingContext context{pipeline, false, nullptr};
    draw_graph(graph, context);
    EXPECT_EQ(pipeline.reflections_set + pipeline.textures_set, 0U);
    EXPECT_EQ(context.material, nullptr);
    EXPECT_FALSE(pipeline.drawn.empty());
}

TEST(Materials, a_texture_lives_as_long_as_the_last_material_that_has_it)
{
    std::shared_ptr<SharedTexture> texture = std::make_shared<NamedTexture>(3);
    const std::weak_ptr<SharedTexture> watched = texture;
    auto one = make_material({}, texture);
    auto other = make_gray_material(0.2F, 0.8F, 0, 1, std::move(texture));
    one.reset();
    EXPECT_FALSE(watched.expired());
    Random random(3);
    RecordingPipeline pipeline(random);
    other->activate(pipeline);
    EXPECT_EQ(pipeline.now.texture, 3U);
    other.reset();
    EXPECT_TRUE(watched.expired());
}

// An entry that names the active material, and a node that changes nothing, cost nothing.
TEST(Materials, an_active_material_is_not_activated_again)
{
    Random random(4);
    MaterialGraph graph;
    graph.materials = made(recipes(random, 2));
    graph.nodes = {{{Kind::material, 0}, {Kind::node, 1}, {Kind::material, 0}, {Kind::node, 1}, {Kind::object, 1}},
                   {{Kind::material, 0}, {Kind::object, 2}}};
    const auto standard = make_gray_material(0.2F, 0.8F, 0, 1, nullptr);
    RecordingPipeline pipeline(random);
    DrawingContext context{pipeline, true, standard.get()};
    draw_graph(graph, context);
    EXPECT_EQ(pipeline.reflections_set, 2U) << "once at the first entry, once at the root's end";
}
