#include <gtest/gtest.h>

#include <limits>

#include "make.hpp"

namespace umbral::grader::test {
namespace {

constexpr std::uint32_t side = 24;

Judgement buffer(const Tensor& student, const Tensor& expected, Tolerance tolerance = {})
{
    return judge(check_of(JudgeKind{"buffer"}, tolerance), student, expected, nullptr);
}

bool says(const Judgement& found, const std::string& words) { return found.message.find(words) != std::string::npos; }

double metric(const Judgement& found, const std::string& name)
{
    const auto at = found.metrics.find(name);
    return at == found.metrics.end() ? -1 : at->second;
}

Tensor ids_by(const std::function<std::uint32_t(double, double)>& id)
{
    std::vector<std::uint32_t> cells;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) cells.push_back(id(x, y));
    return grid(side, side, cells);
}

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

bool in_disc(double x, double y, double radius = 8) { return std::hypot(x - 11.5, y - 11.5) < radius; }

// Id 5 left and 9 right of a line, in a disc.
std::uint32_t halves(double x, double y) { return !in_disc(x, y) ? 0 : x < 11 ? 5 : 9; }

float slope(double x, double y) { return in_disc(x, y) ? static_cast<float>(0.3 + 0.01 * x + 0.003 * y) : 1.0F; }

TEST(BufferClasses, AHalfPixelCentreGivesEdgePixelsToTheirNeighbours)
{
    const Judgement found = buffer(ids_by([](double x, double y) { return halves(x + 0.5, y + 0.5); }), ids_by(halves));
    EXPECT_GT(metric(found, "wrong"), 5);
    EXPECT_EQ(metric(found, "at_edge"), metric(found, "wrong"));
    EXPECT_EQ(metric(found, "neighbour_value"), metric(found, "wrong"));
    EXPECT_TRUE(says(found, "cells are wrong")) << found.message;
    Check check = check_of(JudgeKind{"buffer"});
    check.value = "ids";
    EXPECT_TRUE(says(judge(check, ids_by([](double x, double y) { return halves(x + 1, y); }), ids_by(halves), nullptr),
                     "ids are wrong"));
    EXPECT_TRUE(says(found, "all lie at an edge and hold a neighbour's value: another pixel owns the edge"))
        << found.message;
}

TEST(BufferClasses, AHoleInsideIsNotAtAnEdge)
{
    // Round (7, 11) all is 5 for three pixels and more.
    const auto holed = [](double x, double y) { return x >= 6 && x <= 7 && y >= 11 && y <= 12 ? 77U : halves(x, y); };
    const Judgement found = buffer(ids_by(holed), ids_by(halves));
    EXPECT_EQ(metric(found, "at_edge"), 0);
    EXPECT_EQ(metric(found, "neighbour_value"), 0);
    EXPECT_EQ(metric(found, "groups"), 1);
    EXPECT_EQ(metric(found, "largest_group"), 4);
    EXPECT_TRUE(says(found, "all lie inside, none at an edge; 4 of values that are expected nowhere")) << found.message;
}

TEST(BufferClasses, AnEdgeIsOnePixelWideAndNoMore)
{
    // The line between 5 and 9 lies between x = 10 and 11.
    for (const auto& [column, at_edge] : {std::pair{9.0, 0.0}, {10.0, 1.0}, {11.0, 1.0}, {12.0, 0.0}}) {
        const auto one = [column = column](double x, double y) { return x == column && y == 11 ? 33U : halves(x, y); };
        EXPECT_EQ(metric(buffer(ids_by(one), ids_by(halves)), "at_edge"), at_edge) << column;
    }
    const auto one = [](double x, double y) { return x == 10 && y == 11 ? 9U : halves(x, y); };
    EXPECT_TRUE(says(buffer(ids_by(one), ids_by(halves)), "it lies at an edge and holds a neighbour's value"))
        << "what (11, 11) holds";
    const auto far_off = [](double x, double y) { return x == 9 && y == 11 ? 9U : halves(x, y); };
    EXPECT_TRUE(says(buffer(ids_by(far_off), ids_by(halves)), "it lies inside, not at an edge;"))
        << "9 is two pixels away";
}

TEST(BufferClasses, GroupsJoinAtCornersToo)
{
    const auto spots = [](double x, double y) {
        return (x == y && x >= 5 && x < 10) || (x == 15 && y > 10 && y < 14) ? 33U : halves(x, y);
    };
    const Judgement found = buffer(ids_by(spots), ids_by(halves));
    EXPECT_EQ(metric(found, "groups"), 2);
    EXPECT_EQ(metric(found, "largest_group"), 5);
    EXPECT_TRUE(says(found, "the largest group has 5 in x 5..9, y 5..9")) << found.message;
}

TEST(BufferClasses, WholeRowsAndColumnsAreNamed)
{
    const auto row = [](double x, double y) { return y == 12 ? 0U : halves(x, y); };
    EXPECT_TRUE(says(buffer(ids_by(row), ids_by(halves)), "; whole row 12; "))
        << buffer(ids_by(row), ids_by(halves)).message;
    const auto columns = [](double x, double y) { return x >= 8 && x <= 9 ? 0U : halves(x, y); };
    EXPECT_TRUE(says(buffer(ids_by(columns), ids_by(halves)), "; whole columns 8 to 9; "));
    const auto most_of_a_row = [](double x, double y) { return y == 12 && x > 6 ? 0U : halves(x, y); };
    EXPECT_FALSE(says(buffer(ids_by(most_of_a_row), ids_by(halves)), "whole"));
    EXPECT_FALSE(says(buffer(ids_by([](double, double) { return 0U; }), ids_by(halves)), "whole"))
        << "where nothing is right, no row stands out";
}

TEST(BufferClasses, RenamedIdsAreOneMistakeAndNotMany)
{
    const auto swapped = [](double x, double y) { return halves(x, y) == 0 ? 0U : 14 - halves(x, y); };
    const Judgement found = buffer(ids_by(swapped), ids_by(halves));
    EXPECT_TRUE(says(found, "the shapes are right, but named otherwise: 9 for 5, 5 for 9")) << found.message;
    EXPECT_EQ(metric(found, "renamed"), 2);
    const auto merged = [](double x, double y) { return halves(x, y) == 0 ? 0U : 9U; };
    EXPECT_FALSE(says(buffer(ids_by(merged), ids_by(halves)), "named otherwise")) << "two ids became one";
    const auto mixed = [](double x, double y) {
        return halves(x, y) == 0 ? 0U : static_cast<std::uint32_t>(x + y) % 2 == 0 ? 5U : 9U;
    };
    EXPECT_FALSE(says(buffer(ids_by(mixed), ids_by(halves)), "named otherwise"));
    const auto mostly = [&](double x, double y) {
        return halves(x, y) != 0 && static_cast<int>(x + y) % 4 == 0 ? 33U : swapped(x, y);
    };
    EXPECT_FALSE(says(buffer(ids_by(mostly), ids_by(halves)), "named otherwise")) << "a quarter follows no rule";
}

TEST(BufferClasses, CoverageIsAboutPixels)
{
    const auto covered = [](double x, double y) { return in_disc(x, y) ? 1U : 0U; };
    const Judgement found =
        buffer(ids_by([&](double x, double y) { return in_disc(x, y, 9) ? 1U : 0U; }), ids_by(covered));
    EXPECT_TRUE(says(found, "pixels are wrong (0 missing, ")) << found.message;
    EXPECT_TRUE(says(found, "another pixel owns the edge"));
}

TEST(BufferPatterns, DepthsThatFollowARule)
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

TEST(BufferPatterns, RoundingFinerThanAFloatIsNotGuessedAt)
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

TEST(BufferPatterns, TheFartherSurfaceWon)
{
    // A near square before the slope; in yours the slope was drawn over it.
    const auto square = [](double x, double y) { return x > 7 && x < 16 && y > 7 && y < 14; };
    const Tensor expected =
        depth_by([&](double x, double y) { return square(x, y) ? static_cast<float>(0.1 + 0.002 * y) : slope(x, y); });
    const Judgement farther = buffer(depth_by(slope), expected);
    EXPECT_TRUE(says(farther, "the farther surface won: other depths are right")) << farther.message;
    EXPECT_TRUE(says(buffer(expected, depth_by(slope)), "a surface too near won: other depths are right"));
}

TEST(BufferPatterns, NormalsAreMeasuredInDegrees)
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

TEST(BufferPatterns, TextureCoordinatesSayWhichOfTheTwo)
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

TEST(BufferSketch, ShowsBothSidesOfTheFirstBadPlace)
{
    std::vector<std::uint32_t> cells(64, 0);
    for (const std::size_t cell : {27, 28, 35, 36}) cells[cell] = 12;
    auto yours = cells;
    yours[27] = 0;
    yours[37] = 3;
    const Judgement found = buffer(grid(8, 8, yours), grid(8, 8, cells));
    EXPECT_EQ(found.sketch,
              "yours                   expected\n"
              "  .  .  .  .  .  .  .     .  .  .  .  .  .  .\n"
              "  .  .  .  .  .  .  .     .  .  .  .  .  .  .\n"
              "  .  .  .  .  .  .  .     .  .  .  .  .  .  .\n"
              "  .  .  . >. 12  .  .     .  .  . 12 12  .  .\n"
              "  .  .  . 12 12 >3  .     .  .  . 12 12  .  .\n"
              "  .  .  .  .  .  .  .     .  .  .  .  .  .  .\n"
              "  .  .  .  .  .  .  .     .  .  .  .  .  .  .\n"
              "x 0..6, y 0..6; . background, > wrong");
    EXPECT_EQ(buffer(grid(8, 8, cells), grid(8, 8, cells)).sketch, "");
}

TEST(BufferSketch, DepthsAreDrawnInTenthsAndLongIdsAsLetters)
{
    const Judgement found = buffer(depth(3, 1, {0.5F, 0.2F, 1.0F}), depth(3, 1, {0.5F, 0.65F, 1.0F}));
    EXPECT_EQ(found.sketch,
              "yours    expected\n"
              " .>0 9    . 5 9\n"
              "x 0..2, y 0..0; 0..9 depths 0.2..1, . background, > wrong");
    const Judgement named = buffer(grid(3, 1, {7, 123456, 5}), grid(3, 1, {7, 99999, 5}));
    EXPECT_EQ(named.sketch,
              "yours    expected\n"
              " .>a 5    . b 5\n"
              "x 0..2, y 0..0; a 123456, b 99999, . background, > wrong");
    const auto nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(buffer(depth(3, 1, {0.5F, nan, 1.0F}), depth(3, 1, {0.5F, 0.65F, 1.0F})).sketch.find(">!"),
              std::string::npos);
}

TEST(BufferClasses, NoLargeBufferOrOddOneStopsIt)
{
    EXPECT_EQ(buffer(grid(1, 1, {5}), grid(1, 1, {4})).sketch,
              "yours   expected\n>5       .\nx 0..0, y 0..0; . background, > wrong");
    std::vector<std::uint32_t> all(512 * 512, 1);
    const Judgement found = buffer(grid(512, 512, std::vector<std::uint32_t>(512 * 512, 0)), grid(512, 512, all));
    EXPECT_EQ(metric(found, "largest_group"), 512 * 512);
    EXPECT_EQ(metric(found, "groups"), 1);
}

TEST(BufferPatterns, WhatWasExpectedRoundedIsNoMistake)
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
