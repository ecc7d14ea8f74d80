#include <gtest/gtest.h>

#include <limits>

#include "buffers.hpp"

namespace umbral::grader::test {
namespace {

Tensor ids_by(const std::function<std::uint32_t(double, double)>& id)
{
    std::vector<std::uint32_t> cells;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) cells.push_back(id(x, y));
    return grid(side, side, cells);
}

// Id 5 left and 9 right of a line, in a disc.
std::uint32_t halves(double x, double y) { return !in_disc(x, y) ? 0 : x < 11 ? 5 : 9; }

TEST(BufferClasses, a_half_pixel_centre_gives_edge_pixels_to_their_neighbours)
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

TEST(BufferClasses, a_hole_inside_is_not_at_an_edge)
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

TEST(BufferClasses, an_edge_is_one_pixel_wide_and_no_more)
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

TEST(BufferClasses, groups_join_at_corners_too)
{
    const auto spots = [](double x, double y) {
        return (x == y && x >= 5 && x < 10) || (x == 15 && y > 10 && y < 14) ? 33U : halves(x, y);
    };
    const Judgement found = buffer(ids_by(spots), ids_by(halves));
    EXPECT_EQ(metric(found, "groups"), 2);
    EXPECT_EQ(metric(found, "largest_group"), 5);
    EXPECT_TRUE(says(found, "the largest group has 5 in x 5..9, y 5..9")) << found.message;
}

TEST(BufferClasses, whole_rows_and_columns_are_named)
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

TEST(BufferClasses, renamed_ids_are_one_mistake_and_not_many)
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

TEST(BufferClasses, coverage_is_about_pixels)
{
    const auto covered = [](double x, double y) { return in_disc(x, y) ? 1U : 0U; };
    const Judgement found =
        buffer(ids_by([&](double x, double y) { return in_disc(x, y, 9) ? 1U : 0U; }), ids_by(covered));
    EXPECT_TRUE(says(found, "pixels are wrong (0 missing, ")) << found.message;
    EXPECT_TRUE(says(found, "another pixel owns the edge"));
}

TEST(BufferSketch, shows_both_sides_of_the_first_bad_place)
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

TEST(BufferSketch, depths_are_drawn_in_tenths_and_long_ids_as_letters)
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

TEST(BufferClasses, no_large_buffer_or_odd_one_stops_it)
{
    EXPECT_EQ(buffer(grid(1, 1, {5}), grid(1, 1, {4})).sketch,
              "yours   expected\n>5       .\nx 0..0, y 0..0; . background, > wrong");
    std::vector<std::uint32_t> all(512 * 512, 1);
    const Judgement found = buffer(grid(512, 512, std::vector<std::uint32_t>(512 * 512, 0)), grid(512, 512, all));
    EXPECT_EQ(metric(found, "largest_group"), 512 * 512);
    EXPECT_EQ(metric(found, "groups"), 1);
}

}
}
