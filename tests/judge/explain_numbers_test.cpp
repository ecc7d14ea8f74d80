#include <algorithm>
#include <numbers>

#include "explaining.hpp"

namespace umbral::grader::test {
namespace {

constexpr std::uint64_t seed = 77;

std::vector<float> values_of(std::size_t count, float low = -2, float high = 3)
{
    Random random(seed);
    std::vector<float> values(count);
    for (float& v : values) v = random.uniform(low, high);
    return values;
}

std::vector<float> vectors(bool unit)
{
    Random random(seed);
    std::vector<float> values;
    for (int i = 0; i < 50; ++i) {
        const glm::vec3 v = random.unit_vector() * (unit ? 1.0F : random.uniform(0.5F, 4));
        values.insert(values.end(), {v.x, v.y, v.z});
    }
    return values;
}

template <class Change>
std::vector<float> changed(std::vector<float> values, Change change)
{
    std::transform(values.begin(), values.end(), values.begin(), change);
    return values;
}

const Check numbers = check_of(JudgeKind{"numbers"}, ulps(4));

template <class Change>
std::string first_after(Change change, float low = -2)
{
    const auto right = values_of(40, low);
    return first(numbers, floats(changed(right, change)), floats(right));
}

TEST(ExplainNumbers, one_error_one_explanation)
{
    EXPECT_EQ(first_after([](float v) { return -v; }), "negated");
    EXPECT_EQ(first_after([](float v) { return static_cast<float>(v * 180 / std::numbers::pi); }),
              "degrees for radians");
    EXPECT_EQ(first_after([](float v) { return static_cast<float>(v * std::numbers::pi / 180); }),
              "radians for degrees");
    EXPECT_EQ(first_after([](float v) { return 2 * v; }), "scaled");
    EXPECT_EQ(first_after([](float v) { return -0.5F * v; }), "scaled");
    EXPECT_EQ(first_after([](float v) { return 1 / v; }), "reciprocal");
    EXPECT_EQ(first_after([](float v) { return v + 1; }), "off by a constant");
    EXPECT_EQ(first_after([](float v) { return v * v; }, 0.1F), "squared");
    EXPECT_EQ(first_after([](float v) { return std::sqrt(v); }, 0.1F), "root taken");
}

TEST(ExplainNumbers, negatives_not_clamped)
{
    const auto raw = values_of(40);
    EXPECT_EQ(first(numbers, floats(raw), floats(changed(raw, [](float v) { return std::fmax(v, 0.0F); }))),
              "not clamped");
}

TEST(ExplainNumbers, vectors)
{
    const auto unit = vectors(true);
    auto longer = unit;
    Random random(seed);
    for (std::size_t i = 0; i < longer.size(); i += 3) {
        const float by = random.uniform(0.3F, 3);
        for (std::size_t c = 0; c < 3; ++c) longer[i + c] *= by;
    }
    EXPECT_EQ(first(numbers, floats(longer, 3), floats(unit, 3)), "not normalised");
    auto swapped = unit;
    for (std::size_t i = 0; i < swapped.size(); i += 3) std::swap(swapped[i + 1], swapped[i + 2]);
    const auto found = explain(numbers, floats(swapped, 3), floats(unit, 3));
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().name, "components swapped");
    EXPECT_NE(found.front().sentence.find("(x, z, y)"), std::string::npos) << found.front().sentence;
    EXPECT_EQ(first(numbers, floats(changed(unit, [](float v) { return -v; }), 3), floats(unit, 3)), "negated");
    // Vectors that are not meant to be unit do not become an excuse.
    EXPECT_EQ(first(numbers, floats(unit, 3), floats(vectors(false), 3)), "none");
}

TEST(ExplainNumbers, hits_behind_the_origin)
{
    const Tensor right = optional_floats({2, 0, 3, 0, 1, 0}, {1, 0, 1, 0, 1, 0});
    EXPECT_EQ(first(numbers, optional_floats({2, -4, 3, -1, 1, -2}, {1, 1, 1, 1, 1, 1}), right), "hits behind");
}

TEST(ExplainNumbers, the_factor_is_told)
{
    const auto right = values_of(40);
    const auto found = explain(numbers, floats(changed(right, [](float v) { return 3.25F * v; })), floats(right));
    ASSERT_FALSE(found.empty());
    EXPECT_NE(found.front().sentence.find("3.25"), std::string::npos) << found.front().sentence;
    EXPECT_GT(found.front().confidence, 0.99) << "forty numbers say much";
}

TEST(ExplainNumbers, unrelated_errors_have_no_explanation)
{
    const auto right = values_of(60);
    Random random(seed + 1);
    EXPECT_TRUE(
        explain(numbers, floats(changed(right, [&](float) { return random.uniform(-2, 3); })), floats(right)).empty());
    EXPECT_TRUE(explain(numbers, floats(std::vector<float>(60, 0.0F)), floats(right)).empty());
    EXPECT_TRUE(explain(numbers, floats(std::vector<float>(60, NAN)), floats(right)).empty());
    EXPECT_TRUE(explain(numbers, floats(changed(right, [](float v) { return v * v * v + 1; })), floats(right)).empty());
    EXPECT_TRUE(explain(numbers, floats({1, 2}), floats(right)).empty()) << "another shape";
    EXPECT_TRUE(explain(numbers, floats(right), floats(right)).empty()) << "nothing to explain";
    // One or two numbers fit any factor and any offset.
    EXPECT_TRUE(explain(numbers, floats({5.5F}), floats({3})).empty());
    EXPECT_TRUE(explain(numbers, floats({5.5F, 5.5F, 5.5F}), floats({3, 3, 3})).empty());
}

TEST(ExplainNumbers, confidence_is_the_share_of_the_failing_checks_where_each_says_much)
{
    const Tensor right = floats(values_of(40));
    const Tensor negative = floats(changed(values_of(40), [](float v) { return -v; }));
    const Tensor twice = floats(changed(values_of(40), [](float v) { return 2 * v; }));
    const FailingCheck a{&numbers, &negative, &right};
    const FailingCheck b{&numbers, &twice, &right};
    const auto found = explain_by_transform({b, a, a});
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].name, "negated");
    EXPECT_NEAR(found[0].confidence, 2.0 / 3, 1e-3);
    EXPECT_EQ(found[1].name, "scaled");
    EXPECT_NEAR(found[1].confidence, 1.0 / 3, 1e-3);
    EXPECT_TRUE(explain_by_transform({}).empty());
    EXPECT_TRUE(explain_by_transform({FailingCheck{}}).empty());
}

TEST(ExplainNumbers, agreeing_in_one_number_says_less_than_in_many)
{
    // The opposite sign of one number among right ones, and of all.
    auto right = values_of(40);
    auto one = right;
    one[7] = -one[7];
    std::vector<float> zeros(40, 0.0F);
    zeros[7] = right[7];
    auto flipped = zeros;
    flipped[7] = -flipped[7];
    const auto few = explain(numbers, floats(flipped), floats(zeros));
    const auto many = explain(numbers, floats(changed(right, [](float v) { return -v; })), floats(right));
    ASSERT_FALSE(few.empty());
    ASSERT_FALSE(many.empty());
    EXPECT_LT(few.front().confidence, many.front().confidence);
    EXPECT_TRUE(explain(numbers, floats(one), floats(right)).empty()) << "undoing it would break all others";
}

TEST(ExplainNumbers, a_passing_check_of_the_same_value_speaks_against_what_would_break_it)
{
    Check check = numbers;
    check.value = "t";
    Check other = numbers;
    other.value = "normal";
    const Tensor right = floats(values_of(40));
    const Tensor negative = floats(changed(values_of(40), [](float v) { return -v; }));
    const FailingCheck failing{&check, &negative, &right};
    const FailingCheck passing{&check, &right, &right, nullptr, false};
    const FailingCheck elsewhere{&other, &right, &right, nullptr, false};
    EXPECT_NEAR(explain_by_transform({failing, elsewhere}).front().fit, 1, 1e-12);
    EXPECT_NEAR(explain_by_transform({failing, passing}).front().fit, 0.5, 1e-12);
    EXPECT_TRUE(explain_by_transform({passing}).empty());
}

TEST(ExplainNumbers, what_is_lost_is_recognised)
{
    EXPECT_EQ(first_after([](float v) { return std::abs(v); }), "sign lost");
    EXPECT_EQ(first_after([](float v) { return std::max(v, 0.0F); }), "limited below");
    EXPECT_EQ(first_after([](float v) { return std::min(v, 1.0F); }), "limited above");
    EXPECT_EQ(first_after([](float v) { return std::clamp(v, 0.0F, 1.0F); }), "limited to [0, 1]");
    EXPECT_EQ(first_after([](float v) { return std::trunc(v); }), "fractions cut off");
    EXPECT_EQ(first_after([](float v) { return std::round(v); }), "rounded to whole numbers");
    EXPECT_EQ(first_after([](float v) { return 1 - v; }), "subtracted from 1");

    Random random(seed);
    std::vector<std::uint32_t> indices(60);
    for (std::uint32_t& index : indices) index = random.below(200'000);
    std::vector<std::uint32_t> short_ones = indices;
    for (std::uint32_t& index : short_ones) index %= 65536;
    EXPECT_EQ(first(numbers, grid(1, 60, short_ones), grid(1, 60, indices)), "16 bits");
}

TEST(ExplainNumbers, rows_in_another_order)
{
    const auto right = values_of(40);
    auto rows = right;
    std::reverse(rows.begin(), rows.end());
    EXPECT_EQ(first(numbers, floats(rows), floats(right)), "rows in reverse order");
    rows = right;
    std::rotate(rows.begin(), rows.end() - 1, rows.end());
    EXPECT_EQ(first(numbers, floats(rows), floats(right)), "rows one too late");
    rows = right;
    rows.erase(rows.begin());
    rows.push_back(0);
    EXPECT_EQ(first(numbers, floats(rows), floats(right)), "rows one too early");
    const auto points = vectors(false);
    std::vector<float> late = points;
    std::rotate(late.begin(), late.end() - 3, late.end());
    EXPECT_EQ(first(numbers, floats(late, 3), floats(points, 3)), "rows one too late");
}

TEST(ExplainNumbers, a_constant_answer_is_nothing_that_was_lost)
{
    EXPECT_EQ(first_after([](float) { return 0.0F; }), "none");
    EXPECT_EQ(first_after([](float) { return 1.0F; }), "none");
    const auto fractions = values_of(40, -0.9F, 0.9F);
    EXPECT_EQ(first(numbers, floats(changed(fractions, [](float v) { return std::trunc(v); })), floats(fractions)),
              "none");
}

TEST(ExplainNumbers, there_are_many_and_each_has_its_own_name_and_sentence)
{
    std::vector<std::string> names;
    for (const NamedTransform& transform : named_transforms()) {
        EXPECT_GT(transform.sentence.size(), 20U) << transform.name;
        names.push_back(transform.name);
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
    EXPECT_GE(names.size(), 30U);
}

}
}
