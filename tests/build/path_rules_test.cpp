#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

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

// A folder above a link is not the one above its target: /usr/bin/X11, a link to its own folder, told what lies in
// /usr.
TEST(PathRules, parents_behind_links_are_those_of_their_targets)
{
    namespace fs = std::filesystem;
    const fs::path root = fs::canonical(fs::temp_directory_path()) / ("umbral-path-rules-" + std::to_string(getpid()));
    fs::create_directories(root / "shown/deep");
    fs::create_directories(root / "elsewhere/folder");
    fs::create_directory_symlink("../elsewhere/folder", root / "shown/link");
    fs::create_directory_symlink(".", root / "shown/itself");
    fs::create_symlink("nowhere", root / "shown/broken");
    const std::string shown = (root / "shown").string();
    const std::vector<std::string> rule{shown};
    const PathRules there("/tmp/work-1", rule);
    for (const char* path :
         {"/deep/../file", "/link", "/link/file", "/itself/../shown/file", "/deep/.././deep//../file"})
        EXPECT_TRUE(there.admits(shown + path)) << path;
    for (const char* path : {"/link/../secret", "/itself/../secret", "/itself/itself/.././secret",
                             "/deep/../link/./../secret", "/itself//../secret", "/itself/deep/../../secret/x"})
        EXPECT_FALSE(there.admits(shown + path)) << path;
    fs::remove_all(root);
}

}
}
