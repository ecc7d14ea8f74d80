#include "cli/authors/unit_pages.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

// Pages about units, made anew for some of them.
namespace umbral::grader::test {
namespace {

const std::array<std::string, 3> order{"meshes/area", "meshes/weld", "pipeline/clip-line"};

TEST(UnitPages, keep_what_they_say_of_other_units)
{
    const std::string head = "# Mutants\n\nNew words.\n\n| unit | killed |\n|---|---|\n";
    const std::string fresh =
        head + "| meshes/weld | 7 |\n\n## meshes/weld\n| place | |\n|---|---|\n| weld.cpp:3 | a |\n";
    const std::string kept =
        "# Mutants\n\nOld words.\n\n| unit | killed |\n|---|---|\n| pipeline/clip-line | 1 |\n| meshes/weld | 2 |\n"
        "| meshes/area | 3 |\n| meshes/gone | 4 |\n\n## meshes/weld\nold\n\n## meshes/gone\ngone\n\n## meshes/area\n"
        "| place | |\n|---|---|\n| meshes/area.cpp:3 | b |\n\n";
    EXPECT_EQ(with_other_units(fresh, kept, order),
              head +
                  "| meshes/area | 3 |\n| meshes/weld | 7 |\n| pipeline/clip-line | 1 |\n"
                  "\n## meshes/area\n| place | |\n|---|---|\n| meshes/area.cpp:3 | b |\n"
                  "\n## meshes/weld\n| place | |\n|---|---|\n| weld.cpp:3 | a |\n");
}

TEST(UnitPages, drop_a_section_of_a_unit_that_has_none_now)
{
    EXPECT_EQ(with_other_units("| meshes/weld | 7 |\n", "| meshes/weld | 2 |\n\n## meshes/weld\nold\n", order),
              "| meshes/weld | 7 |\n");
}

TEST(UnitPages, are_as_they_were_made_where_there_was_none)
{
    const std::string page =
        "# What each mistake gets\n\nWords.\n\n## meshes/area\nArea\n\n| a |\n|---|\n\nLine.\n\n## meshes/weld\n| b "
        "|\n";
    EXPECT_EQ(with_other_units(page, "", order), page);
    EXPECT_EQ(with_other_units(page, page, order), page);
}

}
}
