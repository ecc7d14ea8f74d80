#include <gtest/gtest.h>

#include "buffers.hpp"

// What the wrong cells of depths, normals and texture coordinates have in common.
namespace umbral::grader::test {
namespace {

Tensor depth_by(const std::function<float(double, double)>& value)
{
    std::vector<float> cells;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) cells.push_back(value(x, y));
    return depth(side, side, cells);
}

Tensor vectors_by(std::uint32_t components, const std::function<std::vector<float>(double, double)>& value)
{
    std::vector<float> cells;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            for (const float component : value(x, y)) cells.push_back(component);
    Tensor tensor = floats(cells, components);
    tensor.rows = tensor.columns = side;
    return tensor;
}

float slope(double x, double y) { return in_disc(x, y) ? static_cast<float>(0.3 + 0.01 * x + 0.003 * y) : 1.0F; }

TEST(BufferPatterns, depths_that_follow_a_rule)
{
    const Tensor expected = depth_by(slope);
    const auto mapped = [&](const std::function<double(double)>& rule) {
        return buffer(depth_by([&](double x, double y) {
                          return in_disc(x, y) ? static_cast<float>(rule(double{slope(x, y)})) : 1.0F;
                      }),
                      expected, absolute(1e-6));
    };
    const Judgement offset = mapped([](double z) { return z + 0.125; });
    EXPECT_TRUE(says(offset, "depths are all too large by 0.125")) << offset.message;
    EXPECT_NEAR(metric(offset, "depth_offset"), 0.125, 1e-6);
    EXPECT_TRUE(says(mapped([](double z) { return z - 0.01; }), "depths are all too small by 0.01"));
    EXPECT_TRUE(says(mapped([](double z) { return 0.9 - z; }), "depths run the other way"));
    EXPECT_TRUE(says(mapped([](double z) { return 0.5 * z; }), "depths are all 0.5 times the expected ones"));
    const Judgement coarse = mapped([](double z) { return std::round(z * 65535) / 65535; });
    EXPECT_TRUE(says(coarse, "depths are rounded to 16 bits")) << coarse.message;
    EXPECT_EQ(metric(coarse, "depth_bits"), 16);
    EXPECT_TRUE(says(mapped([](double z) { return std::floor(z * 255) / 255; }), "depths are rounded to 8 bits"));
    const Judgement bent = mapped([](double z) { return z * z + (z > 0.45 ? 0.7 : 0.0); });
    for (const char* word : {"too large", "too small", "other way", "times", "bits", "won"})
        EXPECT_FALSE(says(bent, word)) << bent.message;
}

TEST(BufferPatterns, rounding_finer_than_a_float_is_not_guessed_at)
{
    // Between 0.5 and 1 floats lie 2^-24 apart: whatever is there looks rounded to 24 bits.
    const auto high = [](double x, double y) {
        return in_disc(x, y) ? static_cast<float>(0.9 + 0.001 * x + 0.0003 * y) : 1.0F;
    };
    const auto off = [&](double x, double y) { return in_disc(x, y) ? std::nextafter(high(x, y), 0.0F) : 1.0F; };
    EXPECT_FALSE(says(buffer(depth_by(off), depth_by(high)), "bits"));
    const auto low = [](double x, double y) {
        return in_disc(x, y) ? static_cast<float>(0.003 + 0.0001 * x + 0.00003 * y) : 1.0F;
    };
    const auto rounded = [&](double x, double y) {
        return in_disc(x, y) ? static_cast<float>(std::round(double{low(x, y)} * 16777215) / 16777215) : 1.0F;
    };
    EXPECT_TRUE(says(buffer(depth_by(rounded), depth_by(low)), "rounded to 24 bits"))
        << buffer(depth_by(rounded), depth_by(low)).message;
}

TEST(BufferPatterns, the_farther_surface_won)
{
    // A near square before the slope; in yours the slope was drawn over it.
    const auto square = [](double x, double y) { return x > 7 && x < 16 && y > 7 && y < 14; };
    const Tensor expected =
        depth_by([&](double x, double y) { return square(x, y) ? static_cast<float>(0.1 + 0.002 * y) : slope(x, y); });
    const Judgement farther = buffer(depth_by(slope), expected);
    EXPECT_TRUE(says(farther, "the farther surface won: other depths are right")) << farther.message;
    EXPECT_TRUE(says(buffer(expected, depth_by(slope)), "a surface too near won: other depths are right"));
}

TEST(BufferPatterns, a_surface_that_is_bent_is_no_other_surface)
{
    // As by a distance that is interpolated between corners: right at the disc's middle column, and farther beside it.
    const auto bent = [](double x, double y) {
        return slope(x, y) + (in_disc(x, y) ? static_cast<float>(2e-4 * (x - 11) * (x - 11)) : 0.0F);
    };
    const Judgement found = buffer(depth_by(bent), depth_by(slope), absolute(1e-3));
    EXPECT_LT(found.right, 1);
    EXPECT_FALSE(says(found, "surface")) << found.message;
}

TEST(BufferPatterns, normals_are_measured_in_degrees)
{
    const auto normal = [](double x, double y, double turned) {
        if (!in_disc(x, y)) return std::vector<float>{0, 0, 0};
        const double angle = 0.05 * (x - 11) + turned;
        return std::vector<float>{static_cast<float>(std::sin(angle)), static_cast<float>(0.01 * y),
                                  static_cast<float>(std::cos(angle))};
    };
    const auto unit = [](std::vector<float> v) {
        const float length = std::hypot(v[0], v[1], v[2]);
        for (float& component : v) component = length > 0 ? component / length : 0;
        return v;
    };
    const Tensor expected = vectors_by(3, [&](double x, double y) { return unit(normal(x, y, 0)); });
    const auto yours = [&](const std::function<std::vector<float>(double, double)>& paint) {
        return buffer(vectors_by(3, paint), expected, absolute(1e-4));
    };
    const Judgement turned = yours([&](double x, double y) {
        std::vector<float> v = unit(normal(x, y, 0));
        return std::vector<float>{-v[1], v[0], v[2]};  // a quarter turn round the z axis
    });
    EXPECT_TRUE(says(turned, "normals are wrong")) << turned.message;
    EXPECT_TRUE(says(turned, " degrees off, ")) << turned.message;
    EXPECT_GT(metric(turned, "max_degrees"), metric(turned, "mean_degrees"));
    EXPECT_TRUE(says(yours([&](double x, double y) { return normal(x, y, 0); }),
                     "the directions are right, the lengths are not (about 1.0"));
    const Judgement back = yours([&](double x, double y) {
        std::vector<float> v = unit(normal(x, y, 0));
        return std::vector<float>{-v[0], -v[1], -v[2]};
    });
    EXPECT_TRUE(says(back, "normals point the other way")) << back.message;
    EXPECT_NEAR(metric(back, "mean_degrees"), 180, 0.01);
    // One right angle is 90 degrees, whatever the rest.
    const Judgement one = yours([&](double x, double y) {
        std::vector<float> v = unit(normal(x, y, 0));
        return x == 11 && y == 11 ? std::vector<float>{v[2], 0, -v[0]} : v;
    });
    EXPECT_NEAR(metric(one, "max_degrees"), 90, 0.01);
}

TEST(BufferPatterns, texture_coordinates_say_which_of_the_two)
{
    const auto paint = [](double u_factor, bool flip) {
        return vectors_by(2, [=](double x, double y) {
            if (!in_disc(x, y)) return std::vector<float>{-1, -1};
            const double v = y / side;
            return std::vector<float>{static_cast<float>(u_factor * x / side), static_cast<float>(flip ? 1 - v : v)};
        });
    };
    const Judgement flipped = buffer(paint(1, true), paint(1, false), absolute(1e-5));
    EXPECT_TRUE(says(flipped, "texture coordinates are wrong")) << flipped.message;
    EXPECT_TRUE(says(flipped, "v runs the other way (1 - v is expected)")) << flipped.message;
    const Judgement half = buffer(paint(0.5, false), paint(1, false), absolute(1e-5));
    EXPECT_TRUE(says(half, "off by up to 0.3958 in u, 0 in v")) << half.message;
}

TEST(BufferPatterns, what_was_expected_rounded_is_no_mistake)
{
    const auto stepped = [](double x, double y) {
        return in_disc(x, y) ? static_cast<float>(std::round(double{slope(x, y)} * 65535) / 65535) : 1.0F;
    };
    const auto off = [&](double x, double y) {
        return in_disc(x, y) ? stepped(x, y) + static_cast<float>(1.0 / 65535) : 1.0F;
    };
    const Judgement found = buffer(depth_by(off), depth_by(stepped), absolute(1e-7));
    EXPECT_TRUE(says(found, "depths are all too large by 1.526e-05")) << found.message;
}

}
}
