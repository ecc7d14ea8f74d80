#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>

#include "run/machine_trouble.hpp"
#include "run/run_text.hpp"
#include "run/sandbox.hpp"
#include "run/source_frame.hpp"

namespace umbral::grader {
namespace {

const std::vector<std::string> roots{
    "/home/ann", "/home/ann/.cache/umbral", "/home/ann/.cache/umbral/builds/ab/cd", "/work/main", "/", ""};

TEST(RunText, roots_are_taken_away_where_a_path_begins)
{
    EXPECT_EQ(without_roots("/home/ann/.cache/umbral/builds/ab/cd/student.so: cannot map", roots),
              "student.so: cannot map");
    EXPECT_EQ(without_roots("/home/ann/.cache/umbral/x and /home/ann/y", roots), "x and y");
    EXPECT_EQ(without_roots("umbral-spawner: /work/main/framework/grid.hpp:7: at: Assertion", roots),
              "umbral-spawner: framework/grid.hpp:7: at: Assertion");
    EXPECT_EQ(without_roots("'/work/main'", roots), "''");
    EXPECT_EQ(without_roots("//work/main/a", roots), "/a");
}

TEST(RunText, other_text_stays_as_it_is)
{
    for (const char* const text : {"", "sphere.cpp:7", "/home/anna/x", "/mnt/work/main/x", "/work/mainframe",
                                   "/work/main2", "1/work/main", "/usr/include/c++/12/vector:3", "a / b", "//"}) {
        EXPECT_EQ(without_roots(text, roots), text);
    }
    EXPECT_EQ(without_roots("/work/main/x", {}), "/work/main/x");
}

TEST(SourceFrame, texts_come_back_as_they_were)
{
    const std::map<std::string, std::string> sources{
        {"", ""}, {"a.frag", std::string(70000, '\1')}, {"b.vert", std::string("\0\n\xff", 3)}};
    const auto back = unframed(framed(sources));
    EXPECT_EQ((std::map<std::string, std::string>(back.begin(), back.end())), sources);
    EXPECT_TRUE(unframed("").empty());
    EXPECT_EQ(framed({}), "");
}

TEST(SourceFrame, what_is_no_frame_is_refused)
{
    const std::string good = framed({{"a.frag", "void main() {}"}, {"b", ""}});
    for (std::size_t size = 1; size < good.size(); ++size) {
        const std::string part = good.substr(0, size);
        if (part == framed({{"a.frag", "void main() {}"}})) continue;
        EXPECT_THROW((void)unframed(part), std::runtime_error) << size;
    }
    EXPECT_THROW((void)unframed(good + good), std::runtime_error) << "one name twice";
    std::string huge = good;
    std::memset(huge.data(), 0xff, 16);
    EXPECT_THROW((void)unframed(huge), std::runtime_error);
}

TEST(MachineTrouble, says_what_is_short_and_what_to_do)
{
    EXPECT_NE(machine_trouble(EAGAIN, "fork").find("no process left"), std::string::npos);
    EXPECT_NE(machine_trouble(EAGAIN, "fork").find("(fork: Resource temporarily unavailable)"), std::string::npos);
    EXPECT_NE(machine_trouble(ENOMEM, "mmap").find("no memory left"), std::string::npos);
    for (const int error : {EMFILE, ENFILE})
        EXPECT_NE(machine_trouble(error, "memfd_create").find("no open file left"), std::string::npos);
    EXPECT_NE(machine_trouble(std::system_error(EMFILE, std::generic_category(), "socketpair")).find("socketpair"),
              std::string::npos);
    EXPECT_NE(machine_trouble(EPERM, "unshare").find("refused: unshare"), std::string::npos);
}

TEST(CallName, calls_of_other_interfaces_are_named_so)
{
    EXPECT_EQ(sandbox::call_name(57 | sandbox::other_architecture), "a call through the 32-bit interface");
#if defined(__x86_64__)
    EXPECT_EQ(sandbox::call_name(57), "fork");
    EXPECT_EQ(sandbox::call_name(57 | 0x40000000U), "a call through the x32 interface");
#endif
    EXPECT_EQ(sandbox::call_name(9999), "call 9999");
    EXPECT_EQ(sandbox::call_name(~0U), "call 4294967295");
}

}
}
