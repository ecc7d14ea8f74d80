#include "validate/validation_table.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace umbral::grader {
namespace {

Exercise unit(const std::string& id)
{
    Exercise exercise;
    exercise.id = id;
    exercise.title = {{"en", "Title of " + id}};
    return exercise;
}

Finding mistake(const std::string& unit, const std::string& name, unsigned seed, double credit,
                std::optional<double> hard)
{
    return {unit, "mistake: " + name, seed, true, credit, "10..90", "explained", "wrong | in a bar", "a hint", hard};
}

TEST(ValidationTable, spans_the_seeds_and_keeps_the_order_of_units)
{
    const std::vector<Finding> findings = {mistake("b/two", "naive", 0, 40, 20.0),
                                           mistake("b/two", "naive", 1, 60.04, 10.0),
                                           mistake("a/one", "shifted", 0, 33.33, {}),
                                           {"b/two", "reference", 0, true, 100, "100", "", "", "", 100.0},
                                           {"b/two", "control: zeros", 0, true, 0, "0", ""}};
    const std::vector<Exercise> exercises = {unit("b/two"), unit("a/one"), unit("c/three")};
    const std::string table = validation_table(findings, exercises);
    EXPECT_LT(table.find("## b/two"), table.find("## a/one"));
    EXPECT_EQ(table.find("c/three"), std::string::npos);
    EXPECT_EQ(table.find("zeros"), std::string::npos);
    EXPECT_NE(table.find("| naive | wrong \\| in a bar | 40.0 to 60.0 | 10 | a hint |"), std::string::npos) << table;
    EXPECT_NE(table.find("| *reference* |  | 100.0 | 100 |"), std::string::npos) << table;
    EXPECT_NE(table.find("| shifted | wrong \\| in a bar | 33.3 | a hint |"), std::string::npos) << table;
}

TEST(ValidationTable, names_scenes_that_never_show_a_mistake)
{
    std::vector<Finding> findings = {mistake("a/one", "subtle", 0, 90, {}), mistake("a/one", "subtle", 1, 90, {}),
                                     mistake("a/one", "gross", 0, 10, {})};
    findings[0].blind = {"scene/flat", "scene/round"};
    findings[1].blind = {"scene/flat"};
    const std::vector<Exercise> exercises = {unit("a/one")};
    const std::string table = validation_table(findings, exercises);
    EXPECT_NE(table.find("The picture of `scene/flat` cannot show: subtle."), std::string::npos) << table;
    EXPECT_EQ(table.find("scene/round"), std::string::npos) << table;
}

TEST(ValidationTable, marks_what_does_not_hold)
{
    Finding finding = mistake("a/one", "shifted", 3, 95, {});
    finding.holds = false;
    const std::vector<Exercise> exercises = {unit("a/one")};
    EXPECT_NE(validation_table(std::vector{finding}, exercises).find("not as it should be"), std::string::npos);
}

}
}
