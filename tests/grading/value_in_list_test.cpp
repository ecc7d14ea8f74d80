#include "explain/value_in_list.hpp"
#include "spoilt_reference.hpp"

#include <gtest/gtest.h>

#include <umbral/record/recorder.hpp>

// Lists whose rows are called by their places in it, as a polygon's corners are.
namespace umbral::grader::test {
namespace {

using Corners = std::vector<std::array<float, 2>>;

/// Rows "polygon 7, its number, x, y".
Tensor list(const Corners& corners)
{
    Recorder out;
    for (std::size_t i = 0; i < corners.size(); ++i)
        out.append("list", std::vector<float>{7, static_cast<float>(i), corners[i][0], corners[i][1]});
    return corners.empty() ? Tensor{Element::float32, 0, 1, 4, {}, {}} : out.tensors().at("list");
}

std::string told(const Corners& yours, const Corners& expected, std::size_t keys = 2)
{
    const auto apart = first_value_apart(list(yours), list(expected), keys);
    if (!apart) return "";
    return apart->yours + " for " + apart->expected + (apart->cell ? " in row " + std::to_string(*apart->cell) : "");
}

TEST(ValueInList, what_stands_elsewhere_is_there)
{
    const Corners square{{0, 0}, {8, 0}, {8, 3}, {8, 5}};
    EXPECT_EQ(told({{8, 3}, {0, 0}, {8, 0}}, square), "nothing for (8, 5) in row 3");
    EXPECT_EQ(told({{8, 5}, {8, 3}, {8, 0}, {0, 0}}, square), "") << "all are there, in another order";
}

TEST(ValueInList, what_is_expected_nowhere_stands_beside_what_is_nearest_to_it)
{
    const Corners square{{0, 0}, {8, 0}, {8, 3}, {8, 5}};
    EXPECT_EQ(told({{90, 0}, {0, 0}, {8, 0}, {8, 3}, {8, 6}}, square), "(8, 6) for (8, 5) in row 3");
    EXPECT_EQ(told({{0, 0}, {8, 0}, {8, 3}, {4, 4}, {8, 5}}, square), "(4, 4) for nothing");
}

TEST(ValueInList, the_same_numbers_in_another_order_are_nearer_than_any_other)
{
    EXPECT_EQ(told({{5, 1}, {1, 4}}, {{1, 5}, {2, 9}}), "(5, 1) for (1, 5) in row 0");
}

TEST(ValueInList, equal_ones_are_counted)
{
    EXPECT_EQ(told({{1, 1}, {2, 2}}, {{1, 1}, {1, 1}, {2, 2}}), "nothing for (1, 1) in row 1");
    EXPECT_EQ(told({}, {{1, 1}}), "nothing for (1, 1) in row 0");
}

TEST(ValueInList, keys_that_say_more_than_places_are_none_of_its_business)
{
    EXPECT_EQ(told({{5, 0}, {9, 1}}, {{5, 0}, {6, 1}}, 3), "") << "pixels, say";
}

class ListsOfCorners : public SpoiltReference {
protected:
    ListsOfCorners() : SpoiltReference("pipeline/clip-polygon") {}
};

// One corner too many, in the list that it stands in.
TEST_F(ListsOfCorners, short_lists_are_shown_whole)
{
    const UnitResult result =
        grade("while (result.size() > 1 && result.back() == result.front()) result.pop_back();", "");
    const CheckResult& wrong = check(result, "borders/corners");
    ASSERT_TRUE(wrong.first_difference);
    const auto corners = [](const std::string& text) { return std::ranges::count(text, '('); };
    EXPECT_EQ(wrong.first_difference->where, "this call");
    EXPECT_GE(corners(wrong.first_difference->expected), 3) << wrong.first_difference->expected;
    EXPECT_EQ(corners(wrong.first_difference->yours), corners(wrong.first_difference->expected) + 1)
        << wrong.first_difference->yours;
}

}
}
