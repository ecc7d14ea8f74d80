#include <gtest/gtest.h>

#include <memory>
#include <transforms/parametric-graph/parts.hpp>
#include <transforms/recording_pipeline.hpp>
#include <umbral/transforms/parametric_graph.hpp>

// Linked with the reference; what is expected is worked out by hand.

using namespace umbral;
using namespace umbral::transforms;

namespace {

/// Where the origin of each object that is drawn comes to lie.
std::vector<glm::vec3> origins(const GraphNode& node)
{
    RecordingPipeline drawn;
    node.draw(drawn);
    std::vector<glm::vec3> places;
    for (const Call& call : drawn.calls())
        if (call.kind == Call::Kind::primitive) places.emplace_back(call.modelview[3]);
    return places;
}

/// The place of a house's point, the first object that a facade draws.
glm::vec3 seen(const FacadeGraph& facade, const glm::vec3& point)
{
    RecordingPipeline drawn;
    facade.root->draw(drawn);
    for (const Call& call : drawn.calls())
        if (call.kind == Call::Kind::primitive) return glm::vec3(call.modelview * glm::dvec4(point, 1));
    return glm::vec3(NAN);
}

}

TEST(ParametricGraph, what_is_written_through_a_pointer_is_drawn)
{
    const auto node = make_graph_node();
    const std::size_t index = node->add_transformation(move(1, 0));
    glm::mat4* const matrix = node->matrix_at(index);
    for (int i = 0; i < 1000; ++i) node->add_transformation(glm::mat4(1));
    node->add_object(numbered(1));
    EXPECT_EQ(origins(*node), std::vector{glm::vec3(1, 0, 0)});
    *matrix = move(5, 6);
    EXPECT_EQ(origins(*node), std::vector{glm::vec3(5, 6, 0)});
    EXPECT_EQ(node->matrix_at(index), matrix);
}

TEST(ParametricGraph, a_shared_node_is_changed_everywhere)
{
    const std::shared_ptr<GraphNode> inner = make_graph_node();
    const auto outer = make_graph_node();
    inner->add_transformation(glm::mat4(1));
    inner->add_object(numbered(1));
    outer->add_object(inner);
    outer->add_transformation(move(10, 0));
    outer->add_object(inner);
    *inner->matrix_at(0) = move(0, 1);
    EXPECT_EQ(origins(*outer), (std::vector{glm::vec3(0, 1, 0), glm::vec3(10, 1, 0)}));
}

TEST(ParametricGraph, what_is_refused_changes_nothing)
{
    const auto node = make_graph_node();
    node->add_object(numbered(1));
    EXPECT_THROW(node->add_object(nullptr), std::invalid_argument);
    EXPECT_THROW((void)node->matrix_at(0), std::invalid_argument);
    EXPECT_THROW((void)node->matrix_at(1), std::out_of_range);
    EXPECT_EQ(node->add_transformation(glm::mat4(1)), 1U);
}

TEST(ParametricGraph, an_exception_leaves_the_stack_as_it_was)
{
    const std::shared_ptr<GraphNode> inner = make_graph_node();
    const auto outer = make_graph_node();
    inner->add_transformation(move(1, 2));
    inner->add_object(painted([](Pipeline&) { throw Torn(); }));
    outer->add_transformation(move(3, 4));
    outer->add_object(inner);
    RecordingPipeline drawn({.depth = 2});
    EXPECT_THROW(outer->draw(drawn), Torn);
    EXPECT_EQ(drawn.depth(), 2U);
    EXPECT_EQ(drawn.modelview(), glm::dmat4(1));
}

TEST(ParametricGraph, the_facade_of_the_statement)
{
    const FacadeGraph facade = make_facade(numbered_facade(), 3, 1.57079633F);
    const glm::vec3 tip = seen(facade, {0.5F, 1.5F, 0});
    EXPECT_NEAR(tip.x, -3, 1e-6);
    EXPECT_NEAR(tip.y, 0.5, 1e-6);
    set_facade_angle(facade, 0);
    set_facade_height(facade, 1.5F);
    const std::vector<glm::vec3> places = origins(*facade.root);
    const glm::vec2 expected[] = {{0, 0}, {0.56F, 0}, {0.13F, 0.13F}, {0.13F, 0.56F}, {0.56F, 0.56F}};
    ASSERT_EQ(places.size(), std::size(expected));
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_LT(glm::distance(glm::vec2(places[i]), expected[i]), 1e-6F) << i;
}

TEST(ParametricGraph, one_limb_moves_arms_and_legs)
{
    const AndroidGraph android = make_android_graph(android_parts());
    const std::vector<glm::vec3> before = origins(*android.root);
    ASSERT_EQ(before.size(), 18U);
    *android.limb = move(0, -5);
    const std::vector<glm::vec3> after = origins(*android.root);
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_LT(glm::distance(after[i], before[i] - glm::vec3(0, i < 6 ? 0 : 5, 0)), 1e-6F) << i;
}

TEST(ParametricGraph, a_graph_lets_go_of_its_objects)
{
    const AndroidParts parts = android_parts();
    const FacadeParts facade_parts = numbered_facade();
    {
        const AndroidGraph android = make_android_graph(parts);
        const FacadeGraph facade = make_facade(facade_parts, 1, 1);
        EXPECT_GT(parts.cylinder.use_count(), 1);
    }
    EXPECT_EQ(parts.cylinder.use_count(), 1);
    EXPECT_EQ(parts.half_sphere.use_count(), 1);
    EXPECT_EQ(facade_parts.window.use_count(), 1);
}
