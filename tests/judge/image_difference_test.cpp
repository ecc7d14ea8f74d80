#include <gtest/gtest.h>

#include <limits>

#include "judge/picture/image_difference.hpp"
#include "make.hpp"

namespace umbral::grader::test {
namespace {

TEST(ImageDifference, nothing_where_nothing_differs)
{
    EXPECT_FALSE(worst_region(check_of(JudgeKind{"image"}), balls(), balls()));
    for (const std::uint8_t level : difference_map(check_of(JudgeKind{"image"}), balls(), balls()).cells)
        ASSERT_EQ(level, 0);
}

TEST(ImageDifference, finds_the_bounds_the_worst_window_and_the_peak)
{
    const Tensor wrong = repaint(balls(), [right = balls()](int x, int y) {
        Colour colour = pixel(right, x, y);
        if (x >= 100 && x < 104 && y >= 20 && y < 24) colour.g = 110;  // background: 10
        if (x == 102 && y == 22) colour.g = 210;
        if (x == 3 && y == 120) colour.g = 60;
        return colour;
    });
    const auto region = worst_region(check_of(JudgeKind{"image"}), wrong, balls());
    ASSERT_TRUE(region);
    EXPECT_EQ(region->bounds, (Window{3, 20, 101, 101}));
    EXPECT_EQ(region->peak_x, 102);
    EXPECT_EQ(region->peak_y, 22);
    EXPECT_LE(region->worst.x, 100);
    EXPECT_GE(region->worst.x + region->worst.width, 104);
    EXPECT_LE(region->worst.y, 20);
    EXPECT_GE(region->worst.y + region->worst.height, 24);
    EXPECT_EQ(region->worst.width, 32);
    EXPECT_EQ(difference_map(check_of(JudgeKind{"image"}), wrong, balls()).at(102, 22), 200);
}

TEST(ImageDifference, maps_ids_depths_and_what_is_not_finite)
{
    const auto ids = difference_map(check_of(JudgeKind{"buffer"}), grid(2, 1, {1, 5}), grid(2, 1, {1, 6}));
    EXPECT_EQ(ids.at(0, 0), 0);
    EXPECT_EQ(ids.at(1, 0), 255);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto depths =
        difference_map(check_of(JudgeKind{"buffer"}), depth(4, 1, {0, 0.6F, nan, 4}), depth(4, 1, {0, 0.2F, 2, 4}));
    EXPECT_EQ(depths.cells, (std::vector<std::uint8_t>{0, 26, 255, 0}));
    EXPECT_THROW((void)difference_map(check_of(JudgeKind{"buffer"}), depth(1, 1, {0}), grid(1, 1, {0})),
                 std::invalid_argument);
    const auto small = worst_region(check_of(JudgeKind{"buffer"}), grid(2, 1, {1, 5}), grid(2, 1, {1, 6}));
    EXPECT_EQ(small->worst, (Window{0, 0, 2, 1}));
}

}
}
