#include "judge/picture/image_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "make.hpp"

namespace umbral::grader::test {
namespace {

Picture to_planes(const Tensor& tensor) { return to_picture(check_of(JudgeKind{"image"}), tensor); }

Tensor constant(std::uint8_t level)
{
    return picture(48, 40, [level](int, int) { return Colour{level, level, level, 255}; });
}

Tensor noise(int width, int height, std::uint64_t seed)
{
    Random random(seed);
    return picture(width, height, [&](int, int) {
        const auto v = static_cast<std::uint8_t>(random.below(256));
        return Colour{v, v, v, 255};
    });
}

// The definition, window by window, in long double.
double similarity_by_definition(const Tensor& a, const Tensor& b)
{
    const int width = static_cast<int>(a.columns);
    const int height = static_cast<int>(a.rows);
    const auto mirrored = [](int i, int size) { return i < 0 ? -i : i >= size ? 2 * size - 2 - i : i; };
    long double total = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            long double weight = 0, ma = 0, mb = 0;
            const auto each = [&](auto&& visit) {
                for (int j = -5; j <= 5; ++j)
                    for (int i = -5; i <= 5; ++i) {
                        const int sx = mirrored(x + i, width);
                        const int sy = mirrored(y + j, height);
                        visit(std::exp(-(i * i + j * j) / 4.5L), static_cast<long double>(pixel(a, sx, sy).r),
                              static_cast<long double>(pixel(b, sx, sy).r));
                    }
            };
            each([&](long double w, long double p, long double q) { weight += w, ma += w * p, mb += w * q; });
            ma /= weight;
            mb /= weight;
            long double va = 0, vb = 0, cov = 0;
            each([&](long double w, long double p, long double q) {
                va += w * (p - ma) * (p - ma);
                vb += w * (q - mb) * (q - mb);
                cov += w * (p - ma) * (q - mb);
            });
            const long double c1 = 6.5025L;
            const long double c2 = 58.5225L;
            total += (2 * ma * mb + c1) * (2 * cov / weight + c2) /
                     ((ma * ma + mb * mb + c1) * (va / weight + vb / weight + c2));
        }
    return static_cast<double>(total / (width * height));
}

TEST(ImageMetrics, similarity_of_constants_is_the_exact_one)
{
    const double exact = (2.0 * 255 * 254 + 6.5025) / (255.0 * 255 + 254.0 * 254 + 6.5025);
    EXPECT_NEAR(exact, 0.999992, 5e-7);
    EXPECT_NEAR(structural_similarity(to_planes(constant(255)), to_planes(constant(254))), exact, 1e-10);
}

TEST(ImageMetrics, similarity_is_the_definition)
{
    const Tensor a = noise(29, 23, 5);
    const Tensor b = noise(29, 23, 6);
    EXPECT_NEAR(structural_similarity(to_planes(a), to_planes(b)), similarity_by_definition(a, b), 1e-9);
    // A difference in one place only: what is computed is only its surroundings.
    const Tensor spot = repaint(a, [&](int x, int y) {
        return x == 20 && y == 11 ? Colour{0, 0, 0, 255} : pixel(a, x, y);
    });
    EXPECT_NEAR(structural_similarity(to_planes(spot), to_planes(a)), similarity_by_definition(spot, a), 1e-9);
    const Tensor corner = repaint(a, [&](int x, int y) {
        return x == 0 && y == 0 ? Colour{0, 0, 0, 255} : pixel(a, x, y);
    });
    EXPECT_NEAR(structural_similarity(to_planes(corner), to_planes(a)), similarity_by_definition(corner, a), 1e-9);
    EXPECT_EQ(structural_similarity(to_planes(a), to_planes(a)), 1);
}

TEST(ImageMetrics, error_and_noise_ratio_by_hand)
{
    const Tensor off = repaint(constant(100), [](int x, int y) {
        return x == 3 && y == 4 ? Colour{110, 100, 100, 255} : Colour{100, 100, 100, 255};
    });
    const ImageMetrics found = measure_image(to_planes(off), to_planes(constant(100)));
    const double squares = 100.0 / (48 * 40 * 3);
    EXPECT_NEAR(found.rmse, std::sqrt(squares), 1e-5);
    EXPECT_NEAR(found.psnr, 10 * std::log10(65025 / squares), 1e-4);
}

TEST(ImageMetrics, lab_distances_of_known_colours)
{
    const ImageMetrics grey = measure_image(to_planes(constant(255)), to_planes(constant(0)));
    EXPECT_NEAR(grey.mean_lab, 100, 0.01);
    EXPECT_NEAR(grey.max_lab, 100, 0.01);
    // sRGB red is Lab (53.24, 80.09, 67.20), green (87.73, -86.18, 83.18): Lindbloom's tables, D65.
    const auto plain = [](Colour colour) { return picture(4, 4, [colour](int, int) { return colour; }); };
    const ImageMetrics colours = measure_image(to_planes(plain({255, 0, 0, 255})), to_planes(plain({0, 255, 0, 255})));
    EXPECT_NEAR(colours.mean_lab, std::sqrt(34.49 * 34.49 + 166.27 * 166.27 + 15.98 * 15.98), 0.5);
}

}
}
