#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "page_text.hpp"
#include "report/layout.hpp"
#include "report/terminal.hpp"
#include "results.hpp"

namespace umbral::grader {
namespace {

ClassResult class_of(int units)
{
    ClassResult result;
    constexpr std::array verdicts = {Verdict::ok, Verdict::partial, Verdict::wrong, Verdict::crashed,
                                     Verdict::grader_fault};
    constexpr std::array<Millipoints, 5> scores = {10000, 6125, 0, 0, 0};
    int step = 0;
    for (const std::string name :
         {"ana", "a.very.long.name.that.no.table.has.room.for", "王小明", "e\x1b[31mvil", "\xFF\xFE", "b\u202Eo"}) {
        std::vector<UnitResult> all;
        for (int i = 0; i < units; ++i) {
            const std::size_t kind = static_cast<std::size_t>(++step) % 5;
            all.push_back(unit_result("topic/unit-number-" + std::to_string(i), verdicts[kind],
                                      {check_result("a/b", scores[kind], 10000)}));
        }
        result.submissions.push_back(submission_result(name, all));
    }
    return result;
}

TEST(ClassTable, all_rows_of_a_band_have_the_same_width_and_fit)
{
    for (const int units : {1, 3, 7, 12, 20, 45})
        for (const int width : {60, 100, 140})
            for (const bool unicode : {true, false}) {
                const std::string table =
                    class_table(class_of(units), {.color = true, .unicode = unicode, .width = width});
                int first = 0;
                int rows = 0;
                for (const std::string_view line : lines_of(table)) {
                    ASSERT_LE(display_width(line), width) << line;
                    if (line.empty()) {
                        if (rows > 3) first = 0;
                        continue;
                    }
                    ++rows;
                    if (has(std::string(line), "submission")) first = display_width(line);
                    ASSERT_TRUE(first == 0 || display_width(line) == first)
                        << units << " units, width " << width << ": " << line;
                }
            }
}

TEST(ClassTable, shows_points_marks_totals_and_means)
{
    ClassResult result;
    result.submissions = {
        submission_result("ana", {unit_result("a/one", Verdict::ok, {check_result("c/v", 10000, 10000)}),
                                  unit_result("a/two", Verdict::wrong, {check_result("c/v", 0, 2500)})}),
        submission_result("bo", {unit_result("a/one", Verdict::partial, {check_result("c/v", 5000, 10000)})}),
        submission_result("cy", {unit_result("a/one", Verdict::grader_fault, {check_result("c/v", 0, 10000)})})};
    const std::string table = class_table(result, {});
    const auto lines = lines_of(table);
    const auto row = [&](const std::string& name) {
        for (const std::string_view line : lines)
            if (line.starts_with("  " + name)) return std::string(line);
        return std::string();
    };
    EXPECT_TRUE(has(row("ana"), "10/12.5"));
    EXPECT_TRUE(has(row("ana"), "10 ✓"));
    EXPECT_TRUE(has(row("ana"), "0 ✗"));
    EXPECT_TRUE(has(row("bo"), "5 ◐"));
    EXPECT_TRUE(has(row("bo"), "·")) << "not graded is no zero";
    EXPECT_TRUE(has(row("cy"), "0 ?"));
    EXPECT_TRUE(has(row("mean"), " 7.5 ")) << "a grader's fault is no zero, in no column: " << row("mean");
    EXPECT_FALSE(has(row("mean"), " 5 ")) << row("mean");
}

TEST(ClassTable, numbers_units_that_have_no_room_and_names_them_below)
{
    const std::string table = class_table(class_of(20), {});
    EXPECT_TRUE(has(table, "20 topic/unit-number-19"));
    EXPECT_FALSE(has(class_table(class_of(2), {}), "2 topic/unit-number-1"));
}

TEST(ClassTable, a_hidden_failure_is_no_check_mark)
{
    ClassResult result;
    result.submissions = {
        submission_result("ana", {unit_result("a/one", Verdict::ok, {check_result("c/v", 0, 1000, true)})})};
    const std::string table = class_table(result, {});
    EXPECT_FALSE(has(table, "0 ✓"));
    EXPECT_TRUE(has(table, "0 ◐"));
}

TEST(ClassTable, empty_classes_are_said_to_be_empty)
{
    EXPECT_TRUE(has(class_table({}, {}), "No submission"));
    ClassResult nothing;
    nothing.submissions = {submission_result("ana", {})};
    EXPECT_TRUE(has(class_table(nothing, {}), "ana"));
}

}
}
