#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "support/printed.hpp"

namespace umbral::test {
namespace {

// Students' code runs in forks of the spawners, and can read all of their memory. A linker takes a library's object
// files whole: where files are compiled together, one needed function brings its neighbours along.
TEST(Linked, spawners_hold_nothing_of_marks)
{
    const std::filesystem::path folder = UMBRAL_PROGRAM_FOLDER;
    const std::string grader = read(folder / "umbral");
    const std::string spawner = read(folder / "umbral-spawner");
    const std::string spawner_gl = read(folder / "umbral-spawner-gl");
    ASSERT_FALSE(spawner.empty());
    ASSERT_FALSE(spawner_gl.empty());
    for (const char* word : {"secret", "millipoints", "rubric", "oracle", "libcrypto"}) {
        EXPECT_NE(grader.find(word), std::string::npos) << word << " is no word of the grader: this test is blind";
        EXPECT_EQ(spawner.find(word), std::string::npos) << word;
        EXPECT_EQ(spawner_gl.find(word), std::string::npos) << word;
    }
}

// A student's code lies in one process with the driver: what it may not call must not be found there by name.
TEST(Linked, drivers_export_their_cases_and_what_students_may_call)
{
    std::size_t drivers = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(UMBRAL_UNITS_FOLDER)) {
        if (entry.path().filename() != "driver.so") continue;
        ++drivers;
        std::istringstream symbols(run("nm --dynamic --defined-only --format=posix " + entry.path().string()).text);
        bool has_cases = false;
        for (std::string name; symbols >> name; symbols.ignore(1000, '\n')) {
            EXPECT_TRUE(name.starts_with("_ZN6umbral") || name.starts_with("_ZNK6umbral") || name.starts_with("_ZT"))
                << entry.path() << " exports " << name;
            has_cases = has_cases || name == "_ZN6umbral6driverE";
        }
        EXPECT_TRUE(has_cases) << entry.path();
    }
    EXPECT_GT(drivers, 0U);
}

// One of two functions of a name, one of them inline, is called in place of the other, and no compiler says so.
TEST(Linked, no_function_is_defined_in_two_libraries)
{
    struct Definitions {
        std::set<std::string> by_themselves{};
        std::set<std::string> inlines{};
    };
    std::map<std::string, Definitions> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(UMBRAL_GRADER_FOLDER)) {
        if (entry.path().extension() != ".a") continue;
        const std::string library = entry.path().filename().string();
        std::istringstream lines(run("nm --defined-only --format=posix " + entry.path().string()).text);
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string name;
            std::string kind;
            if (!(words >> name >> kind) || name.find("6umbral") == std::string::npos) continue;
            if (kind == "T") all[name].by_themselves.insert(library);
            if (kind == "W") all[name].inlines.insert(library);
        }
    }
    EXPECT_GT(all.size(), 1000U);
    for (const auto& [name, where] : all) {
        EXPECT_LE(where.by_themselves.size(), 1U) << name;
        if (where.by_themselves.size() != 1) continue;
        for (const std::string& library : where.inlines)
            EXPECT_EQ(library, *where.by_themselves.begin()) << name << " is inline there";
    }
}

}
}
