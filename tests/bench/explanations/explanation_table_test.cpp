#include <gtest/gtest.h>

#include "bench/explanations/explanations.hpp"
#include "bench/held_out.hpp"

namespace umbral::grader {
namespace {

ExplainedWork work(WorkKind kind, Said said, const std::string& unit = "topic/unit")
{
    return {unit, 0, kind, "subject", said, {{"reason", "A sentence.", 0.9}}};
}

std::vector<ExplainedWork> many(WorkKind kind, Said said, std::size_t count)
{
    return std::vector<ExplainedWork>(count, work(kind, said));
}

std::vector<ExplainedWork> join(std::vector<std::vector<ExplainedWork>> parts)
{
    std::vector<ExplainedWork> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

TEST(ExplanationTargets, are_ninety_five_percent_right_and_less_than_one_wrong)
{
    const auto right = [](std::size_t of_a_hundred) {
        return join({many(WorkKind::mistake, Said::right, of_a_hundred - 10),
                     many(WorkKind::mistake, Said::right_among, 10),
                     many(WorkKind::mistake, Said::silent, 100 - of_a_hundred)});
    };
    const auto wrong = [](std::size_t of_a_thousand) {
        return join({many(WorkKind::left_out, Said::wrong, of_a_thousand),
                     many(WorkKind::left_out, Said::true_statement, 300),
                     many(WorkKind::disturbed, Said::silent, 700 - of_a_thousand)});
    };
    EXPECT_TRUE(meets_targets(join({right(95), wrong(9)}), false));
    EXPECT_FALSE(meets_targets(join({right(94), wrong(9)}), false));
    EXPECT_FALSE(meets_targets(join({right(95), wrong(10)}), false));
    EXPECT_FALSE(meets_targets({}, false)) << "nothing measured is nothing met";
}

TEST(ExplanationTargets, look_at_the_half_held_out)
{
    std::string tuning;
    std::string other_half;
    std::size_t held = 0;
    for (int i = 0; i < 100; ++i) {
        const std::string unit = "topic/unit-" + std::to_string(i);
        (held_out(unit) ? other_half : tuning) = unit;
        held += held_out(unit) ? 1 : 0;
    }
    EXPECT_GT(held, 30U);
    EXPECT_LT(held, 70U);
    const std::vector<ExplainedWork> all{
        work(WorkKind::mistake, Said::right, tuning), work(WorkKind::mistake, Said::right, other_half),
        work(WorkKind::left_out, Said::wrong, tuning), work(WorkKind::left_out, Said::silent, other_half)};
    EXPECT_TRUE(meets_targets(all, true));
    EXPECT_FALSE(meets_targets(all, false));
}

TEST(ExplanationTable, counts_and_names_what_is_wrong)
{
    const std::string table =
        explanation_table(join({many(WorkKind::mistake, Said::right, 3), many(WorkKind::mistake, Said::silent, 1),
                                many(WorkKind::left_out, Said::wrong, 1), many(WorkKind::disturbed, Said::silent, 3)}));
    EXPECT_NE(table.find("right 75.0 %"), std::string::npos) << table;
    EXPECT_NE(table.find("wrong 1 of 4: 25.00 %"), std::string::npos) << table;
    EXPECT_NE(table.find("topic/unit seed 0, mistake left out: subject\n    reason 0.900"), std::string::npos) << table;
    EXPECT_EQ(explanation_table(many(WorkKind::mistake, Said::right, 3)).find("Wrongly explained"), std::string::npos);
}

}
}
