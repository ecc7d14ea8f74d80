#include <gtest/gtest.h>

#include "bench/unforeseen/unforeseen.hpp"

namespace umbral::grader {
namespace {

using Truth = ToldSentence::Truth;

UnforeseenBug bug(std::vector<Truth> truths, bool stopped = false)
{
    UnforeseenBug made{"topic/unit", "line 3: a → b", false, stopped, true, {}};
    for (const Truth truth : truths)
        made.said.push_back({ToldSentence::Kind::answer, "case/value", "is always 0", truth});
    return made;
}

std::vector<UnforeseenBug> bugs(std::size_t told, std::size_t wrong, std::size_t silent)
{
    std::vector<UnforeseenBug> all(told, bug({Truth::holds}));
    all.insert(all.end(), wrong, bug({Truth::fails}));
    all.insert(all.end(), silent, bug({}));
    return all;
}

TEST(UnforeseenTargets, are_sixty_five_percent_told_truly_and_less_than_one_falsely)
{
    EXPECT_TRUE(meets_targets(bugs(650, 9, 341)));
    EXPECT_FALSE(meets_targets(bugs(649, 9, 342)));
    EXPECT_FALSE(meets_targets(bugs(650, 10, 340)));
}

TEST(UnforeseenTargets, one_false_sentence_beside_a_true_one_is_false)
{
    std::vector<UnforeseenBug> all(99, bug({Truth::holds}));
    all.push_back(bug({Truth::holds, Truth::fails}));
    EXPECT_FALSE(meets_targets(all));
}

TEST(UnforeseenTargets, what_leaves_no_values_is_not_asked_for)
{
    std::vector<UnforeseenBug> all(10, bug({Truth::holds}));
    all.insert(all.end(), 90, bug({}, true));
    EXPECT_TRUE(meets_targets(all));
}

TEST(UnforeseenTable, names_what_was_false_and_of_what_nothing_was_said)
{
    const std::string table = unforeseen_table({bug({Truth::fails}), bug({})});
    EXPECT_NE(table.find("False with other inputs:\n  topic/unit, line 3: a → b\n    case/value: is always 0"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("Nothing was said of:\n  topic/unit, line 3: a → b\n"), std::string::npos) << table;
}

}
}
