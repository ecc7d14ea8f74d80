#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/region.hpp>

using namespace umbral;
using namespace umbral::pipeline;

namespace {

constexpr std::uint64_t seed = 20261121;

Box random_box(Random& random, float away)
{
    Box box{away * random.in_cube(), {}};
    const float x = random.uniform(0.5F, 4);
    const float y = random.uniform(0.5F, 4);
    box.high = box.low + glm::vec3(x, y, random.uniform(0.5F, 4));
    return box;
}

glm::vec3 point_in(Random& random, const Box& box)
{
    return box.low + 0.5F * (random.in_cube() + 1.0F) * (box.high - box.low);
}

/// (2x - low - high) / (high - low) in 64 bits of mantissa: no product cancels.
glm::vec<3, long double> exact_ndc(const Box& box, const glm::vec3& point)
{
    glm::vec<3, long double> ndc(0);
    for (int axis = 0; axis < 3; ++axis) {
        const long double low = box.low[axis];
        const long double high = box.high[axis];
        ndc[axis] = (2 * static_cast<long double>(point[axis]) - low - high) / (high - low);
    }
    return ndc;
}

double worst(const glm::vec3& got, const glm::vec<3, long double>& exact)
{
    double error = 0;
    for (int axis = 0; axis < 3; ++axis)
        error = std::max(error, static_cast<double>(std::abs(static_cast<long double>(got[axis]) - exact[axis])));
    return error;
}

glm::vec3 with_centre_in_float(const Box& box, const glm::vec3& point)
{
    return 2.0F / (box.high - box.low) * (point - 0.5F * (box.low + box.high));
}

}

TEST(VisibleRegion, corners_go_to_corners)
{
    Random random(seed);
    for (int i = 0; i < 1000; ++i) {
        const Box box = random_box(random, 100);
        EXPECT_EQ(ndc_of(box, box.low), glm::vec3(-1)) << "seed " << seed << ", box " << i;
        EXPECT_EQ(ndc_of(box, box.high), glm::vec3(1)) << "seed " << seed << ", box " << i;
    }
}

// Also prints the table of the statement: half a picture of 512 pixels is an NDC of 1.
TEST(VisibleRegion, far_boxes)
{
    Random random(seed);
    std::puts("offset   matrix   centre   differences   (largest error in pixels of 512, 20,000 boxes of 0.5 to 4)");
    for (const float away : {1e1F, 1e3F, 1e4F, 1e5F, 1e6F}) {
        std::array<double, 3> errors{};
        for (int i = 0; i < 20000; ++i) {
            const Box box = random_box(random, away);
            const glm::vec3 point = point_in(random, box);
            const auto exact = exact_ndc(box, point);
            errors[0] = std::max(errors[0], worst(glm::vec3(projection_of(box) * glm::vec4(point, 1)), exact));
            errors[1] = std::max(errors[1], worst(with_centre_in_float(box, point), exact));
            errors[2] = std::max(errors[2], worst(ndc_of(box, point), exact));
        }
        std::printf("%6.0e %8.2g %8.2g %8.2g\n", static_cast<double>(away), 256 * errors[0], 256 * errors[1],
                    256 * errors[2]);
        EXPECT_LE(errors[2], 3e-7) << "seed " << seed << ", offset " << away;
    }
}

TEST(VisibleRegion, contains_the_contents_with_the_proportions_of_the_window)
{
    Random random(seed);
    for (int i = 0; i < 5000; ++i) {
        const Box contents = random_box(random, 5);
        const int width = 1 + static_cast<int>(random.below(3000));
        const int height = 1 + static_cast<int>(random.below(3000));
        const Box region = visible_region(contents, width, height);
        const glm::dvec3 size = glm::dvec3(region.high) - glm::dvec3(region.low);
        EXPECT_NEAR(size.x * height / (size.y * width), 1, 3e-6) << "seed " << seed << ", box " << i;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LE(region.low[axis], contents.low[axis]);
            EXPECT_GE(region.high[axis], contents.high[axis]);
        }
        const bool wider = region.low.x != contents.low.x || region.high.x != contents.high.x;
        const bool higher = region.low.y != contents.low.y || region.high.y != contents.high.y;
        EXPECT_FALSE(wider && higher) << "seed " << seed << ", box " << i;
    }
}

TEST(VisibleRegion, windows_without_pixels_and_contents_without_height)
{
    const Box contents{{1, 2, 3}, {5, 2, 4}};
    for (const glm::ivec2 size : {glm::ivec2(0, 0), glm::ivec2(640, 0), glm::ivec2(0, 480)}) {
        const Box region = visible_region(contents, size.x, size.y);
        EXPECT_EQ(region.low, contents.low);
        EXPECT_EQ(region.high, contents.high);
    }
    const Box region = visible_region(contents, 400, 200);
    EXPECT_EQ(region.low, glm::vec3(1, 1, 3));
    EXPECT_EQ(region.high, glm::vec3(5, 3, 4));
    EXPECT_EQ(projection_of({{1, 1, 1}, {1, 3, 2}})[0], glm::vec4(0));
}

TEST(VisibleRegion, mirrored_contents_stay_mirrored)
{
    const Box region = visible_region({{2, 0, 0}, {-2, 1, 1}}, 100, 100);
    EXPECT_EQ(region.low, glm::vec3(2, -1.5F, 0));
    EXPECT_EQ(region.high, glm::vec3(-2, 2.5F, 1));
}
