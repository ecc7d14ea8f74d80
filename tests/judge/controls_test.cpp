#include <gtest/gtest.h>

#include <algorithm>

#include "judge/rows/tensor_view.hpp"
#include "make.hpp"

namespace umbral::grader::test {
namespace {

bool has(const std::vector<std::pair<std::string, Tensor>>& all, const std::string& name)
{
    return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.first == name; });
}

const Tensor& named(const std::vector<std::pair<std::string, Tensor>>& all, const std::string& name)
{
    return std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == name; })->second;
}

TEST(Controls, have_the_shape_of_the_expected_and_are_the_declared_ones)
{
    const Check check = check_of(JudgeKind{"numbers"}, absolute(0.1));
    const Tensor expected = optional_floats({1, 2, 0, 2, 5}, {1, 1, 0, 1, 1});
    const auto all = controls(check, expected, 1);
    for (const auto& [name, tensor] : all) {
        EXPECT_EQ(tensor.rows, 5U) << name;
        EXPECT_EQ(tensor.bytes.size(), expected.bytes.size()) << name;
        EXPECT_EQ(tensor.present.size(), 5U) << name;
    }
    EXPECT_EQ(named(all, "zeros"), optional_floats({0, 0, 0, 0, 0}, {1, 1, 1, 1, 1}));
    EXPECT_EQ(named(all, "ones"), optional_floats({1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}));
    EXPECT_EQ(named(all, "most frequent row"), optional_floats({2, 2, 2, 2, 2}, {1, 1, 1, 1, 1}));
    EXPECT_EQ(named(all, "mean row"), optional_floats({2.5, 2.5, 2.5, 2.5, 2.5}, {1, 1, 1, 1, 1}));
    EXPECT_EQ(named(all, "all absent"), optional_floats({0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}));
    EXPECT_FALSE(has(all, "identity"));
}

TEST(Controls, noise_stays_in_the_range_and_follows_its_seed)
{
    const Check check = check_of(JudgeKind{"numbers"}, absolute(0.1));
    std::vector<float> values(1000, 3.0F);
    values[0] = 2;
    values[1] = 5;
    const auto one = controls(check, floats(values), 7);
    EXPECT_EQ(named(one, "noise"), named(controls(check, floats(values), 7), "noise"));
    EXPECT_NE(named(one, "noise"), named(controls(check, floats(values), 8), "noise"));
    std::vector<float> noise(1000);
    std::memcpy(noise.data(), named(one, "noise").bytes.data(), 4000);
    EXPECT_GE(*std::min_element(noise.begin(), noise.end()), 2);
    EXPECT_LE(*std::max_element(noise.begin(), noise.end()), 5);
    EXPECT_GT(*std::max_element(noise.begin(), noise.end()) - *std::min_element(noise.begin(), noise.end()), 2.5F);
}

// By chance a draw of noise is all right in one of 512 such tables: right work would earn nothing there.
TEST(Controls, no_few_answers_are_all_right_by_chance)
{
    const Check check = check_of(JudgeKind{"numbers"}, absolute(0));
    const Tensor answers = grid(1, 9, {1, 0, 0, 1, 1, 0, 1, 0, 1});
    for (std::uint64_t seed = 0; seed < 3000; ++seed)
        ASSERT_LT(best_control(check, answers, nullptr, seed).right, 0.9) << seed;
}

TEST(Controls, the_best_one_is_found)
{
    const Check numbers = check_of(JudgeKind{"numbers"}, absolute(0.1));
    const BestControl frequent = best_control(numbers, floats({1, 2, 4, 4, 4}), nullptr, 1);
    EXPECT_EQ(frequent.name, "most frequent row");
    EXPECT_DOUBLE_EQ(frequent.right, 0.6);

    const std::vector<float> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    std::vector<float> matrices = identity;
    for (std::size_t i = 0; i < 16; ++i) matrices.push_back(identity[i] + 3);
    const BestControl unit =
        best_control(check_of(JudgeKind{"matrices"}, absolute(0.1)), floats(matrices, 16), nullptr, 1);
    EXPECT_EQ(unit.name, "identity");
    EXPECT_DOUBLE_EQ(unit.right, 0.5);

    const BestControl absent = best_control(numbers, optional_floats({0, 0, 0, 9}, {0, 0, 0, 1}), nullptr, 1);
    EXPECT_EQ(absent.name, "all absent");
    EXPECT_DOUBLE_EQ(absent.right, 0.75);
}

TEST(Controls, in_pairs_no_constant_answer_earns_anything)
{
    Check check = check_of(JudgeKind{"numbers"}, absolute(1e-3));
    check.pairs = true;
    std::vector<float> values;
    std::vector<std::uint8_t> present;
    for (int i = 0; i < 100; ++i) {
        const bool hit_first = i % 5 < 3;
        values.insert(values.end(), {hit_first ? 2.0F : 0.0F, hit_first ? 0.0F : 2.0F});
        present.insert(present.end(), {std::uint8_t{hit_first}, std::uint8_t{!hit_first}});
    }
    const Tensor expected = optional_floats(values, present);
    for (const auto& [name, tensor] : controls(check, expected, 5)) {
        const double right = judge(check, tensor, expected, nullptr).right;
        // Noise guesses a pair's presence one time in four, but the values are all one number here: what remains is
        // bounded by that.
        if (name == "noise")
            EXPECT_LE(right, 0.4);
        else
            EXPECT_DOUBLE_EQ(right, name == "pairs by chance" ? 0.5 : 0) << name;
    }
}

TEST(Controls, pairs_by_chance_are_half_of_the_most_frequent_ones)
{
    Check check = check_of(JudgeKind{"numbers"}, absolute(1e-3));
    check.pairs = true;
    const auto pairs = [&](const Tensor& expected) { return named(controls(check, expected, 1), "pairs by chance"); };
    EXPECT_EQ(pairs(floats({3, 7, 1, 0, 0, 1, 1, 0})), floats({1, 0, 0, 1, 0, 1, 0, 1}));
    // The same numbers, present and not, are two pairs: here that whose 0 is absent, three times.
    EXPECT_EQ(pairs(optional_floats({0, 4, 0, 4, 0, 4, 4, 0, 4, 0}, {1, 1, 0, 1, 1, 1, 1, 0, 1, 0})),
              optional_floats({4, 0, 4, 0, 4, 0, 4, 0, 0, 4}, {1, 0, 1, 0, 1, 0, 1, 0, 0, 1}));
    check.pairs = false;
    EXPECT_FALSE(has(controls(check, floats({1, 0, 1, 0}), 1), "pairs by chance"));
}

// A check of a few pairs, all of which chance put in one order: right work lost its points to a control.
TEST(Controls, right_work_earns_all_however_its_pairs_are_ordered)
{
    Check check = check_of(JudgeKind{"numbers"}, absolute(1e-3));
    check.pairs = true;
    for (const Tensor& expected :
         {floats({1, 0, 1, 0, 1, 0}), floats({0, 1, 0, 1, 0, 1}), floats({1, 0}), floats({1, 0, 0, 1, 1, 0, 1, 0})}) {
        const BestControl best = best_control(check, expected, nullptr, 1);
        EXPECT_LE(best.right, 0.5) << best.name;
        EXPECT_EQ(points_for(check, 1, best.right), check.points);
    }
}

TEST(Controls, no_picture_without_a_scene_earns_much)
{
    const Check check = check_of(JudgeKind{"image"});
    const auto all = controls(check, balls(), 3);
    for (const char* name : {"blank", "mean colour", "black", "white", "noise", "zeros", "ones"})
        EXPECT_TRUE(has(all, name)) << name;
    EXPECT_EQ(named(all, "blank"), repaint(balls(), [](int, int) { return Colour{8, 10, 40, 255}; }));
    EXPECT_EQ(best_control(check, balls(), nullptr, 3).right, 0);
    // 2.5 % of content: where whole-picture measures give a blank picture 95 of 100.
    const Tensor sparse = picture(200, 200, [](int x, int y) {
        return (x - 100) * (x - 100) + (y - 90) * (y - 90) < 18 * 18 ? Colour{byte(100 + x / 4), 80, 60, 255}
                                                                     : Colour{0, 0, 0, 255};
    });
    EXPECT_EQ(best_control(check, sparse, nullptr, 3).right, 0);
}

TEST(Controls, a_blank_picture_is_the_borders_colour_and_white_is_white)
{
    std::vector<std::uint32_t> framed(64, 3);
    for (std::size_t i = 0; i < 64; ++i)
        if (i < 8 || i >= 56 || i % 8 == 0 || i % 8 == 7) framed[i] = 9;
    EXPECT_EQ(named(controls(check_of(JudgeKind{"buffer"}), grid(8, 8, framed), 1), "blank"),
              grid(8, 8, std::vector<std::uint32_t>(64, 9)));
    const auto pictures = controls(check_of(JudgeKind{"image"}), scene(), 1);
    EXPECT_EQ(named(pictures, "white"), repaint(scene(), [](int, int) { return Colour{255, 255, 255, 255}; }));
    EXPECT_EQ(named(pictures, "black"), repaint(scene(), [](int, int) { return Colour{0, 0, 0, 0}; }));
    Check grey = check_of(JudgeKind{"image"});
    grey.range_low = 2;
    grey.range_high = 5;
    EXPECT_EQ(named(controls(grey, depth(2, 1, {3, 4}), 1), "white"), depth(2, 1, {5, 5}));
    EXPECT_EQ(named(controls(grey, depth(2, 1, {3, 4}), 1), "black"), depth(2, 1, {2, 2}));
}

TEST(Controls, of_costs_is_a_function_that_returns_at_once)
{
    const auto all = controls(check_of(JudgeKind{"cost"}), doubles({1000, 50, 2000, 100}, 2), 1);
    ASSERT_TRUE(has(all, "returns at once"));
    EXPECT_EQ(named(all, "returns at once"), doubles({1000, 1, 2000, 1}, 2));
}

TEST(Controls, integers_are_rounded_and_stay_in_their_range)
{
    const double values[] = {1.6, -3.0, 5e9};
    EXPECT_EQ(with_values(grid(3, 1, {0, 0, 0}), values), grid(3, 1, {2, 0, 4294967295U}));
    const double bytes[] = {0.5, 254.6, 300};
    EXPECT_EQ(with_values(table(Element::uint8, 1, std::vector<std::uint8_t>{0, 0, 0}), bytes),
              table(Element::uint8, 1, std::vector<std::uint8_t>{1, 255, 255}));
}

}
}
