#include <gtest/gtest.h>

#include <numbers>
#include <transforms/matrix-stack/sessions.hpp>
#include <transforms/recording_pipeline.hpp>
#include <umbral/transforms/android.hpp>
#include <umbral/transforms/hook.hpp>
#include <umbral/transforms/matrix_stack.hpp>
#include <umbral/transforms/tree.hpp>

// What the references draw, against numbers that were computed in another way.

using namespace umbral;
using namespace umbral::transforms;

namespace {

std::vector<Call> drawn_by(const Figure& draw)
{
    RecordingPipeline pipeline;
    draw(pipeline);
    EXPECT_EQ(pipeline.depth(), 0U);
    EXPECT_EQ(pipeline.modelview(), glm::dmat4(1));
    EXPECT_EQ(pipeline.color(), glm::vec3(1));
    std::vector<Call> drawn;
    for (const Call& call : pipeline.calls())
        if (call.kind != Call::Kind::push && call.kind != Call::Kind::pop) drawn.push_back(call);
    return drawn;
}

/// The matrices of a drawing function's copies of a figure.
template <class Draw>
std::vector<glm::dmat4> copies(Draw draw)
{
    RecordingPipeline pipeline;
    draw(pipeline, pipeline.marker());
    std::vector<glm::dmat4> matrices;
    for (const Call& call : pipeline.calls())
        if (call.kind == Call::Kind::figure) matrices.push_back(call.modelview);
    return matrices;
}

void expect_at(const glm::dmat4& matrix, glm::dvec2 place, glm::dvec2 expected, double tolerance = 1e-6)
{
    const glm::dvec4 there = matrix * glm::dvec4(place, 0, 1);
    EXPECT_NEAR(there.x, expected.x, tolerance);
    EXPECT_NEAR(there.y, expected.y, tolerance);
    EXPECT_EQ(there.z, 0);
}

}

// Normals stay at right angles to the surface: a tangent and a normal before are so afterwards, and n points to the
// same side.
TEST(MatrixStack, keeps_normals_across_the_surface)
{
    constexpr std::uint64_t seed = 20240607;
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
        const std::unique_ptr<MatrixStack> stack = make_matrix_stack();
        stack->set_view(random_map(random));
        for (int k = 0; k < 4; ++k) stack->compose(random_map(random));
        const glm::dvec3 normal(random.unit_vector());
        const glm::dvec3 tangent = cross(normal, glm::dvec3(random.unit_vector()));
        const glm::dmat3 m(glm::mat3(stack->modelview()));
        const glm::dvec3 seen = normalize(glm::dmat3(stack->normal_matrix()) * normal);
        EXPECT_NEAR(dot(seen, normalize(m * tangent)), 0, 1e-5);
        EXPECT_GT(dot(seen, m * normal), 0);
    }
}

TEST(MatrixStack, is_as_it_was_after_an_empty_pop)
{
    const std::unique_ptr<MatrixStack> stack = make_matrix_stack();
    stack->compose(quarter_turn(1));
    EXPECT_THROW(stack->pop(), EmptyStack);
    EXPECT_EQ(stack->modelview(), quarter_turn(1));
}

TEST(ComplexFigure, has_its_corners_in_their_places)
{
    const std::vector<glm::dmat4> three = copies(draw_complex_figure);
    ASSERT_EQ(three.size(), 3U);
    expect_at(three[1], {0, 0}, {2, 2});
    expect_at(three[1], {1, 0}, {3, 1});
    expect_at(three[1], {0, 1}, {1, 1});
    expect_at(three[2], {0, 0}, {3, 1});
    expect_at(three[2], {1, 1}, {5, 0});
}

// The pinwheel of the course: 16 corners in this order.
TEST(FourHooks, close_the_pinwheel)
{
    constexpr glm::dvec2 corners[] = {{0, 0},  {1, 0},  {1, 1},  {0, 1},  {0, 2},   {0, 3},   {-1, 3}, {-1, 2}, {-2, 2},
                                      {-3, 2}, {-3, 1}, {-2, 1}, {-2, 0}, {-2, -1}, {-1, -1}, {-1, 0}, {0, 0}};
    constexpr glm::dvec2 hook[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}};
    const std::vector<glm::dmat4> four = copies(draw_four_hooks);
    ASSERT_EQ(four.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 5; ++k) expect_at(four[i], hook[k], corners[4 * i + k]);
}

TEST(HookBetween, both_ways_meet_both_ends)
{
    constexpr std::uint64_t seed = 20240608;
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 from(glm::vec2(random.in_cube()), 1);
        const glm::vec3 to = i % 10 == 0 ? from : glm::vec3(glm::vec2(random.in_cube()), 1);
        const std::vector<glm::dmat4> one =
            copies([&](Pipeline& pipeline, const Figure& hook) { draw_hook_between(pipeline, hook, from, to); });
        ASSERT_EQ(one.size(), 1U);
        for (const glm::dmat4& matrix : {one[0], glm::dmat4(hook_matrix(from, to))}) {
            expect_at(matrix, {0, 0}, glm::dvec2(from));
            expect_at(matrix, {0, 2}, glm::dvec2(to));
            EXPECT_GE(determinant(glm::dmat2(matrix)), 0);
        }
    }
}

// The radius that the course's figures reach, by the law of cosines.
TEST(HookCircle, turns_its_teeth_outwards)
{
    for (const unsigned count : {5U, 8U, 13U}) {
        double reach = 0;
        for (const glm::dmat4& matrix :
             copies([&](Pipeline&pipeline, const Figure&hook) { draw_hook_circle(pipeline, hook, count); }))
            reach = std::max({reach, glm::length(glm::dvec2(matrix * glm::dvec4(1, 0, 0, 1))),
                              glm::length(glm::dvec2(matrix * glm::dvec4(1, 1, 0, 1)))});
        const double half = std::sin(std::numbers::pi / count);
        EXPECT_NEAR(reach, std::hypot(half, std::cos(std::numbers::pi / count) + half), 1e-6);
    }
}

TEST(Trunk, has_its_area_and_six_edges)
{
    double area = 0;
    std::size_t edges = 0;
    for (const Call& call : drawn_by(draw_trunk)) {
        if (call.kind == Call::Kind::polyline) edges += call.places.size() - 1;
        for (std::size_t i = 0; call.kind == Call::Kind::triangles && i + 2 < call.places.size(); i += 3) {
            const glm::dvec2 a = call.places[i + 1] - call.places[i];
            const glm::dvec2 b = call.places[i + 2] - call.places[i];
            area += 0.5 * std::abs(a.x * b.y - a.y * b.x);
        }
    }
    EXPECT_EQ(area, 3.125);
    EXPECT_EQ(edges, 6U);
}

TEST(Tree, has_its_bounds_and_its_number_of_trunks)
{
    for (const unsigned levels : {0U, 1U, 2U, 6U, 10U}) {
        const std::vector<glm::dmat4> trunks =
            copies([&](Pipeline& pipeline, const Figure& trunk) { draw_tree(pipeline, levels, trunk); });
        EXPECT_EQ(trunks.size(), (std::size_t{1} << levels) - 1);
        glm::dvec2 low(1e9);
        glm::dvec2 high(-1e9);
        for (const glm::dmat4& matrix : trunks) {
            for (const glm::vec2& corner : trunk_polygon) {
                const glm::dvec2 place(matrix * glm::dvec4(corner, 0, 1));
                low = glm::min(low, place);
                high = glm::max(high, place);
            }
        }
        if (levels != 6) continue;
        EXPECT_EQ(low, glm::dvec2(-0.984375, 0));
        EXPECT_EQ(high, glm::dvec2(6.3125, 5.90625));
    }
}

TEST(Android, is_mirrored_at_rest_and_keeps_its_joints)
{
    const std::unique_ptr<Android> android = make_android();
    const auto draw = [&](Pipeline& pipeline) { android->draw(pipeline); };
    const std::vector<Call> rest = drawn_by(draw);
    ASSERT_EQ(rest.size(), 18U);
    constexpr std::size_t pairs[][2] = {{2, 3}, {4, 5}, {6, 9}, {7, 10}, {8, 11}, {12, 15}, {13, 16}, {14, 17}};
    for (const auto& [left, right] : pairs) {
        const glm::dvec4& a = rest[left].modelview[3];
        const glm::dvec4& b = rest[right].modelview[3];
        EXPECT_EQ(glm::dvec4(-a.x, a.y, a.z, 1), b);
        EXPECT_GT(a.x, 0);
    }
    for (const double angle : {0.7, -2.0, 400 * std::numbers::pi}) {
        android->set_left_arm(angle);
        android->set_head(angle);
        const std::vector<Call> posed = drawn_by(draw);
        ASSERT_EQ(posed.size(), 18U);
        for (const std::size_t fixed : {0, 1, 6, 9, 10, 11, 12, 15})
            EXPECT_EQ(posed[fixed].modelview[3], rest[fixed].modelview[3]) << fixed;
        const double lifted = android_measures::shoulder.y - android_measures::limb_length * std::cos(angle);
        EXPECT_NEAR(posed[8].modelview[3].y, lifted, 1e-6);
    }
}
