#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "program.hpp"
#include "support/temporary_folder.hpp"

// Commands in a workspace that somebody has sent, with the real program: they write nothing outside of it.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;

/// A workspace, and beside it what no command may touch.
class SentWorkspace : public testing::Test {
protected:
    SentWorkspace()
    {
        fs::create_directories(workspace / "raytracing/sphere");
        fs::create_directories(outside);
    }
    void plant_link(const std::string& name, const std::string& leads_to) const
    {
        fs::create_directories((workspace / name).parent_path());
        fs::remove_all(workspace / name);
        fs::create_symlink(outside / leads_to, workspace / name);
    }
    void expect_a_refusal_that_names_the_link(const std::string& command) const
    {
        const Printed printed = umbral(command);
        EXPECT_EQ(printed.status, 2) << printed.text;
        EXPECT_NE(printed.text.find("is a link"), std::string::npos) << printed.text;
        EXPECT_TRUE(fs::is_empty(outside)) << command;
    }

    TemporaryFolder folder;
    fs::path workspace = folder / "sent";
    fs::path outside = folder / "outside";
    std::string make = "new " + workspace.string() + " sphere";
    std::string reset = "reset sphere --dir " + workspace.string();
};

TEST_F(SentWorkspace, files_that_are_links_are_replaced_and_not_followed)
{
    folder.write("outside/precious", "precious");
    plant_link("raytracing/sphere/README.md", "precious");
    plant_link("include/umbral/student.hpp", "precious");
    plant_link("raytracing/sphere/sphere.cpp", "new.cpp");
    plant_link("compile_flags.txt", "new.txt");
    fs::create_hard_link(outside / "precious", workspace / "raytracing/sphere/README.es.md");
    ASSERT_EQ(umbral(make).status, 0);
    EXPECT_EQ(read(outside / "precious"), "precious");
    EXPECT_TRUE(fs::is_symlink(workspace / "raytracing/sphere/sphere.cpp")) << "what is there stays";
    ASSERT_EQ(umbral(reset).status, 0);
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(workspace / "raytracing/sphere/sphere.cpp")));
    EXPECT_EQ(std::distance(fs::directory_iterator(outside), {}), 1) << "nothing new outside";
}

TEST_F(SentWorkspace, folders_that_are_links_are_refused)
{
    for (const char* const planted : {"raytracing/sphere", "raytracing"}) {
        plant_link(planted, "");
        expect_a_refusal_that_names_the_link(make);
        expect_a_refusal_that_names_the_link(reset);
        fs::remove(workspace / planted);
    }
    for (const char* const planted : {"include/umbral", "include"}) {
        plant_link(planted, "");
        expect_a_refusal_that_names_the_link(make);
        fs::remove(workspace / planted);
    }
}

TEST_F(SentWorkspace, a_pipe_is_replaced_and_not_waited_for)
{
    ASSERT_EQ(mkfifo((workspace / "raytracing/sphere/README.md").c_str(), S_IRUSR | S_IWUSR), 0);
    EXPECT_EQ(run("timeout 60 " UMBRAL_PROGRAM " " + make).status, 0);
    EXPECT_TRUE(fs::is_regular_file(workspace / "raytracing/sphere/README.md"));
}

}
}
