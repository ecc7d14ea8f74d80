#include <gtest/gtest.h>

#include <cmath>

#include "images.hpp"

namespace umbral::grader::test {
namespace {

TEST(ImageDetails, sub_rule_b_texture_of_yours_is_no_edge_that_excuses_it)
{
    // Spots of 9 levels up and down: your surfaces are not smooth any more, the expected ones are.
    const Tensor off = repaint(balls(), [](int x, int y) {
        const Colour colour = pixel(scene(), x, y);
        return colour == Colour{8, 10, 40, 255} ? colour : moved(colour, (x / 2 + y / 2) % 2 == 0 ? 9 : -9);
    });
    EXPECT_GT(rule(off, balls()).ratios[1], 10);
}

// As many pixels as a small triangle has, and what right line drawings differ by.
TEST(ImageDetails, sub_rule_e_a_hole_of_nine_pixels_is_one)
{
    const Tensor right = balls(512);
    const auto hole = [&](int width, int height) {
        return repaint(right, [&](int x, int y) {
            return x >= 200 && x < 200 + width && y >= 180 && y < 180 + height ? Colour{8, 10, 40, 255}
                                                                               : pixel(right, x, y);
        });
    };
    EXPECT_GT(rule(hole(3, 3), right).ratios[4], 1);
    EXPECT_LT(rule(hole(3, 1), right).ratios[4], 0.5);
}

TEST(ImageDetails, sub_rule_f_a_faint_spot_on_the_background_is_found)
{
    const Tensor spot = repaint(
        balls(), [](int x, int y) { return x < 24 && y < 24 ? moved(pixel(scene(), x, y), 4) : pixel(scene(), x, y); });
    const ImageRule found = rule(spot, balls());
    for (const std::size_t part : {0U, 1U, 2U, 3U, 4U}) EXPECT_LE(found.ratios[part], 1) << part;
    EXPECT_GT(found.ratios[5], 1);
}

TEST(ImageDetails, a_background_that_is_dithered_is_no_content)
{
    const auto dithered = [](int x, int y) {
        return x >= 20 && x < 40 && y >= 20 && y < 40 ? Colour{200, 60, 30, 255}
                                                      : Colour{byte(10 + (x + y) % 2), 10, 10, 255};
    };
    EXPECT_EQ(rule(picture(64, 64,
                           [](int, int) {
                               return Colour{0, 0, 0, 255};
                           }),
                   picture(64, 64, dithered))
                  .content,
              400);
}

TEST(ImageDetails, the_border_is_repeated_so_that_surfaces_reach_it)
{
    // Grey from the left border on; only its outermost column is off.
    const auto grey = [](int by) {
        return picture(64, 64, [by](int x, int y) {
            if (x >= 32 || y < 8 || y >= 56) return Colour{0, 0, 0, 255};
            return moved(Colour{100, 100, 100, 255}, x == 0 ? by : 0);
        });
    };
    EXPECT_GT(rule(grey(7), grey(0)).ratios[1], 1);
}

TEST(ImageDetails, floats_are_rounded_and_cut_to_the_range)
{
    Check check = check_of(JudgeKind{"image"});
    const auto level = [&](float value) { return int{to_picture(check, depth(1, 1, {value})).row(0, 0)[0]}; };
    EXPECT_EQ(level(0.6F / 255), 1);
    EXPECT_EQ(level(0.4F / 255), 0);
    EXPECT_EQ(level(1.5F), 255);
    EXPECT_EQ(level(-3), 0);
    check.range_low = -1;
    EXPECT_EQ(level(0), 128);
    EXPECT_EQ(level(-1), 0);
    Tensor two = floats({0, 1, 0, 1}, 2);
    EXPECT_THROW((void)judge(check_of(JudgeKind{"image"}), two, two, nullptr), std::invalid_argument)
        << "two channels are no picture";
}

TEST(ImageDetails, windows_are_those_that_counting_one_by_one_finds)
{
    const std::uint64_t seed = 91;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (const auto& [width, height] : {std::pair{64, 48}, {37, 53}, {7, 5}, {16, 9}, {100, 8}}) {
        std::vector<std::uint8_t> marks(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (std::uint8_t& mark : marks) mark = random.below(5) == 0 ? 1 : 0;
        int most = 0;
        for (int top = 0; top < height; top += window_side / 2)
            for (int left = 0; left < width; left += window_side / 2) {
                int count = 0;
                for (int y = top; y < std::min(height, top + window_side); ++y)
                    for (int x = left; x < std::min(width, left + window_side); ++x)
                        count += marks[static_cast<std::size_t>(y * width + x)];
                most = std::max(most, count);
            }
        EXPECT_EQ(densest_window(marks, width, height).count, most) << width << " x " << height;
    }
}

TEST(ImageDetails, a_larger_spot_costs_no_more_and_the_error_is_the_worst_measure)
{
    const Tensor right = balls(512);
    const Tensor hole = repaint(right, [&](int x, int y) {
        return x >= 196 && x < 208 && y >= 180 && y < 192 ? Colour{8, 10, 40, 255} : pixel(right, x, y);
    });
    const ImageRule found = rule(hole, right);
    EXPECT_GT(found.ratios[4], 10);
    EXPECT_EQ(found.worst(), found.ratios[4]);
    EXPECT_GT(found.right(), 0.6);
}

TEST(ImageDetails, what_is_wrong_everywhere_is_said_before_a_spot)
{
    const Tensor right = balls(512);
    const Tensor off = repaint(right, [&](int x, int y) {
        if (x >= 200 && x < 208 && y >= 180 && y < 188) return Colour{8, 10, 40, 255};
        const Colour colour = pixel(right, x, y);
        return colour == Colour{8, 10, 40, 255} ? colour : moved(colour, 4);
    });
    const Judgement found = judge(check_of(JudgeKind{"image"}), off, right, nullptr);
    EXPECT_NE(found.message.find("too bright"), std::string::npos) << found.message;
    EXPECT_EQ(found.message.find("close together"), std::string::npos) << found.message;
}

TEST(ImageDetails, the_mean_of_a_few_pixels_says_little)
{
    // A large surface, and one of 8 x 8 pixels that is off by 4 levels.
    const auto surfaces = [](int by) {
        return picture(128, 128, [by](int x, int y) {
            if (x >= 10 && x < 80 && y >= 10 && y < 120) return Colour{120, 120, 120, 255};
            return x >= 100 && x < 108 && y >= 100 && y < 108 ? moved(Colour{120, 120, 120, 255}, by)
                                                              : Colour{0, 0, 0, 255};
        });
    };
    EXPECT_LE(rule(surfaces(4), surfaces(0)).ratios[5], 1);
}

TEST(Image, sub_rule_g_another_sampling_point_is_found_by_it_alone)
{
    // Flat shapes: but for who owns the pixels of an edge, nothing changes.
    const auto shapes = [](double sample_x, double sample_y) {
        return picture(256, 256, [=](int x, int y) {
            const double u = x + sample_x;
            const double v = y + sample_y;
            if (std::hypot(u - 90.2, v - 110.7) < 60.3) return Colour{200, 90, 40, 255};
            if (u > 150.4 && u < 230.1 && v > 60.6 && 0.37 * u + v < 250.2) return Colour{60, 160, 90, 255};
            return Colour{20, 20, 30, 255};
        });
    };
    const Tensor right = shapes(0.5, 0.5);
    for (const auto& [dx, dy] : {std::pair{0.5, 0.0}, {-0.4, 0.0}, {0.0, 0.4}, {0.0, -0.4}}) {
        const ImageRule found = rule(shapes(0.5 + dx, 0.5 + dy), right);
        for (const std::size_t part : {0U, 1U, 2U, 3U, 4U, 5U})
            EXPECT_LE(found.ratios[part], 1) << part << ", moved by " << dx << ", " << dy;
        EXPECT_GT(found.ratios[6], 1);
        EXPECT_NEAR(found.displacement.x, -dx, 0.25);
        EXPECT_NEAR(found.displacement.y, -dy, 0.25);
    }
    EXPECT_NE(image(shapes(1, 0.5), right).message.find("sampling point"), std::string::npos);
}

TEST(Image, edge_pixels_that_change_hands_at_random_displace_nothing_and_lighten_nothing)
{
    const std::uint64_t seed = 23;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    // Bars three pixels wide: nearly every pixel is one of an edge.
    const auto bars = [](int x, int) { return x % 9 < 3 ? Colour{240, 240, 240, 255} : Colour{0, 0, 0, 255}; };
    const Tensor right = picture(128, 128, bars);
    const Tensor owned = repaint(right, [&](int x, int y) {
        return random.below(10) < 3 ? bars(std::max(0, x + 1 - static_cast<int>(random.below(3))), y) : bars(x, y);
    });
    const ImageRule found = rule(owned, right);
    EXPECT_LE(found.worst(), 0.5);
}

TEST(Image, sub_rule_c_lines_drawn_too_wide_are_found_though_every_pixel_has_a_similar_one_beside_it)
{
    const auto lines = [](int wide) {
        return picture(128, 128, [wide](int x, int) {
            return x % 16 < wide ? Colour{240, 240, 240, 255} : Colour{0, 0, 0, 255};
        });
    };
    const ImageRule found = rule(lines(2), lines(1));
    EXPECT_LE(found.ratios[0], 1);
    EXPECT_GT(found.ratios[2], 1);
}

}
}
