#include <gtest/gtest.h>

#include <filesystem>

#include "support/printed.hpp"

namespace umbral::test {
namespace {

// Students' code runs in forks of the spawners, and can read all of their memory. A linker takes a library's object
// files whole: where files are compiled together, one needed function brings its neighbours along.
TEST(Linked, spawners_hold_nothing_of_marks)
{
    const std::filesystem::path folder = UMBRAL_PROGRAM_FOLDER;
    const std::string grader = read(folder / "umbral");
    const std::string spawner = read(folder / "umbral-spawner");
    const std::string spawner_gl = read(folder / "umbral-spawner-gl");
    ASSERT_FALSE(spawner.empty());
    ASSERT_FALSE(spawner_gl.empty());
    for (const char* word : {"secret", "millipoints", "rubric", "oracle", "libcrypto"}) {
        EXPECT_NE(grader.find(word), std::string::npos) << word << " is no word of the grader: this test is blind";
        EXPECT_EQ(spawner.find(word), std::string::npos) << word;
        EXPECT_EQ(spawner_gl.find(word), std::string::npos) << word;
    }
}

}
}
