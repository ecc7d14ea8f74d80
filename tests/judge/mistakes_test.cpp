#include <limits>

#include "explaining.hpp"

namespace umbral::grader::test {
namespace {

bool same(const Check& check, const Tensor& student, const Tensor& expected, const Tensor& mistake)
{
    return resemblance(FailingCheck{&check, &student, &expected, nullptr}, mistake).says == Says::for_it;
}

TEST(Mistakes, match_if_they_deviate_in_the_same_way)
{
    const Check check = check_of(JudgeKind{"numbers"}, ulps(2));
    const Tensor right = floats({1, 2, 3, 4});
    const Tensor mistake = floats({1, 2, 5, 6});
    EXPECT_TRUE(same(check, floats({1, 2, 5, std::nextafter(6.0F, 7.0F)}), right, mistake));
    EXPECT_FALSE(same(check, floats({1, 2, 5, 7}), right, mistake));
    EXPECT_FALSE(same(check, floats({1, 2, 5, 4}), right, mistake)) << "only half of it";
    EXPECT_FALSE(same(check, right, right, mistake)) << "the student is right";
    EXPECT_FALSE(same(check, mistake, right, right)) << "the mistake is right here";
    EXPECT_FALSE(same(check, floats({1, 2, 5}), right, mistake)) << "another shape";
    EXPECT_FALSE(same(check, mistake, right, floats({1, 2})));
}

// Degrees as radians, in float: the candidate had to round an argument which the student used as it came.
TEST(Mistakes, match_but_for_a_share_of_the_error_where_the_candidate_rounds)
{
    const Check check = check_of(JudgeKind{"numbers"}, ulps(2));
    const Tensor right = floats({1, 2, 3, 4});
    const Tensor mistake = floats({1, 2, 5, 6});
    const auto rounded = [&](const Tensor& student) {
        FailingCheck failing{&check, &student, &right, nullptr};
        failing.rounding = 1e-3;
        return resemblance(failing, mistake).says == Says::for_it;
    };
    EXPECT_TRUE(rounded(floats({1, 2, 5.001F, 6})));
    EXPECT_FALSE(same(check, floats({1, 2, 5.001F, 6}), right, mistake));
    EXPECT_FALSE(rounded(floats({1, 2, 5.01F, 6})));
    EXPECT_FALSE(rounded(floats({1, 2, 5.001F, 4}))) << "only half of it";
    EXPECT_FALSE(rounded(floats({1, 2, 5}))) << "another shape";
}

TEST(Mistakes, many_right_rows_do_not_make_two_errors_the_same)
{
    const Check check = check_of(JudgeKind{"numbers"}, ulps(2));
    std::vector<float> right(100, 1);
    auto student = right;
    auto mistake = right;
    student[3] = 7;
    mistake[90] = 8;
    EXPECT_FALSE(same(check, floats(student), floats(right), floats(mistake)));
}

TEST(Mistakes, what_is_not_finite_or_absent_on_both_sides_agrees)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Check check = check_of(JudgeKind{"numbers"}, ulps(2));
    EXPECT_TRUE(same(check, floats({nan, 2}), floats({1, 2}), floats({nan, 2})));
    EXPECT_FALSE(same(check, floats({nan, 2}), floats({1, 2}), floats({9, 2})));
    const Tensor right = optional_floats({1, 0}, {1, 0});
    EXPECT_TRUE(same(check, optional_floats({0, 0}, {0, 0}), right, optional_floats({0, 0}, {0, 0})));
    EXPECT_FALSE(same(check, optional_floats({0, 0}, {0, 0}), right, optional_floats({1, 5}, {1, 1})));
}

TEST(Mistakes, a_passing_check_speaks_against_a_mistake_that_fails_it_and_for_none)
{
    const Check check = check_of(JudgeKind{"numbers"}, ulps(2));
    const Tensor right = floats({1, 2, 3, 4});
    const FailingCheck passing{&check, &right, &right, nullptr, false};
    EXPECT_EQ(resemblance(passing, floats({1, 2, 5, 6})).says, Says::against_it);
    EXPECT_EQ(resemblance(passing, floats({1, 2})).says, Says::against_it) << "another shape fails it, too";
    EXPECT_EQ(resemblance(passing, right).says, Says::nothing);
}

TEST(Mistakes, a_check_that_is_passed_by_rounding_of_points_is_passed)
{
    Check check = check_of(JudgeKind{"buffer"});
    check.points = 250;
    std::vector<std::uint32_t> ids(10000, 0);
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = i % 100 > 0 && i % 100 < 99 && i > 99 && i < 9900 ? 7 : 0;
    const Tensor right = grid(100, 100, ids);
    ids[5050] = 8;
    const Tensor nearly = grid(100, 100, ids);
    ASSERT_LT(judge(check, nearly, right, nullptr).right, 1);
    ASSERT_EQ(points_for(check, judge(check, nearly, right, nullptr).right, 0), check.points);
    EXPECT_EQ(resemblance({&check, &nearly, &right, nullptr, false}, nearly).says, Says::nothing);
}

TEST(Mistakes, tables_of_the_same_wrong_size_agree_if_they_are_equal)
{
    const Check check = check_of(JudgeKind{"numbers"}, ulps(2));
    const Tensor right = floats({1, 2, 3, 4});
    const Tensor student = floats({1, 2});
    const FailingCheck failing{&check, &student, &right, nullptr};
    const Resemblance same = resemblance(failing, floats({1, 2}));
    EXPECT_EQ(same.says, Says::for_it);
    EXPECT_GT(same.bits, 0);
    EXPECT_EQ(resemblance(failing, floats({1, 3})).says, Says::against_it);
    EXPECT_EQ(resemblance(failing, floats({1, 2, 3})).says, Says::against_it);
    EXPECT_EQ(resemblance(failing, right).says, Says::against_it);
}

TEST(Mistakes, agreement_in_more_values_says_more)
{
    const Check check = check_of(JudgeKind{"numbers"}, ulps(2));
    const auto bits = [&](const std::vector<float>& wrong, const std::vector<float>& right) {
        const Tensor student = floats(wrong);
        const Tensor expected = floats(right);
        return resemblance(FailingCheck{&check, &student, &expected}, student).bits;
    };
    const double zeros = bits({0, 0, 0, 0}, {1.5F, 2.5F, 3.5F, 4.5F});
    const double one = bits({1.5F, 2.5F, 3.5F, 9.5F}, {1.5F, 2.5F, 3.5F, 4.5F});
    const double four = bits({6.5F, 7.5F, 8.5F, 9.5F}, {1.5F, 2.5F, 3.5F, 4.5F});
    EXPECT_LE(zeros, 1) << "many errors give zeros";
    EXPECT_GT(one, zeros);
    EXPECT_GT(four, one);
    EXPECT_EQ(bits({6.5F, 6.5F, 6.5F, 6.5F}, {1.5F, 2.5F, 3.5F, 4.5F}), bits({6.5F}, {1.5F}))
        << "the same value four times is one value";
}

TEST(Mistakes, of_matrices_buffers_and_pictures)
{
    const std::vector<float> unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<float> twice{2, 0, 0, 0, 2, 0, 0, 0, 2};
    const std::vector<float> flat{1, 0, 0, 0, 1, 0, 0, 0, 0};
    const Check matrices = check_of(JudgeKind{"matrices"}, relative(1e-6));
    EXPECT_TRUE(same(matrices, floats(twice, 9), floats(unit, 9), floats(twice, 9)));
    EXPECT_FALSE(same(matrices, floats(twice, 9), floats(unit, 9), floats(flat, 9)));

    const Check buffer = check_of(JudgeKind{"buffer"});
    EXPECT_TRUE(same(buffer, grid(2, 2, {1, 1, 1, 3}), grid(2, 2, {1, 1, 1, 2}), grid(2, 2, {1, 1, 1, 3})));
    EXPECT_FALSE(same(buffer, grid(2, 2, {1, 1, 1, 3}), grid(2, 2, {1, 1, 1, 2}), grid(2, 2, {1, 1, 1, 4})));
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(
        same(buffer, depth(3, 1, {infinity, 1, 2}), depth(3, 1, {infinity, 1, 1}), depth(3, 1, {infinity, 1, 2})));

    const Check image = check_of(JudgeKind{"image"});
    const auto tinted = [](int by) {
        return repaint(balls(), [by](int x, int y) {
            Colour colour = pixel(scene(), x, y);
            colour.g = byte(colour.g + by);
            return colour;
        });
    };
    EXPECT_TRUE(same(image, tinted(60), balls(), tinted(60)));
    EXPECT_TRUE(same(image, tinted(61), balls(), tinted(60)));
    EXPECT_FALSE(same(image, tinted(60), balls(), tinted(90)));
    EXPECT_FALSE(same(image, tinted(1), balls(), tinted(60)));
}

}
}
