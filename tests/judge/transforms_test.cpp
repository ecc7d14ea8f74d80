#include "judge/explain/transforms.hpp"

#include <limits>

#include "explaining.hpp"

namespace umbral::grader::test {
namespace {

TEST(Transforms, a_median_is_the_middle)
{
    EXPECT_EQ(median({9, 1, 5, 7, 3}), 5);
    EXPECT_EQ(median({}), std::nullopt);
    // What most values have in common counts, whatever the smallest are.
    const auto pairs = value_pairs(floats({2, 4, 6, 0, 10, 12, 0}), floats({1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(common_factor(pairs), 2);
}

TEST(Transforms, two_different_numbers_make_no_rule)
{
    EXPECT_FALSE(enough_to_fit(value_pairs(floats({5, 5, 7, 7}), floats({1, 1, 2, 2}))));
    EXPECT_FALSE(enough_to_fit(value_pairs(floats({5, 5, 7}), floats({1, 2, 0}))))
        << "nothing times a factor is nothing";
    EXPECT_TRUE(enough_to_fit(value_pairs(floats({5, 6, 7}), floats({1, 2, 3}))));
}

TEST(Transforms, distance_grows_with_how_far_apart_values_are)
{
    const Tensor zero = floats({0, 0});
    EXPECT_EQ(distance(floats({3, -4}), zero), 7);
    EXPECT_GT(distance(floats({std::numeric_limits<float>::quiet_NaN(), 0}), zero),
              distance(floats({3e38F, 3e38F}), zero))
        << "no number is farther than any";
}

TEST(Transforms, what_is_right_and_no_unit_vector_speaks_not_against_normalising)
{
    const Check numbers = check_of(JudgeKind{"numbers"}, absolute(1e-6));
    const Tensor unit = floats({1, 0, 0, 0, 0.6F, 0.8F, 0, -1, 0}, 3);
    const Tensor longer = floats({3, 0, 0, 0, 1.5F, 2, 0, -7, 0}, 3);
    const Tensor places = floats({2, 3, 4, 5, 6, 7, 8, 9, 1}, 3);
    FailingCheck lengths{&numbers, &longer, &unit};
    FailingCheck right{&numbers, &places, &places};
    right.fails = false;
    const auto found = explain_by_transform({lengths, right});
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().name, "not normalised");
    EXPECT_EQ(found.front().fit, 1);
}

}
}
