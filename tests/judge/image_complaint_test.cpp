#include <gtest/gtest.h>

#include "images.hpp"
#include "judge/picture/offset_text.hpp"

// What is said of a wrong picture must be true of it.
namespace umbral::grader::test {
namespace {

testing::AssertionResult says(const Tensor& student, const Tensor& expected, const char* words)
{
    const std::string message = image(student, expected).message;
    if (message.find(words) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << message;
}

// A square of so many pixels on a plain background, in the middle of 128 x 128.
Tensor square(int side, Colour background = {60, 90, 130, 255})
{
    const int first = 64 - side / 2;
    const auto inside = [=](int at) { return at >= first && at < first + side; };
    return picture(128, 128, [=](int x, int y) {
        return inside(x) && inside(y) ? Colour{230, 200, 50, 255} : background;
    });
}

TEST(ImageComplaint, no_share_of_the_content_is_said_of_a_wrong_background)
{
    // 100 pixels of content, and 16284 wrong ones: 16284 % of nothing that anybody sees.
    EXPECT_TRUE(says(square(10, {60, 90, 100, 255}), square(10),
                     "16284 of the 16284 pixels of the background have no similar pixel next to their place"));
    EXPECT_TRUE(says(square(10, {60, 90, 122, 255}), square(10), "pixels of the background have another colour"));
}

TEST(ImageComplaint, a_share_is_never_of_more_than_all)
{
    // The square lies elsewhere: as much is wrong outside of the content as in it.
    const Tensor right = square(10);
    const Tensor elsewhere = repaint(right, [&](int x, int y) { return pixel(right, (x + 64) % 128, y); });
    EXPECT_TRUE(says(elsewhere, right, "100 % of the picture's content has no similar pixel next to its place"));
}

TEST(ImageComplaint, a_larger_shape_is_not_a_brighter_picture)
{
    EXPECT_TRUE(says(square(12), square(10), "pixels at edges are too bright"));
    EXPECT_TRUE(says(square(8), square(10), "pixels at edges are too dark"));
    const Tensor darker = repaint(balls(), [](int x, int y) {
        return background(pixel(scene(), x, y)) ? pixel(scene(), x, y) : moved(pixel(scene(), x, y), -3);
    });
    EXPECT_TRUE(says(darker, balls(), "the picture is too dark by"));
}

TEST(ImageComplaint, a_hole_is_told_from_a_spot_and_from_another_colour)
{
    const Tensor right = balls(512);
    const auto with = [&](int left, int top, Colour colour) {
        return repaint(right, [&](int x, int y) {
            return x >= left && x < left + 4 && y >= top && y < top + 3 ? colour : pixel(right, x, y);
        });
    };
    ASSERT_FALSE(background(pixel(right, 200, 180)));
    ASSERT_TRUE(background(pixel(right, 4, 4)));
    EXPECT_TRUE(says(with(200, 180, {8, 10, 40, 255}), right, "the background is seen"));
    EXPECT_TRUE(says(with(200, 180, {255, 0, 255, 255}), right, "a small part has another colour"));
    EXPECT_TRUE(says(with(4, 4, {255, 0, 255, 255}), right, "where the background should be"));
}

TEST(ImageComplaint, a_surface_at_the_border_is_no_background)
{
    // Stripes fill the picture: neither of their colours is a background.
    const Tensor right = picture(512, 512, [](int, int y) {
        return y / 8 % 2 == 1 ? Colour{150, 150, 140, 255} : Colour{40, 50, 60, 255};
    });
    for (const int top : {200, 208}) {
        const Tensor spot = repaint(right, [&](int x, int y) {
            return x >= 200 && x < 205 && y >= top + 2 && y < top + 6 ? Colour{255, 0, 255, 255} : pixel(right, x, y);
        });
        EXPECT_TRUE(says(spot, right, "a small part has another colour"));
    }
    const Tensor other = repaint(right, [&](int x, int y) { return moved(pixel(right, x, y), 30); });
    EXPECT_EQ(image(other, right).message.find("background"), std::string::npos) << image(other, right).message;
}

TEST(ImageComplaint, a_shift_has_its_direction_in_words)
{
    const Tensor right = square(40);
    const Tensor up = repaint(right, [&](int x, int y) { return pixel(right, x, std::min(y + 1, 127)); });
    EXPECT_TRUE(says(up, right, "everything is shifted by 1 pixel up"));
    EXPECT_EQ(offset_text(-2, 1), "2 pixels to the left and 1 pixel down");
    EXPECT_EQ(offset_text(0.437, -0.01), "0.44 pixels to the right");
    EXPECT_EQ(offset_text(0, 0), "");
}

}
}
