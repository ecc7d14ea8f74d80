#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "explaining.hpp"
#include "judge/cost/answers.hpp"
#include "judge/cost/cost.hpp"

namespace umbral::grader::test {
namespace {

const std::vector<double> sizes{1000, 2000, 4000, 8000, 16000};

/// Rows (size, blocks of that size).
Tensor cost(const std::function<double(double)>& blocks)
{
    std::vector<double> values;
    for (const double size : sizes) values.insert(values.end(), {size, blocks(size)});
    return doubles(values, 2);
}

Tensor power(double exponent, double factor = 3)
{
    return cost([=](double n) { return factor * std::pow(n, exponent); });
}

Judgement judged(const Tensor& yours, double growth = 1, const Tensor* names = nullptr)
{
    Check check = check_of(JudgeKind{"cost"});
    check.own = CostParameters{growth};
    return judge(check, yours, power(1), nullptr, names);
}

TEST(Costs, the_exponent_is_the_slope)
{
    EXPECT_NEAR(judged(power(1)).metrics.at("exponent"), 1, 1e-12);
    EXPECT_NEAR(judged(power(2)).metrics.at("exponent"), 2, 1e-12);
    EXPECT_NEAR(judged(power(1.5)).metrics.at("reference_exponent"), 1, 1e-12);
    // By hand: (1, 1), (2, 2), (4, 8) has in log2 the points (0, 0), (1, 1), (2, 3): slope ((-1)(-4/3) + 0 + (1)(5/3))
    // / 2 = 3/2.
    EXPECT_NEAR(growth_of({{1, 1}, {2, 2}, {4, 8}}), 1.5, 1e-12);
}

TEST(Costs, credit_falls_between_the_two_exponents)
{
    EXPECT_EQ(judged(power(1)).right, 1);
    EXPECT_EQ(judged(power(1.14)).right, 1);
    EXPECT_NEAR(judged(power(1.375)).right, 0.5, 1e-9);
    EXPECT_EQ(judged(power(1.61)).right, 0);
    EXPECT_EQ(judged(power(2)).right, 0);
    EXPECT_EQ(judged(power(0.5, 30)).right, 1) << "less growth is no fault";
    EXPECT_EQ(judged(power(2), 2).right, 1);
    EXPECT_EQ(judged(cost([](double n) { return n * std::log2(n); })).right, 1) << "n log n passes for linear";
}

TEST(Costs, the_message_says_how_the_work_grows)
{
    // 3 n^2 + 100000: 2.1 and 768.1 million... a quotient of 768100000 / 3100000 = 247.8.
    const Tensor noun = table(Element::uint8, 1, std::vector<char>{'f', 'a', 'c', 'e', 's'});
    const Judgement found = judged(cost([](double n) { return 3 * n * n + 100000; }), 1, &noun);
    EXPECT_EQ(found.message,
              "from 1,000 to 16,000 faces your work grows 248-fold (like n^2.0); linear is possible (the reference: "
              "16-fold)");
    EXPECT_EQ(found.first_difference->where, "16,000 faces");
    EXPECT_EQ(found.first_difference->yours, "768,100,000 steps");
    EXPECT_EQ(found.first_difference->expected, "48,000 steps");
    EXPECT_DOUBLE_EQ(found.metrics.at("blocks_per_item"), 768100000.0 / 16000);
    EXPECT_NE(judged(power(2)).message.find("16,000 items"), std::string::npos);
}

TEST(Costs, doing_nothing_is_not_quick)
{
    for (const double blocks : {0.0, 1.0, 2.0, 900.0}) {
        const Judgement found = judged(cost([=](double) { return blocks; }));
        EXPECT_EQ(found.right, 0) << blocks;
        EXPECT_NE(found.message.find("next to nothing is done"), std::string::npos) << found.message;
    }
    EXPECT_EQ(judged(power(1, 0.5)).right, 1) << "a sixth of the reference's work is fine";
}

TEST(Costs, hostile_ones_earn_nothing)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity, -5.0}) {
        EXPECT_EQ(judged(cost([=](double n) { return n == 4000 ? bad : n; })).right, 0) << bad;
        std::vector<double> other{bad, 1000};
        EXPECT_EQ(judged(doubles(other, 2)).right, 0);
    }
    EXPECT_EQ(judged(cost([=](double n) { return n == 4000 ? 0 : n; })).right, 0);
    EXPECT_EQ(judged(Tensor{}).message, "no work was counted for the size 1,000");
    EXPECT_EQ(judged(doubles({1000, 3000, 2000, 6000}, 2)).message, "no work was counted for the size 4,000");
    EXPECT_EQ(judged(doubles(std::vector<double>(4'000'000, 1.0), 2)).right, 0);
    EXPECT_EQ(judged(floats({1, 2}, 2)).right, 0);
    for (const auto& [name, value] : judged(cost([](double) { return 1e308; })).metrics)
        EXPECT_TRUE(std::isfinite(value)) << name;
}

TEST(Costs, the_sizes_must_be_those_that_were_tried)
{
    std::vector<double> others;
    for (const double size : sizes) others.insert(others.end(), {size + 1, 3 * size});
    EXPECT_EQ(judged(doubles(others, 2)).message, "no work was counted for the size 1,000");
    std::vector<double> more;
    for (const double size : sizes) more.insert(more.end(), {size, 3 * size});
    more.insert(more.end(), {32000, 96000});
    EXPECT_EQ(judged(doubles(more, 2)).right, 0);
    EXPECT_NE(judged(doubles(more, 2)).message.find("more sizes were counted"), std::string::npos);
}

TEST(Costs, what_cannot_be_judged_is_a_grader_fault)
{
    Check check = check_of(JudgeKind{"cost"});
    check.own = CostParameters{1};
    const auto fault_of = [&](const Tensor& bad) -> std::string {
        try {
            (void)judge(check, bad, bad, nullptr);
        } catch (const std::invalid_argument& fault) {
            return fault.what();
        }
        return "";
    };
    EXPECT_TRUE(fault_of(doubles({1000, 5}, 2)).ends_with("growth needs at least two sizes"));
    EXPECT_TRUE(fault_of(doubles({1000, 5, 1000, 6}, 2)).ends_with("the sizes must increase"));
    EXPECT_TRUE(fault_of(doubles({2000, 5, 1000, 6}, 2)).ends_with("the sizes must increase"));
    for (const Tensor& bad : {doubles({1000, 0, 2000, 5}, 2), doubles({0, 1, 2000, 5}, 2)})
        EXPECT_TRUE(fault_of(bad).ends_with("sizes and counts must be positive")) << fault_of(bad);
    for (const Tensor& bad : {floats({1000, 5, 2000, 6}, 2), doubles({1000, 2000}, 1)})
        EXPECT_NE(fault_of(bad).find("costs are rows of two doubles"), std::string::npos) << fault_of(bad);
}

TEST(Costs, controls_and_mistakes)
{
    Check check = check_of(JudgeKind{"cost"});
    check.own = CostParameters{};
    EXPECT_EQ(best_control(check, power(1), nullptr, 1).right, 0);
    const auto same = [&](const Tensor& yours, const Tensor& mistake) {
        const Tensor expected = power(1);
        return resemblance(FailingCheck{&check, &yours, &expected, nullptr}, mistake).says == Says::for_it;
    };
    EXPECT_TRUE(same(power(2), power(1.9, 50)));
    EXPECT_FALSE(same(power(2), power(1.7)));
    EXPECT_FALSE(same(power(1), power(1)));
    EXPECT_FALSE(same(power(2), power(1)));
    EXPECT_TRUE(same(power(0, 1), power(0, 2))) << "both return at once";
    EXPECT_FALSE(same(power(0, 1), power(2)));
}

// Work is counted for answers that are right: whoever gives up on large problems saves it.
TEST(CostAnswers, are_right_row_by_row)
{
    const Tensor expected = floats({10, 0.5, 20, 0.25, 40, 0.125}, 2);
    const auto row_of = [](const std::optional<WrongAnswer>& one) {
        return one ? std::optional(one->row) : std::nullopt;
    };
    const auto wrong = [&](const Tensor& yours) { return row_of(first_wrong_answer(&yours, &expected)); };
    const float nan = std::nanf("");
    EXPECT_EQ(wrong(expected), std::nullopt);
    EXPECT_EQ(wrong(floats({10, 0.5002F, 20, 0.25, 40.02F, 0.125}, 2)), std::nullopt) << "sums in another order";
    EXPECT_EQ(wrong(floats({10, 0.5, 21, 0.25, 40, 0.125}, 2)), 1U);
    EXPECT_EQ(wrong(floats({10, 0.5, 20, 0.25, 40, nan}, 2)), 2U);
    EXPECT_EQ(wrong(floats({10, 0.5, 20, 0.25}, 2)), 2U) << "a row is missing";
    EXPECT_EQ(wrong(floats({10, 0.5, 20, 0.25, 40, 0.125, 80, 1}, 2)), 3U) << "one too many";
    EXPECT_EQ(wrong(floats({10, 20, 40}, 1)), 0U);
    EXPECT_EQ(row_of(first_wrong_answer(nullptr, &expected)), 0U);
    EXPECT_EQ(row_of(first_wrong_answer(&expected, nullptr)), std::nullopt) << "where the driver records none";
}

TEST(CostAnswers, tell_the_first_number_that_differs)
{
    const Tensor expected = floats({10, 0.5, 20, 0.25}, 2);
    const Tensor yours = floats({10, 0.5, 20, 0.75}, 2);
    const std::optional<WrongAnswer> wrong = first_wrong_answer(&yours, &expected);
    ASSERT_TRUE(wrong && wrong->number);
    EXPECT_EQ(wrong->number->place, 1U);
    EXPECT_EQ(wrong->number->yours, 0.75);
    EXPECT_EQ(wrong->number->expected, 0.25);
    const Tensor short_one = floats({10, 0.5}, 2);
    EXPECT_FALSE(first_wrong_answer(&short_one, &expected)->number) << "there is none";
}

}
}
