#include "explaining.hpp"
#include "images.hpp"

namespace umbral::grader::test {
namespace {

const Check image = check_of(JudgeKind{"image"});
const Check buffer = check_of(JudgeKind{"buffer"});

template <class Change>
Tensor each_colour(const Tensor& tensor, Change change)
{
    return repaint(tensor, [&](int x, int y) {
        Colour colour = pixel(tensor, x, y);
        for (glm::length_t c = 0; c < 3; ++c) colour[c] = byte(255 * change(colour[c] / 255.0));
        return colour;
    });
}

double encode(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }
double decode(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

Tensor moved(const Tensor& tensor, int dx, int dy)
{
    const int size = static_cast<int>(tensor.columns);
    return repaint(tensor, [&](int x, int y) { return pixel(tensor, (x - dx + size) % size, (y - dy + size) % size); });
}

TEST(ExplainImages, one_error_one_explanation)
{
    const Tensor right = balls();
    const int last = static_cast<int>(right.rows) - 1;
    const auto at = [&](auto place) { return repaint(right, [&](int x, int y) { return place(x, y); }); };
    EXPECT_EQ(first(image, at([&](int x, int y) { return pixel(right, x, last - y); }), right), "flipped vertically");
    EXPECT_EQ(first(image, at([&](int x, int y) { return pixel(right, last - x, y); }), right), "flipped horizontally");
    EXPECT_EQ(first(image, at([&](int x, int y) { return pixel(right, last - x, last - y); }), right),
              "turned by 180 degrees");
    EXPECT_EQ(first(image, at([&](int x, int y) { return pixel(right, y, x); }), right), "x and y swapped");
    EXPECT_EQ(first(image, at([&](int x, int y) { return Colour(glm::u8vec3(pixel(right, x, y)), 0); }), right),
              "alpha only");
    EXPECT_EQ(first(image, at([&](int x, int y) {
                        const Colour c = pixel(right, x, y);
                        return Colour{c.b, c.g, c.r, c.a};
                    }),
                    right),
              "red and blue swapped");
    EXPECT_EQ(first(image, each_colour(right, encode), right), "gamma applied twice");
    EXPECT_EQ(first(image, each_colour(right, decode), right), "gamma missing");
    EXPECT_EQ(first(image, each_colour(right, [](double v) { return 0.5 * v; }), right), "light scaled");
    EXPECT_EQ(first(image, each_colour(right, [](double v) { return 2 * v; }), right), "light scaled")
        << "clamped where it is brightest";
    EXPECT_EQ(first(image, each_colour(right, [](double v) { return 1 - v; }), right), "inverted");
    EXPECT_EQ(first(image, each_colour(right, [](double v) { return v - 0.1; }), right), "too dark by a constant");
}

/// The sentence of the first explanation.
std::string told(const Tensor& student, const Tensor& expected)
{
    const auto found = explain(image, student, expected);
    return found.empty() ? "nothing" : found.front().sentence;
}

TEST(ExplainImages, a_quarter_of_a_turn_either_way)
{
    const Tensor right = balls();
    const int last = static_cast<int>(right.rows) - 1;
    const auto at = [&](auto place) { return repaint(right, [&](int x, int y) { return place(x, y); }); };
    EXPECT_EQ(first(image, at([&](int x, int y) { return pixel(right, last - y, x); }), right), "turned by 90 degrees");
    EXPECT_EQ(first(image, at([&](int x, int y) { return pixel(right, y, last - x); }), right), "turned by 90 degrees");
}

TEST(ExplainImages, what_was_done_to_channels)
{
    const Tensor right = balls();
    const auto as = [&](auto change) {
        return repaint(right, [&](int x, int y) { return change(pixel(right, x, y)); });
    };
    EXPECT_EQ(told(as([](Colour c) {
                       return Colour{c.g, c.b, c.r, c.a};
                   }),
                   right),
              "Your colours are right, but in another order: the expected red, green and blue are your blue, red and "
              "green.");
    EXPECT_EQ(told(as([](Colour c) {
                       return Colour{c.r, 0, c.b, c.a};
                   }),
                   right),
              "Your picture is right but for its green, which is 0 everywhere.");
    EXPECT_EQ(told(as([](Colour c) {
                       return Colour{c.r, 0, 0, c.a};
                   }),
                   right),
              "Your picture is right but for its green and blue, which are 0 everywhere.");
    EXPECT_EQ(told(as([](Colour c) {
                       return Colour{c.g, c.g, c.g, c.a};
                   }),
                   right),
              "Your picture is grey: all three channels hold the expected green.");
    const auto luma = [](Colour c) { return byte(0.299 * c.r + 0.587 * c.g + 0.114 * c.b); };
    EXPECT_EQ(told(as([&](Colour c) {
                       return Colour{luma(c), luma(c), luma(c), c.a};
                   }),
                   right),
              "Your picture is grey: all three channels hold 0.3 of the expected red, 0.6 of the green and 0.1 of the "
              "blue.");
    EXPECT_EQ(told(as([](Colour c) { return Colour{0, 0, 0, c.a}; }), right), "nothing") << "black is no channel lost";
}

TEST(ExplainImages, powers_and_ranges_of_levels)
{
    const Tensor right = balls();
    EXPECT_EQ(first(image, each_colour(right, [](double v) { return std::pow(v, 1 / 1.8); }), right), "to a power");
    EXPECT_EQ(first(image, each_colour(right, [](double v) { return v * v; }), right), "to a power");
    EXPECT_EQ(first(image, each_colour(right, [](double v) { return 0.5 * v + 0.5; }), right), "another range");
    EXPECT_EQ(first(image, each_colour(right, [](double v) { return 2 * v - 0.5; }), right), "another range")
        << "clamped at both ends";
    EXPECT_EQ(first(image, each_colour(right, [](double v) { return 0.5 - 0.5 * v; }), right), "another range");
}

TEST(ExplainImages, differences_of_a_level_or_two_are_no_change_of_light)
{
    EXPECT_EQ(first(image, each_colour(balls(), [](double v) { return v - 1.0 / 255; }), balls()), "none");
    EXPECT_EQ(first(image, each_colour(balls(), [](double v) { return 0.985 * v; }), balls()), "none");
    EXPECT_EQ(first(image, each_colour(balls(), [](double v) { return std::pow(v, 1.03); }), balls()), "none");
}

TEST(ExplainImages, a_few_dark_pixels_are_no_change_of_light)
{
    const Tensor right = balls();
    const Tensor acne = repaint(right, [&](int x, int y) {
        const Colour colour = pixel(right, x, y);
        return x % 9 != 0 || background(colour) ? colour : Colour{colour.r / 2, colour.g / 2, colour.b / 2, colour.a};
    });
    EXPECT_EQ(first(image, acne, right), "none");
}

TEST(ExplainImages, the_shift_is_told)
{
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, -1}, {3, 2}, {-8, 8}}) {
        const auto found = explain(image, moved(balls(), dx, dy), balls());
        ASSERT_FALSE(found.empty()) << dx << " " << dy;
        EXPECT_EQ(found.front().name, "shifted");
    }
    EXPECT_NE(
        explain(image, moved(balls(), 3, -1), balls()).front().sentence.find("3 pixels to the right and 1 pixel up"),
        std::string::npos);
}

TEST(ExplainImages, the_factor_is_told)
{
    const auto found = explain(image, each_colour(balls(), [](double v) { return v / 2; }), balls());
    ASSERT_FALSE(found.empty());
    EXPECT_NE(found.front().sentence.find("about 0.5 times"), std::string::npos) << found.front().sentence;
}

TEST(ExplainImages, a_factor_near_one_is_not_rounded_away_from_it)
{
    const Tensor brighter = each_colour(balls(), [](double v) { return 1.44 * v; });
    EXPECT_NE(told(brighter, balls()).find("about 1.44 times"), std::string::npos) << told(brighter, balls());
}

TEST(ExplainImages, one_alpha_everywhere_says_as_much_as_several)
{
    const auto with_alpha = [](int alpha) {
        return repaint(balls(), [=](int x, int y) { return Colour(glm::u8vec3(pixel(scene(), x, y)), alpha); });
    };
    for (const int alpha : {0, 128}) {
        const auto found = explain(image, with_alpha(alpha), balls());
        ASSERT_FALSE(found.empty()) << alpha;
        EXPECT_GE(found.front().confidence, 0.9) << alpha;
        EXPECT_NE(found.front().sentence.find("an opaque pixel has alpha 255"), std::string::npos);
    }
    EXPECT_EQ(told(balls(), with_alpha(128)).find("opaque pixel"), std::string::npos)
        << "where the expected picture is not opaque, that would be wrong: " << told(balls(), with_alpha(128));
}

TEST(ExplainImages, unrelated_errors_have_no_explanation)
{
    const Tensor right = balls();
    EXPECT_TRUE(explain(image,
                        repaint(right,
                                [](int, int) {
                                    return Colour{8, 10, 40, 255};
                                }),
                        right)
                    .empty())
        << "blank";
    EXPECT_TRUE(explain(image,
                        repaint(right,
                                [](int, int) {
                                    return Colour{0, 0, 0, 255};
                                }),
                        right)
                    .empty())
        << "black";
    Random random(3);
    EXPECT_TRUE(explain(image,
                        repaint(right,
                                [&](int, int) {
                                    return Colour{random.below(256), random.below(256), random.below(256), 255};
                                }),
                        right)
                    .empty());
    const auto half = repaint(right, [&](int x, int y) {
        return x < 50 ? Colour{8, 10, 40, 255} : pixel(right, x, y);
    });
    EXPECT_TRUE(explain(image, half, right).empty()) << "one ball missing";
    EXPECT_TRUE(explain(image, balls(64), right).empty()) << "another size";
}

std::vector<float> slope(double sign, double from)
{
    std::vector<float> cells(64 * 48, static_cast<float>(sign < 0 ? 0 : 1));
    for (std::size_t y = 10; y < 40; ++y)
        for (std::size_t x = 5; x < 50; ++x)
            cells[y * 64 + x] = static_cast<float>(
                from + sign * (0.2 + 0.01 * static_cast<double>(x) + 0.003 * static_cast<double>(y)));
    return cells;
}

TEST(ExplainBuffers, depth_from_the_other_end)
{
    const Tensor right = depth(64, 48, slope(1, 0));
    EXPECT_EQ(first(buffer, depth(64, 48, slope(-1, 1)), right), "depth inverted");
    auto other = slope(1, 0);
    for (float& v : other) v = v * v;
    EXPECT_EQ(first(buffer, depth(64, 48, other), right), "none");
}

std::vector<std::uint32_t> squares(std::uint32_t offset, std::uint32_t background)
{
    std::vector<std::uint32_t> cells(64 * 48, background);
    for (std::size_t y = 10; y < 40; ++y)
        for (std::size_t x = 5; x < 50; ++x)
            cells[y * 64 + x] = static_cast<std::uint32_t>(x / 9 + y / 11 * 7) + offset;
    return cells;
}

TEST(ExplainBuffers, ids_off_by_one_flipped_and_shifted)
{
    const Tensor right = grid(64, 48, squares(3, 0));
    EXPECT_EQ(first(buffer, grid(64, 48, squares(4, 0)), right), "ids off by one");
    EXPECT_EQ(first(buffer, grid(64, 48, squares(2, 0)), right), "ids off by one");
    EXPECT_EQ(first(buffer, grid(64, 48, squares(4, 1)), right), "ids off by one") << "with the background";
    // One thing before a background is one off wherever a ray errs.
    std::vector<std::uint32_t> thing(64 * 48, 0);
    std::vector<std::uint32_t> erring(64 * 48, 0);
    for (std::size_t i = 0; i < thing.size(); ++i) {
        thing[i] = i % 64 < 20 ? 1 : 0;
        erring[i] = i % 7 == 0 ? 1 - thing[i] : thing[i];
    }
    EXPECT_NE(first(buffer, grid(64, 48, erring), grid(64, 48, thing)), "ids off by one");
    EXPECT_EQ(first(buffer, grid(64, 48, squares(6, 0)), right), "none");
    const auto plain = squares(3, 0);
    auto flipped = squares(3, 0);
    auto shifted = squares(3, 0);
    for (std::size_t y = 0; y < 48; ++y)
        for (std::size_t x = 0; x < 64; ++x) {
            flipped[y * 64 + x] = plain[(47 - y) * 64 + x];
            shifted[y * 64 + x] = plain[y * 64 + (x + 63) % 64];
        }
    EXPECT_EQ(first(buffer, grid(64, 48, flipped), right), "flipped vertically");
    EXPECT_EQ(first(buffer, grid(64, 48, shifted), right), "shifted");
}

}
}
