#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>
#include <umbral/transforms/affinity.hpp>
#include <vector>

// Linked with the reference. What is expected is known: points and maps are such that no image is rounded.

using namespace umbral;
using namespace umbral::transforms;

namespace {

constexpr std::uint64_t seed = 20291;

/// Whole numbers from -3 to 3.
glm::mat4 whole_map(Random& random)
{
    glm::mat4 map(1);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) map[column][row] = static_cast<float>(random.below(7)) - 3;
    return map;
}

/// Whole numbers up to 15, the last coordinate times `thin`: no three of the first four points in a line.
std::vector<glm::vec3> whole_points(Random& random, std::size_t more, float thin)
{
    std::vector<glm::vec3> points = {{0, 0, 0}, {15, 1, 0}, {-2, 14, 0}, {3, 4, thin}};
    const auto whole = [&] { return static_cast<float>(random.below(31)) - 15; };
    for (std::size_t i = 0; i < more; ++i) {
        const float x = whole();
        const float y = whole();
        points.emplace_back(x, y, thin * static_cast<float>(random.below(3)));
    }
    return points;
}

std::vector<PointPair> mapped(const std::vector<glm::vec3>& points, const glm::mat4& map)
{
    std::vector<PointPair> pairs;
    for (const glm::vec3& point : points) pairs.push_back({point, glm::vec3(map * glm::vec4(point, 1))});
    return pairs;
}

double worst_entry(const glm::mat4& a, const glm::mat4& b)
{
    double worst = 0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            worst = std::max(worst, std::abs(double{a[column][row]} - double{b[column][row]}));
    return worst;
}

}

TEST(Affinity, maps_come_back_also_from_thin_layers)
{
    Random random(seed);
    for (const float thin : {1.0F, 0x1p-8F, 0x1p-16F}) {
        for (int i = 0; i < 1000; ++i) {
            const glm::mat4 map = whole_map(random);
            const auto found = affine_from_points(mapped(whole_points(random, random.below(5), thin), map));
            ASSERT_TRUE(found);
            ASSERT_LE(worst_entry(*found, map), 6e-7) << "thickness " << thin << ", map " << i;
        }
    }
}

TEST(Affinity, all_sizes_and_places)
{
    Random random(seed + 1);
    const std::vector<glm::vec3> points = whole_points(random, 3, 1);
    for (const float size : {0x1p-30F, 1.0F, 0x1p30F}) {
        std::vector<glm::vec3> scaled;
        for (const glm::vec3& point : points) scaled.push_back(size * point);
        glm::mat4 map = whole_map(random);
        map[3] = {0, 0, 0, 1};
        const auto found = affine_from_points(mapped(scaled, map));
        ASSERT_TRUE(found);
        EXPECT_LE(worst_entry(*found, map), 6e-7 * std::max(1.0F, 16 * size));
    }
}

TEST(Affinity, points_in_a_plane_or_too_few_determine_nothing)
{
    Random random(seed + 2);
    EXPECT_FALSE(affine_from_points({}));
    EXPECT_FALSE(is_affine({}, 1));
    for (const float size : {0x1p-20F, 1.0F, 0x1p20F}) {
        std::vector<glm::vec3> flat = whole_points(random, 4, 0);
        for (glm::vec3& point : flat) point = size * glm::vec3(point.x, point.y, 2 * point.x - point.y + 7);
        EXPECT_FALSE(affine_from_points(mapped(flat, glm::mat4(1)))) << size;
        flat.back().z += size;
        EXPECT_TRUE(affine_from_points(mapped(flat, glm::mat4(1)))) << size;
    }
}

// What least squares means: no small change of the map makes the sum of the squares smaller.
TEST(Affinity, of_many_points_no_other_map_misses_less)
{
    Random random(seed + 3);
    const auto sum_of_squares = [](const std::vector<PointPair>& pairs, const glm::dmat4& map) {
        double sum = 0;
        for (const PointPair& pair : pairs) {
            const glm::dvec3 missed = glm::dvec3(map * glm::dvec4(pair.point, 1)) - glm::dvec3(pair.image);
            sum += glm::dot(missed, missed);
        }
        return sum;
    };
    for (int i = 0; i < 200; ++i) {
        std::vector<PointPair> pairs = mapped(whole_points(random, 6, 5), whole_map(random));
        for (PointPair& pair : pairs) pair.image += random.in_cube();
        const glm::dmat4 found(affine_from_points(pairs).value());
        const double least = sum_of_squares(pairs, found);
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 3; ++row) {
                for (const double step : {-1e-3, 1e-3}) {
                    glm::dmat4 other = found;
                    other[column][row] += step;
                    ASSERT_GT(sum_of_squares(pairs, other), least) << "points " << i;
                }
            }
        }
    }
}

TEST(Affinity, parallelograms_and_one_image_that_moves_away)
{
    EXPECT_EQ(parallelogram_defect({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}), glm::vec3(0));
    EXPECT_EQ(parallelogram_defect({{{1, 1, 1}, {2, 0, 0}, {0, 3, 0}, {5, 5, 5}}}), glm::vec3(4, 3, 6));
    Random random(seed + 4);
    std::vector<PointPair> bent = mapped(whole_points(random, 5, 4), glm::mat4(1));
    EXPECT_TRUE(is_affine(bent, 1e-6F));
    bent.back().image.y += 5;
    EXPECT_FALSE(is_affine(bent, 1e-2F));
    EXPECT_TRUE(is_affine(bent, 1));
}
