#include "report/clusters.hpp"

#include <gtest/gtest.h>

#include "report/reasons.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

namespace umbral::grader {
namespace {

UnitResult work(const std::string& unit, Verdict verdict, std::vector<Explanation> explanations = {})
{
    UnitResult result = unit_result(unit, verdict, {check_result("a/b", verdict == Verdict::ok ? 1000 : 100, 1000)});
    result.explanations = std::move(explanations);
    return result;
}

const Explanation far{"mistake: far_root", "The far root.", 0.97};
const Explanation near{"mistake: near_root", "The near root.", 0.97};

ClassResult a_class()
{
    ClassResult result;
    const auto hand_in = [&](UnitResult unit) {
        result.submissions.push_back(
            submission_result("s" + std::to_string(result.submissions.size()), {std::move(unit)}));
    };
    hand_in(work("t/few", Verdict::wrong, {far}));
    hand_in(work("t/few", Verdict::ok));
    hand_in(work("t/many", Verdict::wrong));
    hand_in(work("t/many", Verdict::partial, {near}));
    hand_in(work("t/many", Verdict::partial, {far}));
    hand_in(work("t/many", Verdict::partial, {far, near}));
    hand_in(work("t/many", Verdict::crashed));
    auto a = far, b = near;
    a.ambiguous = b.ambiguous = true;
    hand_in(work("t/many", Verdict::partial, {a, b, {"scaled", "Scaled.", 0.8}}));
    hand_in(work("t/many", Verdict::partial, {b, a}));
    hand_in(work("t/many", Verdict::missing));
    hand_in(work("t/many", Verdict::not_implemented));
    hand_in(work("t/many", Verdict::grader_fault, {far}));
    return result;
}

TEST(Clusters, of_each_unit_the_largest_first_ambiguous_ones_and_unexplained_ones_apart)
{
    const std::vector<UnitClusters> found = clusters(a_class());
    ASSERT_EQ(found.size(), 2U);
    const UnitClusters& many = found[0];
    EXPECT_EQ(many.unit, "t/many");
    EXPECT_EQ(many.graded, 9U) << "the grader's fault counts nowhere";
    EXPECT_EQ(many.submissions(), 7U) << "neither does what nobody wrote";
    ASSERT_EQ(many.explained.size(), 2U);
    EXPECT_EQ(many.explained[0].name, "far root");
    EXPECT_EQ(many.explained[0].who, (std::vector<std::size_t>{4, 5}));
    EXPECT_EQ(many.explained[0].sentences, (std::vector<std::string>{"The far root."}));
    EXPECT_NEAR(many.explained[0].confidence, 0.97, 1e-12);
    EXPECT_EQ(many.explained[1].name, "near root");
    ASSERT_EQ(many.ambiguous.size(), 1U) << "whichever of two equals stands first";
    EXPECT_EQ(many.ambiguous[0].name, "far root or near root");
    EXPECT_EQ(many.ambiguous[0].sentences.size(), 2U);
    EXPECT_EQ(many.ambiguous[0].who, (std::vector<std::size_t>{7, 8}));
    ASSERT_EQ(many.unexplained.size(), 2U);
    for (const Cluster& cluster : many.unexplained) EXPECT_TRUE(cluster.sentences.empty());
    EXPECT_EQ(many.unexplained[0].name, "crashed");
    EXPECT_EQ(many.unexplained[1].name, "no explanation");
    EXPECT_EQ(found[1].unit, "t/few");
    EXPECT_EQ(found[1].graded, 2U);
    EXPECT_TRUE(clusters({}).empty());
}

TEST(Clusters, the_terminal_lists_the_largest)
{
    const std::string table = class_table(a_class(), {});
    const std::size_t first = table.find("2 of 9  far root (very likely)  t/many");
    EXPECT_NE(first, std::string::npos) << table;
    EXPECT_NE(table.find("2 of 9  far root or near root (very likely one of these)  t/many"), std::string::npos)
        << table;
    EXPECT_LT(first, table.find("1 of 2  far root (very likely)  t/few"));
    ClassResult right;
    right.submissions = {submission_result("ana", {work("t/few", Verdict::ok)})};
    EXPECT_EQ(class_table(right, {}).find("Why"), std::string::npos);
}

TEST(Reasons, are_words_not_numbers)
{
    EXPECT_STREQ(sure_words(1), "very likely");
    EXPECT_STREQ(sure_words(0.7), "probably");
    EXPECT_STREQ(sure_words(0.1), "perhaps");
    EXPECT_STREQ(sure_words(std::numeric_limits<double>::quiet_NaN()), "perhaps");
}

TEST(Reasons, are_those_that_match_equally_well)
{
    UnitResult unit = work("t/u", Verdict::wrong);
    EXPECT_TRUE(main_reasons(unit).empty());
    EXPECT_TRUE(other_reasons(unit).empty());
    unit.explanations = {far, near};
    EXPECT_EQ(main_reasons(unit).size(), 1U);
    EXPECT_EQ(other_reasons(unit).size(), 1U);
    unit.explanations[0].ambiguous = unit.explanations[1].ambiguous = true;
    EXPECT_EQ(main_reasons(unit).size(), 2U);
    EXPECT_TRUE(other_reasons(unit).empty());
}

}
}
