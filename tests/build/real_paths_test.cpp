#include "build/real_paths.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/temporary_folder.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

TEST(RealPaths, follow_links_before_they_go_up)
{
    const umbral::test::TemporaryFolder folder;
    const fs::path root = fs::canonical(folder.path());
    fs::create_directories(root / "include/glm");
    fs::create_directories(root / "include/llvm/llvm");
    fs::create_directories(root / "lib/llvm/include");
    std::ofstream(root / "include/glm/turn.inl") << "turn";
    fs::create_directory_symlink(root / "include/llvm/llvm", root / "lib/llvm/include/llvm");
    RealPaths paths;
    const std::string by_link = root / "lib/llvm/include/llvm/../../glm/turn.inl";
    ASSERT_TRUE(fs::exists(by_link));
    EXPECT_EQ(paths.of(by_link), root / "include/glm/turn.inl");
    EXPECT_EQ(paths.of(root / "include/glm/./turn.inl"), root / "include/glm/turn.inl");
}

// From a folder that has another name each time.
TEST(RealPaths, go_up_to_the_root)
{
    RealPaths paths;
    EXPECT_EQ(paths.of("../../../usr/./include/../include"), fs::canonical("/usr/include"));
}

TEST(RealPaths, leave_what_is_not_there)
{
    RealPaths paths;
    EXPECT_EQ(paths.of("/nowhere/include/glm/./gtx/../turn.inl"), "/nowhere/include/glm/turn.inl");
    EXPECT_EQ(paths.of("sphere.cpp"), "sphere.cpp");
    EXPECT_EQ(paths.of("./part.hpp"), "part.hpp");
    EXPECT_EQ(paths.of("../../include/glm/./turn.inl"), "../../include/glm/turn.inl");
    EXPECT_EQ(paths.of(""), "");
    EXPECT_LE(paths.of("/" + std::string(100'000, 'x')).size(), 1024);
}

TEST(RealPaths, are_not_looked_up_without_end)
{
    RealPaths paths;
    std::string path = "/usr/";
    for (int i = 0; i < 4096; ++i) {
        EXPECT_EQ(paths.of(path), "/usr");
        path += "/";
    }
    EXPECT_FALSE(paths.too_many());
    (void)paths.of(path);
    EXPECT_TRUE(paths.too_many());
}

}
}
