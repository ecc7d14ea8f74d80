#include <gtest/gtest.h>

#include <raytracing/bounding-volumes/box_shots.hpp>
#include <raytracing/bounding-volumes/soups.hpp>

using namespace umbral;
using namespace umbral::raytracing;

namespace {

// A loop over all triangles: no tree can do better than agree with it.
std::optional<FirstTriangle> by_a_loop(const Soup& soup, const Ray& ray)
{
    std::optional<FirstTriangle> best;
    for (std::uint32_t i = 0; i < soup.size(); ++i)
        if (const auto hit = intersect(ray, soup[i]); hit && (!best || hit->t < best->hit.t)) best = {i, *hit};
    return best;
}

std::string text_of(const std::optional<FirstTriangle>& first)
{
    return first ? std::to_string(first->index) + " at " + std::to_string(first->hit.t) : "nothing";
}

void expect_the_loops_answers(const Soup& soup, Random& random, int rays, float distance, const std::string& what)
{
    const auto hierarchy = make_triangle_hierarchy(soup);
    for (int i = 0; i < rays; ++i) {
        const Ray ray = ray_into(soup, distance, random);
        const auto got = hierarchy->first_hit(ray);
        const auto expected = by_a_loop(soup, ray);
        ASSERT_EQ(text_of(got), text_of(expected)) << what << ", ray " << i;
        if (got) {
            ASSERT_EQ(got->hit.a, expected->hit.a);
            ASSERT_EQ(got->hit.b, expected->hit.b);
        }
    }
}

}

TEST(BoundingVolumes, answers_are_those_of_a_loop_to_the_bit)
{
    constexpr std::uint64_t seed = 62001;
    Random random(seed);
    for (int round = 0; round < 60; ++round) {
        const int count = static_cast<int>(random.below(400));
        const Soup soup = random_soup(random, count, random.uniform(0.1F, 3));
        expect_the_loops_answers(soup, random, 100, random.uniform(0, 12),
                                 "seed " + std::to_string(seed) + ", soup " + std::to_string(round));
    }
}

TEST(BoundingVolumes, answers_are_those_of_a_loop_for_odd_triangles)
{
    constexpr std::uint64_t seed = 62002;
    Random random(seed);
    expect_the_loops_answers(shells(700, random), random, 500, 900, "shells");
    expect_the_loops_answers(Soup(500, random_soup(random, 1, 3).front()), random, 100, 9, "equal triangles");
    expect_the_loops_answers(row_of_powers(100, random), random, 500, 9, "row of powers");
    expect_the_loops_answers(needles(2000, random), random, 500, 9, "needles");
    expect_the_loops_answers(with_points_and_twins(random, 200), random, 500, 9, "twins");
    expect_the_loops_answers(floor_of_tiles(20), random, 500, 20, "floor");
    expect_the_loops_answers(hilly_ball(14, random), random, 500, 4, "ball");
}

// From inside a closed body every ray hits something; aimed at corners and edges it does so only if no box is too
// small by a rounding.
TEST(BoundingVolumes, no_ray_leaves_a_closed_body)
{
    constexpr std::uint64_t seed = 62003;
    Random random(seed);
    for (const float away : {0.0F, 100.0F, 1e4F, 1e6F}) {
        Soup soup = triangles_of(shapes::box());
        for (Triangle& triangle : soup)
            for (glm::vec3* corner : {&triangle.v0, &triangle.v1, &triangle.v2}) *corner += away * glm::vec3(1, -2, 3);
        const auto hierarchy = make_triangle_hierarchy(soup);
        const glm::vec3 middle = away * glm::vec3(1, -2, 3) + 0.5F;
        for (int i = 0; i < 20'000; ++i) {
            const Triangle& triangle = soup[random.below(12)];
            const glm::vec3 target =
                i % 2 == 0 ? triangle.v0 : triangle.v0 + random.uniform() * (triangle.v1 - triangle.v0);
            ASSERT_TRUE(hierarchy->first_hit({middle, target - middle}).has_value())
                << "seed " << seed << ", away " << away << ", ray " << i;
        }
    }
}

// Flat, so that each box begins at its tiles' t; where t was rounded down, beyond it.
TEST(BoundingVolumes, of_triangles_at_one_rounded_t_the_least_index_counts)
{
    constexpr std::uint64_t seed = 62008;
    Random random(seed);
    Soup tiles = floor_of_tiles(8);
    tiles.insert(tiles.end(), tiles.begin(), tiles.end());
    tiles = in_random_order(random, std::move(tiles));
    const auto hierarchy = make_triangle_hierarchy(tiles);
    for (int i = 0; i < 5000; ++i) {
        const glm::vec2 place(static_cast<float>(random.below(16)) / 2, static_cast<float>(random.below(16)) / 2);
        const Ray ray{{place, random.uniform(1, 9)}, {0, 0, -random.uniform(0.25F, 3)}};
        ASSERT_EQ(text_of(hierarchy->first_hit(ray)), text_of(by_a_loop(tiles, ray)))
            << "seed " << seed << ", ray " << i;
    }
}

// Boxes of no thickness that hold a point of the ray exactly: small whole numbers, with t a power of two.
TEST(BoundingVolumes, a_box_that_holds_a_point_of_the_ray_is_met)
{
    constexpr std::uint64_t seed = 62004;
    Random random(seed);
    const auto whole = [&] { return glm::floor(1000.0F * random.in_cube()); };
    for (int i = 0; i < 100'000; ++i) {
        const Ray ray{whole(), whole()};
        const glm::vec3 point = ray.origin + std::exp2(static_cast<float>(random.below(6)) - 2) * ray.direction;
        glm::vec3 low = point;
        if (i % 2 == 0) low[static_cast<int>(random.below(3))] -= 1;
        ASSERT_TRUE(meets_box(ray, {low, point})) << "seed " << seed << ", box " << i;
    }
}

// Points of a fine comb along the ray against the box: another way to the same answer.
TEST(BoundingVolumes, boxes_are_met_where_a_point_of_the_ray_lies_in_them)
{
    constexpr std::uint64_t seed = 62005;
    Random random(seed);
    std::vector<BoxShot> shots;
    for (int i = 0; i < 300; ++i) add_box_pair(shots, i, random);
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const auto& [ray, box] = shots[i];
        const double whole = 20 / length(glm::dvec3(ray.direction));
        bool inside = false;
        for (int step = 0; step <= 40'000; ++step) {
            const double t = whole * step / 40'000;
            if (t < double{ray.t_min} || t > double{ray.t_max}) continue;
            const glm::dvec3 p = glm::dvec3(ray.origin) + t * glm::dvec3(ray.direction);
            inside = inside ||
                     (all(greaterThanEqual(p, glm::dvec3(box.low))) && all(lessThanEqual(p, glm::dvec3(box.high))));
        }
        ASSERT_EQ(meets_box(ray, box), inside) << "seed " << seed << ", box " << i;
    }
}

TEST(BoundingVolumes, no_triangles_have_an_empty_box_and_no_hits)
{
    const BoundingBox box = bounding_box({});
    EXPECT_EQ(box.low, glm::vec3(endless));
    EXPECT_EQ(box.high, glm::vec3(-endless));
    EXPECT_FALSE(meets_box({}, box));
    EXPECT_FALSE(make_triangle_hierarchy({})->first_hit({}).has_value());
}

TEST(BoundingVolumes, two_hundred_thousand_needles_are_built_and_asked_at_once)
{
    Random random(62006);
    expect_the_loops_answers(needles(200'000, random), random, 20, 9, "needles");
}

TEST(BoundingVolumeInputs, pairs_are_one_that_meets_and_one_that_does_not)
{
    Random random(62007);
    std::vector<BoxShot> shots;
    for (int i = 0; i < 2000; ++i) add_box_pair(shots, i, random);
    for (std::size_t i = 0; i < shots.size(); i += 2)
        ASSERT_NE(meets_box(shots[i].ray, shots[i].box), meets_box(shots[i + 1].ray, shots[i + 1].box))
            << "pair " << i / 2;
}

TEST(BoundingVolumeInputs, of_two_boxes_the_one_that_is_touched_is_met)
{
    Random random(62009);
    for (int i = 0; i < 100; ++i) {
        const std::vector<BoxShot> shots = touching(random);
        for (std::size_t k = 0; k < shots.size(); k += 2)
            ASSERT_NE(meets_box(shots[k].ray, shots[k].box), meets_box(shots[k + 1].ray, shots[k + 1].box))
                << "pair " << k / 2;
    }
}
