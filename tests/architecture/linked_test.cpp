#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace umbral::test {
namespace {

/// What a library or program on disk holds, byte by byte.
std::string bytes_of(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    EXPECT_TRUE(in) << file;
    return {std::istreambuf_iterator<char>(in), {}};
}

// Students' code runs in forks of the spawners, and can read all of their memory. A linker takes a library's object
// files whole: where files are compiled together, one needed function brings its neighbours along.
TEST(Linked, spawners_hold_nothing_of_marks)
{
    const std::filesystem::path folder = UMBRAL_PROGRAM_FOLDER;
    const std::string grader = bytes_of(folder / "umbral");
    for (const char* word : {"secret", "millipoints", "rubric", "oracle", "libcrypto"}) {
        EXPECT_NE(grader.find(word), std::string::npos) << word << " is no word of the grader: this test is blind";
        for (const char* spawner : {"umbral-spawner", "umbral-spawner-gl"})
            EXPECT_EQ(bytes_of(folder / spawner).find(word), std::string::npos) << word << " in " << spawner;
    }
}

}
}
