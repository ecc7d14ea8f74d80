#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <regex>

#include "sources.hpp"

namespace umbral::test {
namespace {

namespace fs = std::filesystem;

/// Work of students, real or as if: not ours to tidy.
bool is_submission(const fs::path& file)
{
    // tests/attacks/THEME/NAME/…; what lies in tests/attacks itself runs them.
    return file.string().starts_with("tests/class/") ||
           (file.string().starts_with("tests/attacks/") && std::distance(file.begin(), file.end()) > 3);
}

std::vector<fs::path> our_cpp_files()
{
    std::vector<fs::path> all;
    for (const char* const folder : {"framework", "reference", "exercises", "grader", "tests"})
        for (const fs::path& file : files_below(folder))
            if (is_cpp(file) && !is_submission(file)) all.push_back(file);
    return all;
}

/// A stub is a file of exercises/<topic>/<unit>/ itself, but the driver.
bool is_stub(const fs::path& file)
{
    return std::distance(file.begin(), file.end()) == 4 && *file.begin() == "exercises" &&
           file.filename() != "driver.cpp" && file.extension() != ".hpp" && file.extension() != ".md";
}

// Spelled in two parts, or this file would be found as well.
TEST(Tidiness, only_stubs_leave_something_to_do)
{
    // As a comment: a test may hold the word in a text.
    const std::regex left(R"re((^|[^"])(//|/\*|#).*\b(TO)re"
                          R"re(DO|FIX)re"
                          R"re(ME|X)re"
                          R"re(XX)\b)re");
    for (const char* const folder : {"framework", "reference", "exercises", "grader", "tests", "cmake"}) {
        for (const fs::path& file : files_below(folder)) {
            if (is_stub(file) || is_submission(file)) continue;
            for (const Line& line : lines_of(file)) EXPECT_FALSE(std::regex_search(line.text, left)) << line.where();
        }
    }
}

TEST(Tidiness, files_are_short)
{
    const std::vector<fs::path> files = our_cpp_files();
    EXPECT_GT(files.size(), 100U);
    for (const fs::path& file : files) EXPECT_LT(lines_of(file).size(), 300U) << file;
}

// What a header holds must not depend on which file of a program includes it first.
TEST(Tidiness, no_header_includes_a_source_file)
{
    const std::regex include(R"re(^\s*#\s*include\s*[<"].*\.(cpp|cc|c)[>"].*)re");
    std::size_t seen = 0;
    for (const fs::path& file : our_cpp_files()) {
        if (file.extension() != ".hpp") continue;
        ++seen;
        for (const Line& line : lines_of(file)) EXPECT_FALSE(std::regex_match(line.text, include)) << line.where();
    }
    EXPECT_GT(seen, 200U);
}

// libstdc++'s regular expressions call themselves once for each character: a comment of 26 KB in a shader overflowed
// the stack.
TEST(Tidiness, no_regular_expressions_on_foreign_text)
{
    const std::string header = std::string("<reg") + "ex>";
    std::size_t seen = 0;
    for (const char* const folder : {"grader", "framework", "reference", "exercises"})
        for (const fs::path& file : files_below(folder)) {
            // Generators read the system's own headers, when the project is built.
            if (!is_cpp(file) || file.parent_path().filename() == "generate") continue;
            ++seen;
            for (const Line& line : lines_of(file))
                EXPECT_EQ(line.text.find(header), std::string::npos) << line.where();
        }
    EXPECT_GT(seen, 500U);
}

// One library reaches OpenGL's back end, and that one at run time: any other way would bypass the traces.
TEST(Tidiness, only_umbral_gl_knows_the_back_end)
{
    const std::regex back_end(
        "OSMesa|OpenGL::|GLESv|GL::GL|PkgConfig::(GL|EGL)|-l(GL|EGL)\\b|find_package\\((OpenGL|GLEW)",
        std::regex::icase);
    std::vector<fs::path> files = {"CMakeLists.txt"};
    for (const char* const folder : {"framework", "exercises", "reference", "grader", "tests", "cmake"})
        for (const fs::path& file : files_below(folder))
            if (file.filename() == "CMakeLists.txt" || file.extension() == ".cmake") files.push_back(file);
    for (const fs::path& file : files) {
        if (file == "framework/umbral/gl/CMakeLists.txt") continue;
        for (const Line& line : lines_of(file)) {
            const std::string code = line.text.substr(0, line.text.find('#'));
            EXPECT_FALSE(std::regex_search(code, back_end)) << line.where();
        }
    }
}

/// What builds: the launcher, and CMake's files.
std::vector<fs::path> build_files()
{
    std::vector<fs::path> all{"umbral", "CMakeLists.txt"};
    for (const char* const folder : {"cmake", "framework", "reference", "exercises", "grader", "tests"})
        for (const fs::path& file : files_below(folder))
            if (file.filename() == "CMakeLists.txt" || file.extension() == ".cmake") all.push_back(file);
    return all;
}

// clang-format does not break what stands in a string.
TEST(Tidiness, no_line_is_longer_than_120_columns)
{
    std::vector<fs::path> files = our_cpp_files();
    std::ranges::copy(build_files(), std::back_inserter(files));
    for (const fs::path& file : files)
        for (const Line& line : lines_of(file)) {
            const auto columns = std::ranges::count_if(line.text, [](char c) { return (c & 0xC0) != 0x80; });
            EXPECT_LE(columns, 120) << line.where();
        }
}

TEST(Tidiness, the_format_is_kept)
{
    if (std::system("clang-format --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "clang-format is not installed: THE FORMAT OF NO FILE WAS CHECKED";
    // Many files a call: starting the program a thousand times takes longer than its work.
    constexpr std::size_t files_a_call = 100;
    std::string names;
    const auto check = [&] {
        const std::string command = "cd '" UMBRAL_SOURCE_DIR "' && clang-format --dry-run -Werror" + names;
        EXPECT_EQ(std::system(command.c_str()), 0) << "run clang-format -i on the files named above";
        names.clear();
    };
    std::size_t count = 0;
    for (const fs::path& file : our_cpp_files()) {
        names += " '" + file.string() + "'";
        if (++count % files_a_call == 0) check();
    }
    if (!names.empty()) check();
}

}
}
