#include <gtest/gtest.h>

#include "run/path_gate.hpp"

namespace umbral::grader::test {
namespace {

const std::vector<std::string> some{"/usr/include", "/usr/lib/x86_64-linux-gnu/*", "/dev/null",
                                    "/opt/umbral/framework"};
const PathRules rules("/tmp/work-1", some);

TEST(PathRules, trees_with_all_that_is_below)
{
    for (const char* path : {"/usr/include", "/usr/include/glm/glm.hpp", "/usr/include/", "/dev/null",
                             "/opt/umbral/framework/umbral/core/ray.hpp", "sphere.cpp", "./a/b", "/tmp/work-1/x", ""})
        EXPECT_TRUE(rules.admits(path)) << path;
}

TEST(PathRules, files_of_a_folder_and_not_its_folders)
{
    EXPECT_TRUE(rules.admits("/usr/lib/x86_64-linux-gnu/libm.so"));
    EXPECT_TRUE(rules.admits("/lib/x86_64-linux-gnu/libm.so"));
    EXPECT_FALSE(rules.admits("/usr/lib/x86_64-linux-gnu/umbral/reference.so"));
    EXPECT_FALSE(rules.admits("/usr/lib/x86_64-linux-gnu/../umbral/reference.so"));
}

TEST(PathRules, the_way_there_is_known)
{
    for (const char* path : {"/", "/usr", "/usr/lib", "/lib", "/opt", "/tmp"}) EXPECT_TRUE(rules.admits(path)) << path;
}

TEST(PathRules, nothing_else)
{
    for (const char* path : {"/etc/passwd", "/usr/includes", "/usr/include/../../etc/passwd", "/usr/share/umbral",
                             "../work-2/x", "/tmp/work-10", "/tmp/work-1/../work-2", "/proc/self/fd/1", "/dev/nul",
                             "/dev/stdin", "//etc//passwd", "/opt/umbral/reference"})
        EXPECT_FALSE(rules.admits(path)) << path;
}

}
}
