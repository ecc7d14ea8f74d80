#include <gtest/gtest.h>

#include <limits>

#include "buffers.hpp"

namespace umbral::grader::test {
namespace {

// 100 x 100 of background 7 with four cells 1, 2, 3, 4 in the middle.
std::vector<std::uint32_t> mostly_empty()
{
    std::vector<std::uint32_t> cells(10000, 7);
    for (std::uint32_t i = 0; i < 4; ++i) cells[5050 + i] = i + 1;
    return cells;
}

TEST(Buffer, equal_ones_are_right)
{
    const Judgement found = buffer(grid(100, 100, mostly_empty()), grid(100, 100, mostly_empty()));
    EXPECT_EQ(found.right, 1);
    EXPECT_EQ(found.error, 0);
    EXPECT_EQ(found.message, "");
    EXPECT_EQ(found.metrics.at("cells"), 4);
}

TEST(Buffer, an_empty_one_hides_nothing_behind_its_background)
{
    const Tensor expected = grid(100, 100, mostly_empty());
    EXPECT_EQ(buffer(grid(100, 100, std::vector<std::uint32_t>(10000, 7)), expected).right, 0);
    EXPECT_EQ(buffer(grid(100, 100, std::vector<std::uint32_t>(10000, 0)), expected).right, 0);
}

TEST(Buffer, differences_are_classified)
{
    auto cells = mostly_empty();
    cells[5050] = 7;  // missing
    cells[5051] = 9;  // wrong value
    cells[17] = 3;    // extra
    const Judgement found = buffer(grid(100, 100, cells), grid(100, 100, mostly_empty()));
    EXPECT_EQ(found.metrics.at("missing"), 1);
    EXPECT_EQ(found.metrics.at("extra"), 1);
    EXPECT_EQ(found.metrics.at("wrong_value"), 1);
    EXPECT_DOUBLE_EQ(found.right, 2.0 / 5);
    EXPECT_EQ(found.first_difference->where, "pixel (17, 0)");
    EXPECT_FALSE(found.error) << "ids do not lie some distance apart";
    EXPECT_EQ(found.message,
              "3 of 5 cells are wrong (1 missing, 1 extra, 1 with another value); 2 at an edge, 1 inside; 1 of values "
              "that are expected nowhere; the largest "
              "group has 2 in x 50..51, y 50..50; the first is pixel (17, 0): yours 3, expected 7");
}

TEST(Buffer, depth_is_exact_unless_a_tolerances_says_otherwise)
{
    std::vector<float> cells(100, 1.0F);
    cells[55] = 0.5F;
    auto off = cells;
    off[55] = 0.5001F;
    EXPECT_EQ(buffer(depth(10, 10, off), depth(10, 10, cells)).right, 0);
    EXPECT_EQ(buffer(depth(10, 10, off), depth(10, 10, cells), absolute(1e-3)).right, 1);
    EXPECT_NEAR(*buffer(depth(10, 10, off), depth(10, 10, cells), absolute(1e-6)).error, 1e-4, 1e-6);
    // A background a little off does not join the content and thin its errors out.
    auto tinted = std::vector<float>(100, 1.0005F);
    EXPECT_EQ(buffer(depth(10, 10, tinted), depth(10, 10, cells), absolute(1e-3)).right, 0);
}

TEST(Buffer, infinity_is_a_background_and_na_n_is_nothing)
{
    std::vector<float> cells(100, std::numeric_limits<float>::infinity());
    cells[55] = 2;
    EXPECT_EQ(buffer(depth(10, 10, cells), depth(10, 10, cells)).right, 1);
    auto finite = std::vector<float>(100, 1e30F);
    finite[55] = 2;
    EXPECT_LT(buffer(depth(10, 10, finite), depth(10, 10, cells), absolute(1)).right, 0.02);
    EXPECT_LT(buffer(depth(10, 10, finite), depth(10, 10, cells), relative(1)).right, 0.02)
        << "an infinite bound would accept everything";
    auto broken = cells;
    broken[55] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(buffer(depth(10, 10, broken), depth(10, 10, cells), absolute(1e30)).right, 0);
    EXPECT_FALSE(buffer(depth(10, 10, broken), depth(10, 10, cells), absolute(1e30)).error);
    EXPECT_EQ(buffer(depth(10, 10, broken), depth(10, 10, broken), absolute(1e30)).right, 0) << "not even itself";
}

TEST(Buffer, a_buffer_of_one_cell_and_one_of_background_only)
{
    EXPECT_EQ(buffer(grid(1, 1, {4}), grid(1, 1, {4})).right, 1);
    EXPECT_EQ(buffer(grid(1, 1, {5}), grid(1, 1, {4})).right, 0);
    EXPECT_EQ(buffer(grid(2, 2, {4, 4, 4, 4}), grid(2, 2, {4, 4, 4, 4})).right, 1);
    EXPECT_EQ(buffer(grid(2, 2, {4, 4, 4, 5}), grid(2, 2, {4, 4, 4, 4})).right, 0);
}

TEST(Buffer, transposed_shape_is_wrong)
{
    EXPECT_EQ(buffer(grid(2, 3, {1, 2, 3, 4, 5, 6}), grid(3, 2, {1, 2, 3, 4, 5, 6})).right, 0);
}

TEST(Buffer, the_background_is_what_the_expected_border_holds_most)
{
    // 28 cells of border, 36 inside.
    std::vector<std::uint32_t> framed(64, 3);
    for (std::size_t i = 0; i < 64; ++i)
        if (i < 8 || i >= 56 || i % 8 == 0 || i % 8 == 7) framed[i] = 0;
    const Judgement blank = buffer(grid(8, 8, std::vector<std::uint32_t>(64, 0)), grid(8, 8, framed));
    EXPECT_EQ(blank.right, 0);
    EXPECT_EQ(blank.metrics.at("missing"), 36);
    // Of two as frequent as each other, the first.
    const Judgement tie = buffer(grid(2, 1, {4, 4}), grid(2, 1, {4, 5}));
    EXPECT_EQ(tie.right, 0);
    EXPECT_EQ(tie.metrics.at("missing"), 1);
    // The student's border decides nothing.
    std::vector<std::uint32_t> top(16, 0);
    std::fill_n(top.begin(), 4, 3U);
    EXPECT_EQ(buffer(grid(4, 4, std::vector<std::uint32_t>(16, 3)), grid(4, 4, top)).right, 0.25);
}

TEST(Buffer, two_cells_near_the_background_need_not_be_equal)
{
    std::vector<float> expected(100, 1.0F);
    expected[44] = 0.5F;
    expected[55] = 1.0008F;
    auto off = expected;
    off[55] = 0.9992F;
    const Judgement found = buffer(depth(10, 10, off), depth(10, 10, expected), absolute(1e-3));
    EXPECT_EQ(found.right, 0.5);
    EXPECT_EQ(found.metrics.at("extra"), 1);
}

TEST(Buffer, every_component_matters)
{
    const auto pair = [](float a, float b) {
        Tensor tensor = floats({0, 0, a, b, 0, 0}, 2);
        tensor.columns = 3;
        tensor.rows = 1;
        return tensor;
    };
    EXPECT_EQ(buffer(pair(0.9F, 0.25F), pair(0.2F, 0.2F), absolute(0.1)).right, 0);
    EXPECT_EQ(buffer(pair(0.25F, 0.9F), pair(0.2F, 0.2F), absolute(0.1)).right, 0);
    EXPECT_EQ(buffer(pair(0.25F, 0.25F), pair(0.2F, 0.2F), absolute(0.1)).right, 1);
}

TEST(Buffer, presence_must_agree)
{
    Tensor expected = depth(2, 2, {0, 0, 0, 1});
    expected.present = {0, 0, 0, 1};
    Tensor absent = depth(2, 2, {0, 0, 0, 0});
    absent.present = {0, 0, 0, 0};
    EXPECT_EQ(buffer(absent, expected).metrics.at("missing"), 1);
    EXPECT_EQ(buffer(expected, absent).metrics.at("extra"), 1);
    EXPECT_EQ(buffer(expected, expected).right, 1);
}

}
}
