#include <gtest/gtest.h>

#include <filesystem>

#include "program.hpp"
#include "support/temporary_folder.hpp"

// Where a student's file is wrong, with the real program.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;

/// A workspace with a right file in which this is changed.
void write_work(const TemporaryFolder& folder, const std::string& right, const std::string& wrong)
{
    std::string text = read(fs::path(UMBRAL_SOURCE) / "exercises/raytracing/sphere/alternatives/double_precision.cpp");
    const std::size_t at = text.find(right);
    if (at == std::string::npos) throw std::runtime_error("no '" + right + "' in the alternative");
    folder.write("raytracing/sphere/sphere.cpp", text.replace(at, right.size(), wrong));
}

/// `umbral locate sphere` there, with these options.
Printed located(const TemporaryFolder& folder, const std::string& right, const std::string& wrong,
                const std::string& options = "--seconds 20")
{
    write_work(folder, right, wrong);
    return umbral("locate sphere --dir '" + folder.path().string() + "' " + options);
}

void expect_parts(const Printed& printed, std::initializer_list<const char*> parts)
{
    for (const char* const part : parts)
        EXPECT_NE(printed.text.find(part), std::string::npos) << part << " in\n" << printed.text;
}

TEST(Locate, shows_the_line_and_keeps_the_change_until_asked)
{
    const TemporaryFolder folder;
    const Printed printed = located(folder, "ray.t_min < t", "ray.t_min > t");
    if (printed.text.find("libclang") != std::string::npos) GTEST_SKIP() << "NOTHING WAS LOCATED: " << printed.text;
    EXPECT_EQ(printed.status, 1) << printed.text;
    expect_parts(printed, {"sphere.cpp:20: a small change here makes", "if (ray.t_min > t && t < ray.t_max)",
                           "^^^^^^^^^^^^^", "Look at this comparison", "--show says which change"});
    EXPECT_EQ(printed.text.find("ray.t_min < t"), std::string::npos) << printed.text;
    // The place is underlined where it is seen: a tab is shown as four spaces, and a letter of two bytes is as wide as
    // any.
    expect_parts(located(folder, "        if (ray.t_min < t", "\t/* ángulo */ if (ray.t_min > t"),
                 {"|     /* á", "\n      |                      ^^^^^^^^^^^^^\n"});
    const Printed shown = located(folder, "ray.t_min < t", "ray.t_min > t", "--seconds 20 --show");
    expect_parts(shown, {"The change: ray.t_min > t → ray.t_min < t"});
}

TEST(Locate, says_so_where_nothing_is_wrong_or_nothing_is_found)
{
    const TemporaryFolder folder;
    const Printed right = located(folder, "ray.t_min < t", "ray.t_min < t");
    if (right.text.find("libclang") != std::string::npos) GTEST_SKIP() << "NOTHING WAS LOCATED: " << right.text;
    EXPECT_EQ(right.status, 0) << right.text;
    expect_parts(right, {"Nothing is wrong in raytracing/sphere"});
    // On a slow machine it would be told that there was no time for all.
    const Printed hopeless =
        located(folder, "const double a = dot(d, d);", "const double a = 1e9; return {};", "--seconds 600");
    EXPECT_EQ(hopeless.status, 1) << hopeless.text;
    expect_parts(hopeless, {"small changes of one place that are tried makes a wrong check right",
                            "`umbral debug sphere --dir "});
}

TEST(Locate, is_named_where_nothing_explains_what_is_wrong)
{
    const TemporaryFolder folder;
    write_work(folder, "dot(o, o) - radius", "dot(o, o) * 0.9 - radius");
    const Printed checked = umbral("check sphere --dir '" + folder.path().string() + "'");
    expect_parts(checked, {"`umbral locate sphere --dir ", "` looks for the line"});
    write_work(folder, "ray.t_min < t", "ray.t_min < t");
    const Printed right = umbral("check sphere --dir '" + folder.path().string() + "'");
    EXPECT_EQ(right.text.find("umbral locate"), std::string::npos) << right.text;
}

// libclang reads the file as confined as the compiler does: what lies outside is not there.
TEST(Locate, refuses_what_does_not_compile_or_is_not_cpp)
{
    const TemporaryFolder folder;
    EXPECT_EQ(located(folder, "const double a", "const doubl a").status, 2);
    EXPECT_EQ(located(folder, "#include <cmath>", "#include \"/etc/passwd\"").status, 2);
    EXPECT_EQ(umbral("locate lighting/shaders").status, 2);
    // Compiles, but what finds changes goes as deep as expressions are nested.
    std::string terms = "const double a = 0.9 * dot(d, d)";
    for (int i = 0; i < 3000; ++i) terms += " + 0.0";
    const Printed deep = located(folder, "const double a = dot(d, d)", terms);
    EXPECT_TRUE(deep.status == 1 || deep.status == 2) << deep.text;
    EXPECT_EQ(deep.text.find("fault"), std::string::npos) << deep.text;
    EXPECT_EQ(umbral("locate zzz").status, 2);
}

}
}
