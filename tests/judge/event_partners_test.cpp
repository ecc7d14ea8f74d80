#include <gtest/gtest.h>

#include "explaining.hpp"
#include "judge/events/events.hpp"

// Which event that came is shown beside which that is missing.
namespace umbral::grader::test {
namespace {

/// What is said of the first difference, and in which row.
std::string told(const std::vector<float>& yours, const std::vector<float>& expected)
{
    const Tensor names = text("1 triangle\n2 point\n");
    const Judgement found =
        judge(check_of(JudgeKind{"events"}), floats(yours, 4), floats(expected, 4), nullptr, &names);
    if (!found.first_difference) return "";
    return found.first_difference->yours + " for " + found.first_difference->expected + ", " +
           found.first_difference->where;
}

TEST(EventPartners, a_triangle_that_is_turned_over_stands_beside_itself)
{
    EXPECT_EQ(told({1, 0, 1, 4, 1, 1, 2, 5, 1, 7, 8, 9}, {1, 0, 1, 4, 1, 1, 4, 5, 1, 1, 5, 2, 1, 7, 8, 9}),
              "triangle (1, 2, 5) for triangle (1, 5, 2), row 2 of 4 events");
}

TEST(EventPartners, what_is_expected_nowhere_stands_beside_what_is_missing)
{
    // The first point is too high; it came before what it should have come behind.
    EXPECT_EQ(told({2, 0, 0.5F, 0, 2, 1, 1, 1, 2, 2, 2, 2}, {2, 1, 1, 1, 2, 2, 2, 2, 2, 0, 0, 0}),
              "point (0, 0.5, 0) for point (0, 0, 0), row 2 of 3 events");
    EXPECT_EQ(told({2, 1, 1, 1, 2, 2, 2, 2, 2, 0, 0.5F, 0}, {2, 0, 0, 0, 2, 1, 1, 1, 2, 2, 2, 2}),
              "point (0, 0.5, 0) for point (0, 0, 0), row 0 of 3 events");
}

TEST(EventPartners, kinds_are_not_mixed_and_known_events_are_not_taken)
{
    EXPECT_EQ(told({1, 0, 1, 2, 2, 1, 1, 1}, {2, 1, 1, 1, 2, 0, 1, 2}),
              "triangle (0, 1, 2) for nothing, row 0 of 2 events");
    EXPECT_EQ(told({2, 1, 1, 1, 2, 1, 1, 1, 2, 3, 3, 3}, {2, 1, 1, 1, 2, 3, 3, 3}).find("point (3"), std::string::npos)
        << "one that is right is nobody's partner";
}

TEST(EventPartners, what_stands_beside_it_stays_there)
{
    EXPECT_EQ(told({2, 1, 1, 1, 2, 5, 5, 5}, {2, 4, 4, 1, 2, 1, 1, 2}),
              "point (1, 1, 1) for point (4, 4, 1), row 0 of 2 events")
        << "the second is nearer";
}

TEST(EventPartners, what_came_in_another_place_is_not_missing)
{
    // The last two are the other way round: one of them has no partner, and is near.
    EXPECT_EQ(told({2, 0, 0.5F, 0, 2, 1, 1, 1, 2, 0, 0.4F, 0, 2, 0, 0.6F, 0},
                   {2, 1, 1, 1, 2, 0, 0.6F, 0, 2, 0, 0.4F, 0, 2, 9, 9, 9}),
              "point (0, 0.5, 0) for point (9, 9, 9), row 3 of 4 events");
}

}
}
