#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/raytracing/transparent_z_buffer.hpp>

// Both algorithms against a fold over whole permutations in double, and the course's laws.
namespace umbral::raytracing {
namespace {

constexpr std::uint64_t seed = 20260111;

GlassFragment random_sheet(Random& random, int width)
{
    GlassFragment sheet;
    sheet.pixel = {static_cast<int>(random.below(static_cast<std::uint32_t>(width))), 0};
    sheet.depth = random.uniform(0, 2);
    sheet.light = glm::vec3(1) + random.in_cube();
    sheet.k_t = random.uniform();
    sheet.m_t = 0.5F * (glm::vec3(1) + random.in_cube());
    return sheet;
}

// What is left when the farthest visible sheet is taken again and again, in double.
glm::dvec3 folded(const GlassFrame& before, std::vector<GlassFragment> sheets, int pixel)
{
    glm::dvec3 light(before.light.at(pixel, 0));
    for (;;) {
        std::ptrdiff_t farthest = -1;
        for (std::size_t i = 0; i < sheets.size(); ++i)
            if (sheets[i].pixel.x == pixel && sheets[i].depth < before.depths.at(pixel, 0) &&
                (farthest < 0 || sheets[i].depth > sheets[static_cast<std::size_t>(farthest)].depth))
                farthest = static_cast<std::ptrdiff_t>(i);
        if (farthest < 0) return light;
        const GlassFragment sheet = sheets[static_cast<std::size_t>(farthest)];
        light = glm::dvec3(sheet.light) + double{sheet.k_t} * glm::dvec3(sheet.m_t) * light;
        sheets.erase(sheets.begin() + farthest);
    }
}

TEST(TransparentZBuffer, blended_light_is_the_exact_sum_but_for_two_ulp_a_fragment)
{
    RecordProperty("seed", static_cast<int>(seed));
    Random random(seed);
    for (int round = 0; round < 200; ++round) {
        GlassFrame frame = empty_glass_frame(3, 1, {1, 2, 0.5F});
        draw_opaque(frame, {{{1, 0}, 1, {3, 1, 2}}});
        std::vector<GlassFragment> sheets;
        for (int i = 0; i < 30; ++i) sheets.push_back(random_sheet(random, 3));
        const GlassFrame before = frame;
        blend_glass(frame, sheets);
        for (int pixel = 0; pixel < 3; ++pixel) {
            const glm::dvec3 expected = folded(before, sheets, pixel);
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(double{frame.light.at(pixel, 0)[i]}, expected[i], 2 * 30 * 6e-8 * expected[i])
                    << "seed " << seed << ", round " << round;
            EXPECT_EQ(frame.depths.at(pixel, 0), before.depths.at(pixel, 0));
        }
    }
}

TEST(TransparentZBuffer, the_first_algorithm_does_not_depend_on_the_order_and_the_second_does)
{
    Random random(seed + 1);
    std::vector<GlassFragment> sheets;
    for (int i = 0; i < 6; ++i) sheets.push_back(random_sheet(random, 1));
    GlassFrame forwards = empty_glass_frame(1, 1, glm::vec3(1));
    GlassFrame backwards = forwards;
    filter_glass(forwards, sheets);
    filter_glass(backwards, {sheets.rbegin(), sheets.rend()});
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(forwards.light.at(0, 0)[i], backwards.light.at(0, 0)[i], 1e-6F * forwards.light.at(0, 0)[i]);
    // Exchanging the depths of two sheets is another scene.
    GlassFrame one = empty_glass_frame(1, 1, glm::vec3(1));
    GlassFrame other = one;
    blend_glass(one, sheets);
    std::swap(sheets[0].depth, sheets[1].depth);
    blend_glass(other, sheets);
    EXPECT_GT(distance(one.light.at(0, 0), other.light.at(0, 0)), 1e-3F);
}

TEST(TransparentZBuffer, the_statements_example_comes_out_exactly)
{
    GlassFrame frame = empty_glass_frame(1, 1, glm::vec3(1));
    const GlassFragment far{{0, 0}, 2, {0, 0, 0.25F}, 0.5F, {1, 0, 0.5F}};
    const GlassFragment near{{0, 0}, 1, {0.125F, 0, 0}, 1, {0.5F, 0.5F, 1}};
    blend_glass(frame, {near, far});
    EXPECT_EQ(frame.light.at(0, 0), glm::vec3(0.375F, 0, 0.5F));
    frame.light.at(0, 0) = glm::vec3(1);
    filter_glass(frame, {near, far});
    EXPECT_EQ(frame.light.at(0, 0), glm::vec3(0.25F, 0, 0.25F));
}

TEST(TransparentZBuffer, what_is_beside_the_frame_or_no_number_is_passed_over)
{
    GlassFrame frame = empty_glass_frame(2, 1, glm::vec3(1));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<GlassFragment> sheets = {{{-1, 0}, 0, glm::vec3(1), 0.5F, glm::vec3(1)},
                                               {{0, 1}, 0, glm::vec3(1), 0.5F, glm::vec3(1)},
                                               {{2, 0}, 0, glm::vec3(1), 0.5F, glm::vec3(1)},
                                               {{0, 0}, nan, glm::vec3(1), 0.5F, glm::vec3(1)}};
    blend_glass(frame, sheets);
    filter_glass(frame, sheets);
    draw_opaque(frame, {{{0, -1}, 0, glm::vec3(9)}, {{1, 0}, nan, glm::vec3(9)}});
    for (int pixel = 0; pixel < 2; ++pixel) {
        EXPECT_EQ(frame.light.at(pixel, 0), glm::vec3(1));
        EXPECT_TRUE(std::isinf(frame.depths.at(pixel, 0)));
    }
}

}
}
