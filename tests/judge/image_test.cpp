#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "images.hpp"

namespace umbral::grader::test {
namespace {

TEST(Image, equal_ones_are_right)
{
    const Judgement found = image(balls(), balls());
    EXPECT_EQ(found.right, 1);
    EXPECT_EQ(found.error, 0);
    EXPECT_EQ(found.message, "");
    EXPECT_EQ(found.metrics.at("ssim"), 1);
    EXPECT_EQ(found.metrics.at("rmse"), 0);
    EXPECT_EQ(found.metrics.count("psnr"), 0U) << "infinite, so not a number for a report";
}

TEST(Image, one_level_of_noise_is_no_error)
{
    const std::uint64_t seed = 11;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Tensor noisy = repaint(
        balls(), [&](int x, int y) { return moved(pixel(scene(), x, y), static_cast<int>(random.below(3)) - 1); });
    const Judgement found = image(noisy, balls());
    EXPECT_EQ(found.right, 1) << found.message;
    EXPECT_LE(*found.error, 1);
    EXPECT_LT(found.metrics.at("ssim"), 1);
}

TEST(Image, edge_pixels_may_belong_to_the_neighbour)
{
    const std::uint64_t seed = 12;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Tensor right = balls(256);
    const Tensor owned = repaint(right, [&](int x, int y) {
        const Colour here = pixel(right, x, y);
        if (x == 0 || y == 0 || x == 255 || y == 255 || random.below(10) >= 3) return here;
        const Colour next =
            pixel(right, x + static_cast<int>(random.below(3)) - 1, y + static_cast<int>(random.below(3)) - 1);
        return background(next) != background(here) ? next : here;
    });
    ASSERT_NE(owned, right);
    const Judgement found = image(owned, right);
    EXPECT_EQ(found.right, 1) << found.message;
}

TEST(Image, credit_falls_with_the_wrong_area)
{
    double last = 1;
    for (const int side : {1, 4, 8, 16, 32, 64, 128}) {
        const Tensor off = repaint(balls(), [side](int x, int y) {
            return x < side && y < side ? Colour{250, 0, 250, 255} : pixel(scene(), x, y);
        });
        const double right = image(off, balls()).right;
        EXPECT_LE(right, last) << side;
        last = right;
    }
    EXPECT_EQ(last, 0);
}

TEST(Image, a_haze_over_the_background_does_not_thin_errors_out)
{
    const auto spoiled = [](bool haze) {
        return repaint(balls(), [haze](int x, int y) {
            const Colour colour = pixel(scene(), x, y);
            if (x >= 40 && x < 48 && y >= 48 && y < 56) return Colour{0, 255, 0, 255};
            return haze && background(colour) ? moved(colour, 4) : colour;
        });
    };
    EXPECT_LT(image(spoiled(false), balls()).right, 1);
    EXPECT_LE(image(spoiled(true), balls()).right, image(spoiled(false), balls()).right);
}

TEST(Image, alpha_counts)
{
    const Tensor glass = repaint(balls(), [](int x, int y) {
        Colour colour = pixel(scene(), x, y);
        colour.a = 0;
        return colour;
    });
    EXPECT_EQ(image(glass, balls()).right, 0);
}

TEST(Image, floats_are_mapped_by_the_range)
{
    Check check = check_of(JudgeKind{"image"});
    check.range_low = -1;
    check.range_high = 1;
    const auto normals = [](float extra) {
        std::vector<float> values;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x) {
                const float dx = static_cast<float>(x - 20) / 15;
                const float dy = static_cast<float>(y - 20) / 15;
                const float inside = 1 - dx * dx - dy * dy;
                for (const float v : {dx, dy, std::sqrt(std::fmax(inside, 0.0F))})
                    values.push_back(inside > 0 ? v + extra : 0);
            }
        Tensor tensor = floats(values, 3);
        tensor.rows = tensor.columns = 40;
        return tensor;
    };
    EXPECT_EQ(judge(check, normals(0.003F), normals(0), nullptr).right, 1) << "less than half a level of 2 / 255";
    EXPECT_LT(judge(check, normals(0.1F), normals(0), nullptr).right, 0.5);
    check.range_high = check.range_low;
    EXPECT_THROW((void)judge(check, normals(0.1F), normals(0), nullptr), std::invalid_argument);
    EXPECT_THROW((void)judge(check, normals(0), normals(0), nullptr), std::invalid_argument)
        << "equal pictures do not hide a broken manifest";
}

TEST(Image, what_is_not_finite_fails)
{
    Tensor right = floats(std::vector<float>(30 * 30 * 3, 0.5F), 3);
    right.rows = right.columns = 30;
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        Tensor wrong = right;
        std::memcpy(wrong.bytes.data() + 400, &bad, 4);
        const Judgement found = image(wrong, right);
        EXPECT_EQ(found.right, 0);
        EXPECT_FALSE(found.error);
        EXPECT_NE(found.message, "");
        EXPECT_THROW((void)image(right, wrong), std::invalid_argument);
        EXPECT_THROW((void)image(wrong, wrong), std::invalid_argument);
    }
}

TEST(Image, other_sizes_types_and_presence_are_wrong)
{
    EXPECT_EQ(image(balls(64), balls(128)).right, 0);
    EXPECT_NE(image(balls(64), balls(128)).message.find("64 x 64"), std::string::npos);
    const Tensor black = repaint(balls(), [](int, int) { return Colour{0, 0, 0, 255}; });
    EXPECT_TRUE(image(black, balls()).message.starts_with("Every pixel of the picture is (0, 0, 0, 255): nothing"))
        << image(black, balls()).message;
    Tensor three = balls();
    three.components = 3;
    three.bytes.resize(three.count());
    EXPECT_EQ(image(three, balls()).right, 0);
    Tensor holes = balls();
    holes.present.assign(holes.cells(), 1);
    EXPECT_EQ(image(holes, balls()).right, 1);
    holes.present[5] = 0;
    EXPECT_EQ(image(holes, balls()).right, 0);
    EXPECT_THROW((void)image(grid(2, 1, {1, 2}), grid(2, 1, {1, 2})), std::invalid_argument);
}

TEST(Image, smallest_pictures_are_judged)
{
    const auto one = [](std::uint8_t v) { return picture(1, 1, [v](int, int) { return Colour{v, v, v, 255}; }); };
    EXPECT_EQ(image(one(9), one(9)).right, 1);
    EXPECT_EQ(image(one(200), one(9)).right, 0);
    const auto line = [](std::uint8_t v) {
        return picture(7, 1, [v](int x, int) { return Colour{byte(x * v), v, v, 255}; });
    };
    EXPECT_EQ(image(line(30), line(9)).right, 0);
}

TEST(Image, the_first_difference_is_a_pixel_of_the_worst_place)
{
    const Tensor off = repaint(balls(), [](int x, int y) {
        return x >= 90 && y >= 90 && x < 110 && y < 110 ? Colour{255, 10, 40, 255} : pixel(scene(), x, y);
    });
    const Judgement found = image(off, balls());
    ASSERT_TRUE(found.first_difference);
    EXPECT_EQ(found.first_difference->yours, "(255, 10, 40, 255)");
    for (const auto& [name, value] : found.metrics) EXPECT_TRUE(std::isfinite(value)) << name;
}

}
}
