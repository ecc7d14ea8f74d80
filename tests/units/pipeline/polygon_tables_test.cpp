#include <gtest/gtest.h>

#include <numbers>
#include <umbral/pipeline/polygon.hpp>

using namespace umbral::pipeline;

namespace {

constexpr auto pi = std::numbers::pi_v<long double>;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// A multiple of a turn's share, so that the expectation is not the reference's own product 2πi/n.
glm::dvec2 exact_corner(std::uint32_t i, std::uint32_t n)
{
    const long double turn = static_cast<long double>(i) / static_cast<long double>(n);
    return {static_cast<double>(std::cos(2 * pi * turn)), static_cast<double>(std::sin(2 * pi * turn))};
}

}

TEST(PolygonTables, worked_number_of_the_statement)
{
    const std::vector<glm::vec2> hexagon = polygon_loop(6);
    ASSERT_EQ(hexagon.size(), 6U);
    EXPECT_EQ(hexagon[0], glm::vec2(1, 0));
    EXPECT_FLOAT_EQ(hexagon[1].x, 0.5F);
    EXPECT_FLOAT_EQ(hexagon[1].y, 0.8660254F);
    const IndexedPolygon fan = polygon_fan(6);
    EXPECT_EQ(fan.positions.size(), 7U);
    EXPECT_EQ(fan.positions.back(), glm::vec2(0));
    EXPECT_EQ(fan.edges.size(), 12U);
    EXPECT_EQ(fan.triangles.back(), glm::uvec3(6, 5, 0));
}

TEST(PolygonTables, fewer_than_three_sides_are_no_polygon)
{
    for (const std::uint32_t sides : {0U, 1U, 2U}) {
        EXPECT_TRUE(polygon_loop(sides).empty());
        EXPECT_TRUE(polygon_segments(sides).empty());
        const IndexedPolygon fan = polygon_fan(sides);
        EXPECT_TRUE(fan.positions.empty() && fan.triangles.empty() && fan.edges.empty());
    }
}

// The header's guarantee.
TEST(PolygonTables, coordinates_are_off_by_half_a_unit_in_the_last_place)
{
    for (const std::uint32_t sides : {3U, 4U, 5U, 7U, 12U, 100U, 9973U, 1'000'000U}) {
        const std::vector<glm::vec2> corners = polygon_loop(sides);
        ASSERT_EQ(corners.size(), sides);
        double worst = 0;
        for (std::uint32_t i = 0; i < sides; ++i)
            for (int axis = 0; axis < 2; ++axis)
                worst = std::max(worst, std::abs(double{corners[i][axis]} - exact_corner(i, sides)[axis]));
        EXPECT_LT(worst, 3.0e-8) << sides << " sides";
    }
}

// Area (n/2) sin(2π/n): 1.299038 for a triangle, 2.377641 for a pentagon, 2.736410 for a heptagon. Every triangle has
// its share of it, and front is counter-clockwise.
TEST(PolygonTables, triangles_are_equal_and_counter_clockwise)
{
    for (const auto& [sides, area] : {std::pair{3U, 1.299038}, {5U, 2.377641}, {7U, 2.736410}, {100U, 3.139526}}) {
        const IndexedPolygon fan = polygon_fan(sides);
        ASSERT_EQ(fan.triangles.size(), sides);
        double sum = 0;
        for (const glm::uvec3& t : fan.triangles) {
            const glm::dvec2 a(fan.positions.at(t.x));
            const double part =
                0.5 * cross(glm::dvec2(fan.positions.at(t.y)) - a, glm::dvec2(fan.positions.at(t.z)) - a);
            EXPECT_NEAR(part, area / sides, 1e-6);
            sum += part;
        }
        EXPECT_NEAR(sum, area, 1e-6);
    }
}

// Each edge once, and as many as Euler asks for: V - E + F = 1 for a disc.
TEST(PolygonTables, edges_are_those_of_the_triangles)
{
    for (const std::uint32_t sides : {3U, 4U, 17U}) {
        const IndexedPolygon fan = polygon_fan(sides);
        std::set<std::pair<std::uint32_t, std::uint32_t>> listed;
        std::set<std::pair<std::uint32_t, std::uint32_t>> needed;
        for (const glm::uvec2& e : fan.edges)
            EXPECT_TRUE(listed.insert(std::minmax(e.x, e.y)).second) << "twice: " << e.x << ' ' << e.y;
        for (const glm::uvec3& t : fan.triangles)
            for (int i = 0; i < 3; ++i) needed.insert(std::minmax(t[i], t[(i + 1) % 3]));
        EXPECT_EQ(listed, needed);
        EXPECT_EQ(fan.positions.size() - fan.edges.size() + fan.triangles.size(), 1U);
    }
}

TEST(PolygonTables, segments_join_exactly)
{
    for (const std::uint32_t sides : {3U, 7U, 1000U, 99'991U}) {
        const std::vector<glm::vec2> corners = polygon_loop(sides);
        const std::vector<glm::vec2> ends = polygon_segments(sides);
        ASSERT_EQ(ends.size(), 2 * corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            ASSERT_EQ(ends[2 * i], corners[i]);
            ASSERT_EQ(ends[2 * i + 1], corners[(i + 1) % corners.size()]);
        }
    }
}

// The statement's table: what the other ways to the same corners cost. The reference's row is the test of its guarantee
// above.
TEST(PolygonTables, table_of_the_statement)
{
    struct Column {
        std::uint32_t sides;
        double added_up, turned, anew;
    };
    for (const auto& [sides, added_up, turned, anew] : {Column{100, 2e-6, 5e-7, 6e-7},
                                                        {1000, 6e-5, 8e-6, 6e-7},
                                                        {10'000, 3e-4, 1e-4, 6e-7},
                                                        {100'000, 7e-3, 2e-4, 7e-7}}) {
        const float step = 2 * std::numbers::pi_v<float> / static_cast<float>(sides);
        const glm::mat2 turn(std::cos(step), std::sin(step), -std::sin(step), std::cos(step));
        float sum = 0;
        glm::vec2 place(1, 0);
        glm::dvec3 worst(0);
        for (std::uint32_t i = 0; i < sides; ++i) {
            const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(sides);
            const glm::vec2 corners[] = {{std::cos(sum), std::sin(sum)}, place, {std::cos(angle), std::sin(angle)}};
            for (int way = 0; way < 3; ++way)
                for (int axis = 0; axis < 2; ++axis)
                    worst[way] =
                        std::max(worst[way], std::abs(double{corners[way][axis]} - exact_corner(i, sides)[axis]));
            sum += step;
            place = turn * place;
        }
        // One digit is printed; libraries' sines differ in the last place.
        EXPECT_NEAR(worst[0], added_up, 0.3 * added_up) << sides;
        EXPECT_NEAR(worst[1], turned, 0.4 * turned) << sides;
        EXPECT_NEAR(worst[2], anew, 0.2 * anew) << sides;
    }
}
