#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <umbral/record/not_finite.hpp>

#include "make.hpp"

namespace umbral::grader::test {
namespace {

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity_f = std::numeric_limits<float>::infinity();

float up(float value, int steps)
{
    for (int i = 0; i < steps; ++i) value = std::nextafter(value, infinity_f);
    return value;
}

Judgement numbers(const Tensor& student, const Tensor& expected, Tolerance tolerance, const Tensor* margin = nullptr)
{
    return judge(check_of(JudgeKind{"numbers"}, tolerance), student, expected, margin);
}

TEST(Numbers, whole_ones_are_told_digit_by_digit)
{
    const Judgement ids = numbers(floats({10074125}), floats({66051}), ulps(0));
    EXPECT_EQ(ids.first_difference->yours, "10074125");
    EXPECT_EQ(ids.first_difference->expected, "66051");
    // Codes have up to 32 bits. What is whole beyond them is rounding.
    EXPECT_EQ(numbers(floats({4294967808.0F}), floats({-3e20F}), ulps(0)).first_difference->yours, "4.29497e+09");
    EXPECT_EQ(numbers(floats({16777218}), floats({-3e20F}), ulps(0)).first_difference->yours, "16777218");
    EXPECT_EQ(numbers(floats({16777216}), floats({1000000.5F}), ulps(0)).first_difference->yours, "16777216");
    // Their neighbours are told alike: 1001600.3, and not 1.0016e+06.
    const Judgement sums = numbers(floats({1001600.3125F}), floats({1001600}), ulps(0));
    EXPECT_EQ(sums.first_difference->yours, "1001600.3");
    EXPECT_EQ(sums.first_difference->expected, "1001600");
}

TEST(Numbers, equal_ones_are_right_and_say_nothing)
{
    const Judgement found = numbers(floats({1, 2, 3}), floats({1, 2, 3}), ulps(0));
    EXPECT_EQ(found.right, 1);
    EXPECT_EQ(found.error, 0);
    EXPECT_EQ(found.message, "");
    EXPECT_FALSE(found.first_difference);
    EXPECT_EQ(found.metrics.at("rows"), 3);
    EXPECT_EQ(found.metrics.at("wrong"), 0);
}

TEST(Numbers, ulps_are_counted_as_floats_of_the_expected)
{
    for (const float value : {1.0F, -3.7F, 1e-20F, 6e30F, 1e-42F}) {
        const Tensor off = floats({value > 0 ? up(value, 3) : -up(-value, 3)});
        EXPECT_EQ(numbers(off, floats({value}), ulps(3)).right, 1) << value;
        EXPECT_EQ(numbers(off, floats({value}), ulps(2.5)).right, 0) << value;
        EXPECT_NEAR(*numbers(off, floats({value}), ulps(2.5)).error, 3, 1e-9) << value;
    }
    // Doubles beside the expected one lie a fraction of a float's ulp away: 2^-23 at 1.
    EXPECT_NEAR(*numbers(doubles({1 + 0x1p-24}), doubles({1}), ulps(1)).error, 0.5, 1e-12);
    EXPECT_EQ(numbers(doubles({1e300}), doubles({1.1e300}), ulps(1)).right, 0);
}

TEST(Numbers, a_component_is_called_by_its_name)
{
    const auto judged = [](const Tensor& yours, const Tensor& expected, const Tensor* names) {
        return judge(check_of(JudgeKind{"numbers"}, ulps(0)), yours, expected, nullptr, names);
    };
    const Judgement vector = judged(floats({1, 7, 3}, 3), floats({1, 2, 3}, 3), nullptr);
    EXPECT_EQ(vector.first_difference->where, "row 0, y");
    EXPECT_EQ(vector.first_difference->yours, "(1, 7, 3)");
    EXPECT_EQ(judged(floats({8, 7, 3}, 3), floats({1, 2, 3}, 3), nullptr).first_difference->where, "row 0");

    Check colors = check_of(JudgeKind{"numbers"}, ulps(0));
    colors.value = "reflected light";
    EXPECT_EQ(judge(colors, floats({1, 7, 3}, 3), floats({1, 2, 3}, 3), nullptr).first_difference->where, "row 0, g");

    const Tensor names = text("colour/4, GL_LINE_WIDTH, GL_CULL_FACE");
    const Tensor state = floats({0, 0, 0, 1, 2, 1}, 6);
    const Judgement width = judged(floats({0, 0, 0, 1, 1, 1}, 6), state, &names);
    EXPECT_EQ(width.message,
              "The only row is wrong: row 0, GL_LINE_WIDTH: yours 1, expected 2 (far more than rounding)");
    EXPECT_EQ(width.headline, "The only row is wrong: row 0, GL_LINE_WIDTH");
    const Judgement several = judged(floats({0, 0, 5, 1, 1, 0}, 6), state, &names);
    EXPECT_EQ(several.first_difference->where, "row 0, colour.b and 2 others of it");
    EXPECT_EQ(several.first_difference->yours, "5");

    const Tensor too_few = text("colour/4, GL_LINE_WIDTH");
    EXPECT_EQ(judged(floats({0, 0, 0, 1, 1, 1}, 6), state, &too_few).first_difference->where, "row 0");
}

TEST(Numbers, relative_is_of_the_largest_component_of_the_row)
{
    const Tensor expected = floats({100, 0, 1}, 3);
    EXPECT_EQ(numbers(floats({100, 0.5F, 1.5F}, 3), expected, relative(0.006)).right, 1);
    EXPECT_EQ(numbers(floats({100, 0.5F, 1.5F}, 3), expected, relative(0.004)).right, 0);
    EXPECT_NEAR(*numbers(floats({100, 0.5F, 1.25F}, 3), expected, relative(0.1)).error, 0.005, 1e-9);
}

TEST(Numbers, any_given_bound_is_enough)
{
    const Tolerance both{1e-3, {}, 1, {}};
    EXPECT_EQ(numbers(floats({1e-4F, 1e9F}, 2), floats({0, 1e9F}, 2), both).right, 1);
    EXPECT_EQ(numbers(floats({1e-2F, 1e9F}, 2), floats({0, 1e9F}, 2), both).right, 0);
    // What only the absolute bound excuses does not become an error of 1e41 ulp.
    EXPECT_EQ(numbers(floats({1e-4F, up(1e9F, 1)}, 2), floats({0, 1e9F}, 2), both).error, 1);
}

TEST(Numbers, one_wrong_component_makes_the_row_wrong)
{
    for (std::size_t wrong = 0; wrong < 3; ++wrong) {
        std::vector<float> values{1, 2, 3, 4, 5, 6};
        values[3 + wrong] += 1;
        const Judgement found = numbers(floats(values, 3), floats({1, 2, 3, 4, 5, 6}, 3), absolute(0.5));
        EXPECT_EQ(found.right, 0.5);
        EXPECT_EQ(found.first_difference->where, std::string("row 1, ") + "xyz"[wrong]);
    }
}

TEST(Numbers, what_is_not_finite_is_wrong_without_a_finite_error)
{
    for (const float bad : {nan_f, infinity_f, -infinity_f}) {
        const Judgement found = numbers(floats({1, bad, 3, 4}), floats({1, 2, 3, 4}), absolute(1e30));
        EXPECT_EQ(found.right, 0.75);
        EXPECT_FALSE(found.error);
        EXPECT_NE(found.message.find("row 1"), std::string::npos) << found.message;
        for (const auto& [name, value] : found.metrics) EXPECT_TRUE(std::isfinite(value)) << name;
    }
    EXPECT_THROW((void)numbers(floats({1}), floats({nan_f}), absolute(1)), std::invalid_argument);
    EXPECT_THROW((void)numbers(floats({infinity_f}), floats({infinity_f}), absolute(1)), std::invalid_argument);
}

TEST(Numbers, infinities_may_be_right_where_drivers_record_numbers_for_them)
{
    const Tensor expected = floats({recordable(infinity_f), recordable(-infinity_f), recordable(nan_f), 1});
    EXPECT_EQ(numbers(expected, expected, relative(1e-6)).right, 1);
    const Judgement found = numbers(floats({recordable(infinity_f), recordable(infinity_f), recordable(nan_f), 1}),
                                    expected, relative(1e-6));
    EXPECT_EQ(found.right, 0.75);
    EXPECT_NE(found.message.find("yours inf, expected -inf"), std::string::npos) << found.message;
    const Judgement largest =
        numbers(floats({std::numeric_limits<float>::max()}), floats({recordable(infinity_f)}), relative(0.25));
    EXPECT_EQ(largest.right, 0);
    EXPECT_NE(largest.message.find("yours 3.40282e+38, expected inf"), std::string::npos) << largest.message;
    EXPECT_EQ(numbers(floats({5}), floats({recordable(nan_f)}), relative(0.25)).first_difference->expected, "nan");
    EXPECT_EQ(recordable(-2.5), -2.5);
}

TEST(Numbers, presence_must_agree)
{
    const Tensor expected = optional_floats({1, 0, 3, 0}, {1, 0, 1, 0});
    EXPECT_EQ(numbers(expected, expected, ulps(1)).right, 1);
    const Judgement found = numbers(optional_floats({0, 2, 3, 0}, {0, 1, 1, 0}), expected, ulps(1));
    EXPECT_EQ(found.right, 0.5);
    EXPECT_EQ(found.metrics.at("missing_hits"), 1);
    EXPECT_EQ(found.metrics.at("false_hits"), 1);
    EXPECT_EQ(found.first_difference->yours, "nothing");
    EXPECT_EQ(found.first_difference->expected, "1");
    const Judgement blind = numbers(optional_floats({0, 0, 0, 4}, {0, 0, 0, 1}), expected, ulps(1));
    EXPECT_EQ(blind.metrics.at("missing_hits"), 2);
    EXPECT_EQ(blind.metrics.at("false_hits"), 1);
    // A hit at 0 is not a miss.
    EXPECT_EQ(numbers(optional_floats({0}, {1}), optional_floats({0}, {0}), absolute(1)).right, 0);
    // All present, said in two ways.
    EXPECT_EQ(numbers(optional_floats({5}, {1}), floats({5}), ulps(1)).right, 1);
}

TEST(Numbers, rows_in_the_band_do_not_count)
{
    const Tolerance tolerance{{}, {}, 1, 2};
    const Tensor expected = floats({1, 2, 3, 4});
    const Tensor margin = floats({5, 1, 2, -1});
    EXPECT_EQ(numbers(floats({1, 9, 3, 9}), expected, tolerance, &margin).right, 1);
    EXPECT_EQ(numbers(floats({1, 9, 9, 9}), expected, tolerance, &margin).right, 0.5);
    EXPECT_EQ(numbers(floats({1, 9, 3, 9}), expected, ulps(1), &margin).right, 0.5)
        << "without a band every row counts";
    EXPECT_EQ(numbers(floats({1, nan_f, 3, 4}), expected, tolerance, &margin).error, 0)
        << "what does not count has no error";
    const Tensor all_close = floats({0, 0, 0, nan_f});
    EXPECT_THROW((void)numbers(expected, expected, tolerance, &all_close), std::invalid_argument);
    const Tensor short_margin = floats({1});
    EXPECT_THROW((void)numbers(expected, expected, tolerance, &short_margin), std::invalid_argument);
}

TEST(Numbers, pairs_count_only_together)
{
    Check check = check_of(JudgeKind{"numbers"}, ulps(1));
    check.pairs = true;
    const Tensor expected = optional_floats({1, 0, 3, 0, 5, 0}, {1, 0, 1, 0, 1, 0});
    EXPECT_EQ(judge(check, expected, expected, nullptr).right, 1);
    // Always absent: half of the rows are right, no pair is.
    const Judgement found = judge(check, optional_floats({0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}), expected, nullptr);
    EXPECT_EQ(found.right, 0);
    EXPECT_EQ(found.metrics.at("wrong"), 3);
    EXPECT_EQ(found.metrics.at("wrong_pairs"), 3);
    EXPECT_THROW((void)judge(check, floats({1}), floats({1}), nullptr), std::invalid_argument);
    // A row in the band takes its partner along.
    check.tolerance.band_ulps = 2;
    const Tensor margin = floats({9, 1, 9, 9, 9, 9});
    EXPECT_EQ(judge(check, optional_floats({7, 7, 3, 0, 5, 0}, {1, 1, 1, 0, 1, 0}), expected, &margin).right, 1);
}

TEST(Numbers, another_shape_type_or_damage_is_wrong_and_says_so)
{
    const Tensor expected = floats({1, 2, 3, 4});
    Tensor damaged = expected;
    damaged.bytes.pop_back();
    Tensor bad_presence = expected;
    bad_presence.present = {1};
    Tensor bad_element = expected;
    bad_element.element = static_cast<Element>(77);
    for (const Tensor& student : {floats({1, 2, 3}), floats({1, 2, 3, 4}, 2), doubles({1, 2, 3, 4}), floats({}),
                                  Tensor{}, damaged, bad_presence, bad_element}) {
        const Judgement found = numbers(student, expected, absolute(1e9));
        EXPECT_EQ(found.right, 0);
        EXPECT_FALSE(found.error);
        EXPECT_NE(found.message, "");
    }
    EXPECT_EQ(numbers(floats({1, 2, 3}), expected, absolute(1)).message,
              "Yours has 3 rows of 1 float; expected 4 rows of 1 float.");
}

TEST(Numbers, what_cannot_be_judged_is_a_grader_fault)
{
    EXPECT_THROW((void)numbers(floats({}), floats({}), absolute(1)), std::invalid_argument);
    EXPECT_THROW((void)numbers(floats({1}), floats({1}), Tolerance{}), std::invalid_argument);
    Tensor damaged = floats({1, 2});
    damaged.rows = 3;
    EXPECT_THROW((void)numbers(damaged, damaged, absolute(1)), std::invalid_argument);
    EXPECT_THROW((void)judge(check_of(JudgeKind{"guesses"}), floats({1}), floats({1}), nullptr), std::invalid_argument);
}

TEST(Numbers, codes_are_told_with_the_words_of_their_column)
{
    const Tensor names = text("what came of it (0: an answer; 1: std::invalid_argument; 2: another exception)");
    const auto difference = [&](float yours, float expected) {
        return *judge(check_of(JudgeKind{"numbers"}, ulps(0)), floats({yours}), floats({expected}), nullptr, &names)
                    .first_difference;
    };
    EXPECT_EQ(difference(2, 1).where, "row 0, what came of it");
    EXPECT_EQ(difference(2, 1).yours, "2 (another exception)");
    EXPECT_EQ(difference(2, 1).expected, "1 (std::invalid_argument)");
    EXPECT_EQ(difference(0.5F, 0).yours, "0.5");
    EXPECT_EQ(difference(3, 0).yours, "3");
    EXPECT_EQ(difference(3, 0).expected, "0 (an answer)");
    EXPECT_EQ(difference(std::numeric_limits<float>::quiet_NaN(), 0).yours, "nan");
    // Names that only look like it stay as they are.
    const Tensor plain = text("texels (first row: levels), rest");
    const auto pair =
        judge(check_of(JudgeKind{"numbers"}, ulps(0)), floats({1, 2}, 2), floats({0, 2}, 2), nullptr, &plain);
    EXPECT_EQ(pair.first_difference->where, "row 0, texels (first row: levels)");
    EXPECT_EQ(pair.first_difference->yours, "texels (first row: levels) 1, rest 2");
}

TEST(Numbers, the_message_names_the_worst_row)
{
    const Judgement found = numbers(floats({1, 2.5F, 3.25F, 4}), floats({1, 2, 4, 4}), absolute(0.1));
    EXPECT_EQ(found.message, "2 of 4 rows are wrong; the worst is row 2: yours 3.25, expected 4 (error 0.75)");
    EXPECT_EQ(found.first_difference->where, "row 1");
    EXPECT_EQ(numbers(floats({2}), floats({1}), relative(0.1)).message,
              "The only row is wrong: row 0: yours 2, expected 1 (relative error 1)");
}

TEST(Numbers, quantiles_are_of_the_errors)
{
    std::vector<float> yours;
    for (int i = 1; i <= 100; ++i) yours.push_back(static_cast<float>(i));
    const Judgement found = numbers(floats(yours), floats(std::vector<float>(100, 0.0F)), absolute(1000));
    EXPECT_EQ(found.metrics.at("median_error"), 50);
    EXPECT_EQ(found.metrics.at("p95_error"), 95);
    EXPECT_EQ(found.metrics.at("max_error"), 100);
}

TEST(Numbers, a_value_at_its_bound_is_right)
{
    EXPECT_EQ(numbers(floats({1.5F}), floats({1}), absolute(0.5)).right, 1);
    EXPECT_EQ(numbers(floats({1.5F}), floats({1}), relative(0.5)).right, 1);
    EXPECT_EQ(numbers(floats({5}), floats({0}), relative(0.5)).right, 0) << "nothing is relative to 0";
    EXPECT_EQ(numbers(floats({-100, 0.5F, 1}, 3), floats({-100, 0, 1}, 3), relative(0.01)).right, 1)
        << "a negative number is as large as a positive one";
}

TEST(Numbers, the_unit_of_errors_is_the_first_bound_of_ulps_relative_absolute)
{
    EXPECT_EQ(numbers(floats({up(1, 2)}), floats({1}), Tolerance{1.0, 1e-3, 4, {}}).error, 2);
    EXPECT_NEAR(*numbers(floats({1.5F}), floats({1}), Tolerance{0.25, 1.0, {}, {}}).error, 0.5, 1e-9);
}

TEST(Numbers, a_margins_sign_does_not_matter)
{
    const Tolerance tolerance{{}, {}, 1, 2};
    const Tensor margin = floats({5, -5});
    EXPECT_EQ(numbers(floats({1, 9}), floats({1, 2}), tolerance, &margin).right, 0.5);
}

}
}
