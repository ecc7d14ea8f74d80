#include <gtest/gtest.h>

#include "images.hpp"

// The parts of the rule one by one.
namespace umbral::grader::test {
namespace {

// Lines of one pixel on black.
Tensor wireframe(bool with_one_more_line)
{
    return picture(128, 128, [=](int x, int y) {
        const bool line = x == 20 || y == 30 || x + y == 150 || (with_one_more_line && x - y == 40);
        return line ? Colour{255, 255, 255, 255} : Colour{0, 0, 0, 255};
    });
}

TEST(Image, sub_rule_a_a_line_lost_or_added_is_found)
{
    // Beside another line a lost one would be excused if the smaller direction won.
    for (const bool lost : {true, false}) {
        const ImageRule found = rule(wireframe(!lost), wireframe(lost));
        EXPECT_GT(found.ratios[0], 10) << lost;
        EXPECT_LT(found.right(), 0.5) << lost;
    }
    EXPECT_NE(image(wireframe(false), wireframe(true)).message.find("no similar pixel"), std::string::npos);
}

TEST(Image, sub_rule_b_colour_in_the_interior_is_found_by_it_alone)
{
    const Tensor off = repaint(balls(), [](int x, int y) {
        const Colour colour = pixel(scene(), x, y);
        return background(colour) ? colour : moved(colour, (x / 4 + y / 4) % 2 == 0 ? 7 : -7);
    });
    const ImageRule found = rule(off, balls());
    EXPECT_LE(found.ratios[0], 1);
    EXPECT_GT(found.ratios[1], 1);
    EXPECT_LE(found.ratios[2], 1);
    EXPECT_LE(found.ratios[3], 1);
    EXPECT_NE(image(off, balls()).message.find("smooth surfaces"), std::string::npos);
}

TEST(Image, sub_rule_c_a_little_more_light_everywhere_is_found_by_it_alone)
{
    for (const int by : {3, -3}) {
        const Tensor off = repaint(balls(), [by](int x, int y) {
            const Colour colour = pixel(scene(), x, y);
            return background(colour) ? colour : moved(colour, by);
        });
        const ImageRule found = rule(off, balls());
        EXPECT_LE(found.ratios[0], 1);
        EXPECT_LE(found.ratios[1], 1);
        EXPECT_GT(found.ratios[2], 1);
        EXPECT_LE(found.ratios[3], 1);
        EXPECT_NEAR(found.bias, by, 0.2);
        EXPECT_NE(image(off, balls()).message.find(by > 0 ? "too bright" : "too dark"), std::string::npos);
    }
}

TEST(Image, sub_rule_e_a_hole_that_is_too_small_for_its_share_is_found_by_it_alone)
{
    const Tensor right = balls(512);
    const Tensor hole = repaint(right, [&](int x, int y) {
        return x >= 200 && x < 204 && y >= 180 && y < 183 ? Colour{8, 10, 40, 255} : pixel(right, x, y);
    });
    const ImageRule found = rule(hole, right);
    for (const std::size_t part : {0U, 1U, 2U, 3U, 5U}) EXPECT_LE(found.ratios[part], 1) << part;
    EXPECT_GE(found.cluster.count, 8);
    EXPECT_GT(found.ratios[4], 1);
    EXPECT_LE(found.cluster.x, 200);
    EXPECT_GE(found.cluster.x + window_side, 204);
    EXPECT_LE(found.cluster.y, 180);
    EXPECT_GE(found.cluster.y + window_side, 183);
    EXPECT_NE(image(hole, right).message.find("close together"), std::string::npos);
    EXPECT_GT(found.right(), 0.7) << "a small fault costs little, however dark the hole is";
    EXPECT_LT(found.right(), 0.95);
}

TEST(Image, sub_rule_e_pixels_far_apart_make_no_hole)
{
    const Tensor right = balls(512);
    const Tensor stray = repaint(right, [&](int x, int y) {
        return x % 64 == 20 && y % 64 == 20 ? Colour{255, 255, 255, 255} : pixel(right, x, y);
    });
    EXPECT_LE(rule(stray, right).ratios[4], 0.5);
}

TEST(Image, sub_rule_f_a_faint_spot_on_a_surface_is_found_by_it_alone)
{
    for (const int by : {4, -4}) {
        const Tensor right = balls(512);
        const Tensor spot = repaint(right, [&](int x, int y) {
            const Colour colour = pixel(right, x, y);
            return x >= 170 && x < 194 && y >= 200 && y < 224 ? moved(colour, by) : colour;
        });
        const ImageRule found = rule(spot, right);
        for (const std::size_t part : {0U, 1U, 2U, 3U, 4U}) EXPECT_LE(found.ratios[part], 1) << part;
        EXPECT_GT(found.ratios[5], 1);
        EXPECT_NEAR(found.surface.difference, by, 0.01);
        EXPECT_NE(
            image(spot, right).message.find(by > 0 ? "the surface is too bright by 4" : "the surface is too dark by 4"),
            std::string::npos);
    }
}

TEST(Image, sub_rule_d_a_shift_of_one_pixel_is_found_by_it_alone)
{
    // Large flat tiles: neighbourhoods forgive the shift, and no smooth place shows it.
    const auto tiles = [](int dx, int dy) {
        return picture(128, 128, [=](int x, int y) {
            if (x - dx < 16 || y - dy < 16 || x - dx >= 112 || y - dy >= 112) return Colour{0, 0, 0, 255};
            const int cell = (x - dx + 400) / 16 * 7 + (y - dy + 400) / 16 * 13;
            return Colour{byte(cell * 37 % 200), byte(cell * 91 % 200), byte(cell * 53 % 200), 255};
        });
    };
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}}) {
        const ImageRule found = rule(tiles(dx, dy), tiles(0, 0));
        EXPECT_LE(found.ratios[0], 1);
        EXPECT_LE(found.ratios[1], 1);
        EXPECT_GT(found.ratios[3], 1);
        EXPECT_EQ(found.shift_x, dx);
        EXPECT_EQ(found.shift_y, dy);
        EXPECT_LT(found.right(), 1);
        EXPECT_GT(found.right(), 0.3);
    }
}

}
}
