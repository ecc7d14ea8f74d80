#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "collect/desk.hpp"
#include "collect/submission_id.hpp"
#include "model/caps.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

class Collect : public testing::Test {
protected:
    Desk bench;
    fs::path folder = bench.folder();

    [[nodiscard]] Handed collected() const { return bench.collected(); }
    void SetUp() override { fs::create_directories(folder); }
};

TEST_F(Collect, flat_and_workspace_layouts)
{
    bench.write("sphere.cpp", "flat");
    EXPECT_EQ(collected().files, (Sources{{"sphere.cpp", "flat"}}));
    bench.write("raytracing/sphere/sphere.cpp", "own folder");
    bench.write("raytracing/sphere/helper.hpp", "helper");
    EXPECT_EQ(collected().files, (Sources{{"sphere.cpp", "own folder"}, {"helper.hpp", "helper"}}));
    EXPECT_TRUE(collected().missing.empty());
    EXPECT_TRUE(collected().refused.empty());
}

TEST_F(Collect, a_flat_folder_gives_only_the_units_files)
{
    bench.write("sphere.cpp", "mine");
    bench.write("triangle.cpp", "another unit's");
    EXPECT_EQ(collected().files, (Sources{{"sphere.cpp", "mine"}}));
}

TEST_F(Collect, what_is_not_there_is_missing)
{
    EXPECT_EQ(collected().missing, std::vector<std::string>{"sphere.cpp"});
    fs::remove_all(folder);
    EXPECT_THROW((void)collected(), std::system_error);
}

TEST_F(Collect, links_pipes_and_directories_are_refused)
{
    const fs::path file = folder / "sphere.cpp";
    fs::create_symlink("/etc/passwd", file);
    EXPECT_NE(collected().refused.find("sphere.cpp"), std::string::npos);
    EXPECT_TRUE(collected().files.empty());
    fs::remove(file);
    fs::create_symlink("nowhere", file);
    EXPECT_FALSE(collected().refused.empty());
    fs::remove(file);
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_FALSE(collected().refused.empty());
    fs::remove(file);
    fs::create_directory(file);
    EXPECT_FALSE(collected().refused.empty());
    EXPECT_TRUE(collected().files.empty());
}

TEST_F(Collect, linked_folders_are_not_entered)
{
    fs::create_directories(bench.elsewhere() / "sphere");
    std::ofstream(bench.elsewhere() / "sphere/sphere.cpp") << "somebody's";
    fs::create_symlink(bench.elsewhere(), folder / "raytracing");
    EXPECT_TRUE(collected().files.empty());
    fs::remove(folder / "raytracing");
    fs::create_directory(folder / "raytracing");
    fs::create_symlink(bench.elsewhere() / "sphere", folder / "raytracing/sphere");
    EXPECT_TRUE(collected().files.empty());
}

TEST_F(Collect, sizes_are_bounded)
{
    bench.write("sphere.cpp", "");
    EXPECT_EQ(collected().files.at("sphere.cpp"), "");
    bench.write("sphere.cpp", std::string(caps::source_file, ' '));
    EXPECT_EQ(collected().files.at("sphere.cpp").size(), caps::source_file);
    bench.write("sphere.cpp", std::string(caps::source_file + 1, ' '));
    EXPECT_TRUE(collected().files.empty());
    EXPECT_NE(collected().refused.find(std::to_string(caps::source_file)), std::string::npos);
    fs::resize_file(folder / "sphere.cpp", std::uintmax_t{1} << 40U);
    EXPECT_FALSE(collected().refused.empty());
}

TEST_F(Collect, counts_are_bounded_and_the_units_own_files_come_first)
{
    for (int i = 0; i < 500; ++i) bench.write("raytracing/sphere/a" + std::to_string(i) + ".hpp", "x");
    bench.write("raytracing/sphere/sphere.cpp", "mine");
    const Handed handed = collected();
    EXPECT_LE(handed.files.size(), caps::unit_files);
    EXPECT_TRUE(handed.files.contains("sphere.cpp"));
}

TEST_F(Collect, only_sources_with_plain_names_are_read)
{
    const std::string place = "raytracing/sphere/";
    bench.write(place + "sphere.cpp", "mine");
    for (const char* const name :
         {"umbral_student.hpp.gch", "student.pch", "sphere.o", "student.so", "-o evil.cpp", "@file.cpp", "sp ace.hpp",
          "quote\".cpp", "$(id).cpp", "line\nbreak.cpp", "Makefile", "noise.cpp~", ".hidden"})
        bench.write(place + name, "x");
    fs::create_directories(folder / "raytracing/sphere/umbral/raytracing");
    bench.write(place + "umbral/raytracing/intersect.hpp", "another interface");
    EXPECT_EQ(collected().files, (Sources{{"sphere.cpp", "mine"}}));
}

TEST_F(Collect, bytes_come_unchanged)
{
    const std::string odd("\xff\xfd\0 text\r\n", 10);
    bench.write("sphere.cpp", odd);
    EXPECT_EQ(collected().files.at("sphere.cpp"), odd);
}

TEST(EqualsStub, but_for_comments_and_space)
{
    const Desk bench;
    const Exercise exercise = bench.exercise("raytracing/sphere");
    const std::string stub = read_text(exercise.folder / "sphere.cpp");
    EXPECT_TRUE(equals_stub({{"sphere.cpp", stub}}, exercise));
    EXPECT_TRUE(equals_stub({{"sphere.cpp", "/* mine */ " + stub + "\n// done\n"}}, exercise));
    EXPECT_FALSE(equals_stub({{"sphere.cpp", stub + "int x;"}}, exercise));
    EXPECT_FALSE(equals_stub({{"sphere.cpp", ""}}, exercise));
    EXPECT_FALSE(equals_stub({}, exercise));
}

TEST(SubmissionId, is_plain)
{
    for (const char* const good : {"a", "Team_7.x-y", "..."}) EXPECT_TRUE(is_submission_id(good)) << good;
    for (const std::string bad : {"", ".", "..", "a/b", "a b", "a\n", "ñ", "$x", std::string(129, 'a').c_str()})
        EXPECT_FALSE(is_submission_id(bad)) << bad;
}

}
}
