#include <gtest/gtest.h>

#include <functional>
#include <umbral/core/random.hpp>

#include "question/first_pattern.hpp"

// Wrong answers that lie too far from, or not far enough from, something that the question holds.
namespace umbral::grader::test {
namespace {

struct Moved {
    Row given{};
    Row right{};
    double count = 0;
};

/// Answers of numbers that are called so, to questions of a "box" with the same numbers and a "count"; half are wrong.
AnswerTable moved(const std::vector<std::string>& names, const std::function<Row(const Moved&)>& wrong)
{
    AnswerTable made;
    made.components = names.size();
    if (names.size() > 1) made.columns = names;
    for (const std::string& name : names) made.facts.push_back({"box." + name, Fact::Kind::number});
    made.facts.push_back({"count", Fact::Kind::number});
    Random random(11);
    for (int i = 0; i < 24; ++i) {
        Moved one;
        one.count = 1.0 + random.below(9);
        for (std::size_t k = 0; k < names.size(); ++k) {
            one.given.push_back(random.uniform(-4, 4));
            one.right.push_back(one.given.back() + random.uniform(0.1F, 2));
            made.facts[k].values.push_back(one.given.back());
        }
        made.facts.back().values.push_back(one.count);
        const bool is_wrong = i % 2 == 0;
        made.answers.push_back({is_wrong ? wrong(one) : one.right, one.right, is_wrong});
    }
    return made;
}

Row times_as_far(const Moved& one, double factor)
{
    Row row;
    for (std::size_t i = 0; i < one.right.size(); ++i)
        row.push_back(one.given[i] + factor * (one.right[i] - one.given[i]));
    return row;
}

TEST(DistanceRelation, tells_how_far_from_what_is_given)
{
    const auto pattern = [](const std::vector<std::string>& names, double factor) {
        return first_pattern(moved(names, [factor](const Moved& one) { return times_as_far(one, factor); }));
    };
    EXPECT_EQ(pattern({"low.x", "low.y", "high.x"}, 2), "is 2 times as far from box as the right one");
    EXPECT_EQ(pattern({"x", "y", "z"}, 0.5), "is 0.5 times as far from box as the right one");
    EXPECT_EQ(pattern({"x", "y", "z"}, -1), "is as far from box as the right one, on the other side");
    EXPECT_EQ(pattern({"t"}, -2), "is 2 times as far from box.t as the right one, on the other side");
}

TEST(DistanceRelation, tells_it_of_the_only_number_that_is_wrong)
{
    const AnswerTable one = moved({"low.x", "low.y"}, [](const Moved& m) {
        return Row{m.right[0], m.given[1] + 3 * (m.right[1] - m.given[1])};
    });
    EXPECT_EQ(first_pattern(one), "differs in low.y only, which is 3 times as far from box.low.y as the right one");
}

TEST(DistanceRelation, tells_of_multiples_that_were_added)
{
    const AnswerTable sizes = moved({"t"}, [](const Moved& one) { return Row{one.right[0] - 2 * one.count}; });
    EXPECT_EQ(first_pattern(sizes), "is the right one minus 2 times count");
}

TEST(DistanceRelation, says_nothing_by_chance)
{
    for (int seed = 1; seed <= 200; ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const AnswerTable any =
            moved({"x", "y", "z"}, [&](const Moved& one) { return times_as_far(one, random.uniform(-3, 3)); });
        for (const AnswerPattern& pattern : answer_patterns(any))
            EXPECT_EQ(pattern.words.find("as far from"), std::string::npos) << pattern.words << ", seed " << seed;
    }
}

}
}
