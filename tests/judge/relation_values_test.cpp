#include <gtest/gtest.h>

#include "judge/relation.hpp"
#include "make.hpp"

// Laws between tables of numbers: how much of a law may hold where it must not.
namespace umbral::grader::test {
namespace {

constexpr double factor = 2;

Check twice()
{
    Check check = check_of(JudgeKind{"numbers"}, absolute(0.01));
    check.value = "value";
    check.relation = Relation{"upright", "", {0, 0}, factor, "twice the light must be twice as bright"};
    return check;
}

/// `to` and, `wrong` of its last values apart, twice of it.
std::pair<Tensor, Tensor> table(std::vector<float> to, std::size_t wrong = 0)
{
    std::vector<float> value = to;
    for (std::size_t i = 0; i < value.size(); ++i)
        value[i] = static_cast<float>(factor) * to[i] + (i + wrong >= value.size() ? 5.0F : 0.0F);
    return {floats(value), floats(to)};
}

Judgement judged(const std::pair<Tensor, Tensor>& student, const std::pair<Tensor, Tensor>& reference)
{
    return RelationJudge(twice(), {&reference.first, &reference.second, nullptr}, nullptr, 1)
        .judge({&student.first, &student.second, nullptr});
}

/// 1, 2 … 40; the first `small` of them next to nothing, of which any multiple is nothing, too.
std::vector<float> rising(std::size_t small = 0)
{
    std::vector<float> values(40);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = i < small ? 1e-4F : static_cast<float>(i + 1);
    return values;
}

TEST(RelationValues, what_holds_unmoved_is_taken_off)
{
    const auto reference = table(rising());
    EXPECT_EQ(judged(table(rising()), reference).right, 1);
    // Of 40 rows 12 hold whatever the factor, and 7 of the others are wrong: 21 of 28 are left.
    EXPECT_NEAR(judged(table(rising(12), 7), reference).right, 0.75, 1e-9);
    EXPECT_NEAR(judged(table(rising(), 10), reference).right, 0.75, 1e-9);
}

TEST(RelationValues, values_that_hardly_change_tell_nothing)
{
    const auto reference = table(rising());
    EXPECT_EQ(judged(table(rising(19)), reference).right, 1) << "still more than half of what the reference changes";
    const Judgement found = judged(table(rising(22)), reference);
    EXPECT_EQ(found.right, 0);
    EXPECT_NE(found.message.find("hardly changes where it must"), std::string::npos) << found.message;
}

}
}
