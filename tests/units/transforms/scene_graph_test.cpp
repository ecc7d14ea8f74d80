#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <scenegraph/graph_file.hpp>
#include <set>
#include <transforms/recording_pipeline.hpp>
#include <transforms/scene-graph/arc_graphs.hpp>
#include <umbral/transforms/android.hpp>

#include "support/schema.hpp"

using namespace umbral;
using namespace umbral::transforms;

namespace {

const std::string graphs = UMBRAL_SOURCE_DIR "/reference/scenes/graphs/";

/// All instances of a graph, each way by itself: without the table that the reference keeps.
void walk(const SceneGraph& graph, std::uint32_t place, glm::dmat4 world, std::vector<Instance>& found)
{
    for (const Entry& entry : graph.nodes[place]) {
        if (entry.kind == Entry::Kind::object) found.push_back({entry.index, glm::mat4(world)});
        if (entry.kind == Entry::Kind::node) walk(graph, entry.index, world, found);
        if (entry.kind == Entry::Kind::transformation) world = world * glm::dmat4(graph.transformations[entry.index]);
    }
}

/// Objects with the words of their labels, straight from the arcs.
void walk(const ArcGraph& graph, std::uint32_t place, const std::vector<std::uint32_t>& word, std::vector<Way>& found)
{
    for (const Arc& arc : graph.nodes[place]) {
        std::vector<std::uint32_t> longer = word;
        longer.insert(longer.end(), arc.label.begin(), arc.label.end());
        if (arc.target.kind == Entry::Kind::object)
            found.emplace_back(arc.target.index, longer);
        else
            walk(graph, arc.target.index, longer, found);
    }
}

/// The number of nodes that the header promises, counted by comparing all labels with all.
std::size_t fewest_nodes(const ArcGraph& graph, std::uint32_t place, std::set<std::uint32_t>& seen)
{
    if (!seen.insert(place).second) return 0;
    std::set<std::vector<std::uint32_t>> labels;
    for (const Arc& arc : graph.nodes[place]) labels.insert(arc.label);
    std::size_t longest = 0;
    for (const auto& label : labels)
        longest += std::none_of(labels.begin(), labels.end(), [&](const auto& other) {
            return other.size() > label.size() && std::equal(label.begin(), label.end(), other.begin());
        });
    std::size_t sum = std::max<std::size_t>(1, longest);
    for (const Arc& arc : graph.nodes[place])
        if (arc.target.kind == Entry::Kind::node) sum += fewest_nodes(graph, arc.target.index, seen);
    return sum;
}

std::string refusal(const std::string& text)
{
    try {
        (void)scenegraph::parse_graph(text, "g.json");
        return "nothing was thrown";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

nlohmann::json small_graph()
{
    return {{"format", "umbral-scene-graph"},
            {"version", 1},
            {"objects", {{"disc", {{"primitive", "cylinder"}}}}},
            {"nodes",
             {{"a", {{{"node", "b"}}, {{"scale", {1, 2, 3}}}, {{"object", "disc"}}}}, {"b", nlohmann::json::array()}}},
            {"root", "a"}};
}

}

TEST(Expand, agrees_with_a_walk_along_every_way)
{
    constexpr std::uint64_t seed = 20240609;
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        const SceneGraph graph = random_graph(random);
        std::vector<Instance> expected;
        walk(graph, graph.root, glm::dmat4(1), expected);
        const std::vector<Instance> found = expand(graph, expected.size());
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_EQ(found[k].object, expected[k].object);
            EXPECT_EQ(found[k].world, expected[k].world);
        }
        if (!expected.empty()) {
            EXPECT_THROW((void)expand(graph, expected.size() - 1), TooManyInstances);
        }
    }
}

TEST(Expand, names_the_cycle)
{
    constexpr std::uint64_t seed = 20240610;
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        EXPECT_NO_THROW((void)expand(random_chain(random, false), 1000));
        const SceneGraph graph = random_chain(random, true);
        try {
            (void)expand(graph, 1000);
            ADD_FAILURE() << "no cycle was found";
        } catch (const CycleError& error) {
            const std::vector<std::uint32_t>& path = error.path();
            ASSERT_GE(path.size(), 2U);
            EXPECT_EQ(path.front(), path.back());
            for (std::size_t k = 1; k < path.size(); ++k) {
                const auto& entries = graph.nodes[path[k - 1]];
                EXPECT_TRUE(std::any_of(entries.begin(), entries.end(), [&](const Entry& e) {
                    return e.kind == Entry::Kind::node && e.index == path[k];
                }));
            }
        }
    }
}

TEST(Expand, does_not_walk_two_to_the_power_of_sixty_ways)
{
    EXPECT_TRUE(expand(doubling(60, {}), 10).empty());
    EXPECT_THROW((void)expand(doubling(60, {object(1)}), 1'000'000), TooManyInstances);
    EXPECT_EQ(expand(doubling(11, {object(1)}), 1024).size(), 1024U);
    EXPECT_EQ(expand(doubling(11, {object(1)}), std::numeric_limits<std::size_t>::max()).size(), 1024U);
}

TEST(ToPhigs, draws_the_same_with_the_fewest_nodes)
{
    constexpr std::uint64_t seed = 20240611;
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
        const ArcGraph graph = random_arc_graph(random);
        std::vector<Way> expected;
        walk(graph, graph.root, {}, expected);
        std::sort(expected.begin(), expected.end());
        const SceneGraph result = to_phigs(graph);
        EXPECT_EQ(ways(result), expected);
        std::set<std::uint32_t> seen;
        EXPECT_EQ(result.nodes.size(), fewest_nodes(graph, graph.root, seen));
    }
}

// The places that the course's facade has once its misprints are put right.
TEST(GraphFile, holds_the_facade)
{
    const scenegraph::GraphFile file = scenegraph::read_graph(graphs + "facade.json");
    const std::vector<Instance> found = expand(file.graph, 100);
    EXPECT_EQ(found.size(), expand(facade(), 100).size());
    const auto corner = [&](std::size_t i, glm::vec2 place) {
        return glm::vec2(found[i].world * glm::vec4(place, 0, 1));
    };
    const auto expect_near = [](glm::vec2 a, glm::vec2 b) {
        EXPECT_LT(glm::length(a - b), 1e-6F) << a.x << ' ' << a.y;
    };
    std::vector<std::size_t> squares;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (file.object_names[found[i].object] == "square") squares.push_back(i);
    ASSERT_EQ(squares.size(), 11U);  // two leaves of the door; three windows with a pane and two frames each
    expect_near(corner(squares[0], {1, 1}), {0.86F, 0.43F});
    expect_near(corner(squares[1], {1, 0}), {0.56F, 0});
    expect_near(corner(squares[2], {0, 0}), {0.13F, 0.13F});
    expect_near(corner(squares[2], {1, 1}), {0.43F, 0.43F});
    expect_near(corner(squares[3], {0, 0}), {0.13F + 0.3F * 0.1F, 0.13F + 0.3F * 0.1F});
    expect_near(corner(squares[3], {1, 1}), {0.13F + 0.3F * 0.42F, 0.13F + 0.3F * 0.9F});
    expect_near(corner(squares[4], {1, 0}), {0.13F + 0.3F * 0.548F, 0.13F + 0.3F * 0.1F});
}

// The graph of the file and the drawing code of the unit are two accounts of one figure.
TEST(GraphFile, holds_the_android_that_is_drawn)
{
    const scenegraph::GraphFile file = scenegraph::read_graph(graphs + "android.json");
    const std::vector<Instance> found = expand(file.graph, 100);
    RecordingPipeline pipeline;
    make_android()->draw(pipeline);
    std::size_t i = 0;
    for (const Call& call : pipeline.calls()) {
        if (call.kind != Call::Kind::primitive) continue;
        ASSERT_LT(i, found.size());
        EXPECT_EQ(std::get<Primitive>(file.shapes[found[i].object]), call.primitive);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                EXPECT_NEAR(found[i].world[column][row], call.modelview[column][row], 1e-6) << i;
        ++i;
    }
    EXPECT_EQ(i, found.size());
}

TEST(GraphFile, says_where_it_is_wrong)
{
    EXPECT_EQ(refusal(small_graph().dump()), "nothing was thrown");
    struct Wrong {
        const char* place;
        nlohmann::json value;
        const char* complaint;
    };
    const Wrong wrongs[] = {
        {"/root", "c", "g.json: root: expected one of \"a\", \"b\", got \"c\""},
        {"/nodes/a/0", {{"node", "c"}}, "g.json: nodes.a[0].node: expected one of \"a\", \"b\", got \"c\""},
        {"/nodes/a/2/object", "ball", "g.json: nodes.a[2].object: expected one of \"disc\", got \"ball\""},
        {"/nodes/a/1/scale", {1, 2}, "g.json: nodes.a[1].scale: expected a list of 3 to 3 items, got [1,2]"},
        {"/version", 2, "g.json: version: expected a whole number from 1 to 1, got 2"}};
    for (const Wrong& wrong : wrongs) {
        nlohmann::json json = small_graph();
        json[nlohmann::json::json_pointer(wrong.place)] = wrong.value;
        EXPECT_EQ(refusal(json.dump()), wrong.complaint);
    }
    for (const char* const entry : {"{}", R"({"node": "b", "object": "disc"})", R"({"shear": [1, 0, 0]})",
                                    R"({"rotate": {"degrees": 5, "axis": [0, 0, 0]}})"}) {
        nlohmann::json json = small_graph();
        json["nodes"]["a"][0] = nlohmann::json::parse(entry);
        EXPECT_NE(refusal(json.dump()).find("nodes.a[0]"), std::string::npos) << entry;
    }
}

TEST(GraphFile, names_the_nodes_of_a_cycle)
{
    nlohmann::json json = small_graph();
    json["nodes"]["b"] = {{{"node", "a"}}};
    const scenegraph::GraphFile file = scenegraph::parse_graph(json.dump(), "g.json");
    try {
        (void)expand(file.graph, 10);
        ADD_FAILURE() << "no cycle was found";
    } catch (const CycleError& error) {
        EXPECT_EQ(scenegraph::path_text(file, error), "a -> b -> a");
    }
}

TEST(GraphFile, is_what_its_schema_says)
{
    const umbral::test::Schema schema("scene-graph");
    for (const char* const name : {"facade.json", "android.json"}) {
        std::ifstream stream(graphs + name);
        EXPECT_EQ(schema.complaints(nlohmann::json::parse(stream)), "") << name;
    }
    EXPECT_EQ(schema.complaints(small_graph()), "");
    for (const char* const wrong : {R"({"shear": [1, 0, 0]})", R"({"scale": [1, 2]})",
                                    R"({"node": "b", "object": "disc"})", R"({"matrix": [[1, 0, 0, 0]]})"}) {
        nlohmann::json json = small_graph();
        json["nodes"]["a"][0] = nlohmann::json::parse(wrong);
        EXPECT_NE(schema.complaints(json), "") << wrong;
        EXPECT_NE(refusal(json.dump()), "nothing was thrown") << wrong;
    }
}
