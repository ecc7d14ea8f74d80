#include <gtest/gtest.h>

#include <filesystem>

#include "program.hpp"
#include "support/temporary_folder.hpp"

// What the program is started with, and by whom.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;

// As daemons, supervisors and cron's wrappers start programs.
TEST(Surroundings, cost_no_grades)
{
    const TemporaryFolder folder;
    folder.write("class/ana/raytracing/sphere/sphere.cpp", read(UMBRAL_SOURCE "/reference/raytracing/sphere.cpp"));
    int number = 0;
    for (const char* const before : {"exec 1>&-;", "exec 2>&-;", "exec 0>&- 1>&- 2>&-;", "trap '' CHLD;"}) {
        const std::string out = "out" + std::to_string(++number);
        const Printed printed = run("cd '" + folder.path().string() + "' && sh -c \"" + before +
                                    " exec " UMBRAL_PROGRAM " grade class --unit sphere --jobs 1 --out " + out + "\"");
        EXPECT_EQ(printed.status, 0) << before << printed.text;
        EXPECT_NE(read(folder / out / "class.json").find("\"verdict\": \"ok\""), std::string::npos) << before;
    }
}

TEST(Surroundings, a_cache_may_be_named_from_here_and_must_be_a_folder)
{
    const TemporaryFolder folder;
    folder.write("class/ana/raytracing/sphere/sphere.cpp", "");
    const std::string here = "cd '" + folder.path().string() + "' && ";
    const auto with = [&](const std::string& cache) {
        return umbral("grade class --unit sphere --out out --fresh --jobs 1", here + "UMBRAL_CACHE=" + cache);
    };
    EXPECT_EQ(with("here/cache").status, 0);
    EXPECT_TRUE(fs::is_directory(folder / "here/cache"));
    EXPECT_EQ(with("").status, 0);
    folder.write("file", "no folder");
    const Printed refused = with("file");
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find("UMBRAL_CACHE=file: expected a folder"), std::string::npos) << refused.text;
}

}
}
