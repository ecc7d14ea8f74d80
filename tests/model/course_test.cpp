#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

#include "manifest/units.hpp"

namespace umbral::grader {
namespace {

TEST(Course, has_a_unit_for_each_row_and_each_problem)
{
    std::set<std::string> there;
    for (const Exercise& exercise : load_units(UMBRAL_SOURCE_DIR "/exercises").exercises) {
        there.insert(exercise.id);
        there.insert(exercise.course.begin(), exercise.course.end());
    }
    std::ifstream rows(UMBRAL_SOURCE_DIR "/tests/model/course_rows.txt");
    int read = 0;
    for (std::string row; std::getline(rows, row);) {
        if (row.starts_with('#')) continue;
        EXPECT_TRUE(there.contains(row)) << "no unit is, or poses, " << row;
        ++read;
    }
    EXPECT_GE(read, 150);
}

}
}
