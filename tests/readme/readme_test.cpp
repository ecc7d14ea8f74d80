#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "cli/authors/benchmarks.hpp"
#include "readme/commands.hpp"
#include "support/all_tests.hpp"
#include "support/printed.hpp"
#include "support/temporary_folder.hpp"

// Whatever README.md tells its readers to call is called here as it stands there, or in another way, for which the
// table below gives the reason.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;
const fs::path source = UMBRAL_SOURCE;

struct Instead {
    std::string run;  ///< empty: nothing
    std::string reason;
    bool only_in_ci = false;  ///< `./umbral test --all` runs it as it stands
};

const std::map<std::string, Instead> not_as_it_stands{
    {"./umbral demo", {"umbral demo --help", "it grades a class of ten, and the launcher may install packages"}},
    {"./umbral test", {"", "this test is a part of it"}},
    {"./umbral test --all", {"", "this test is a part of it"}},
    {"./umbral --no-install demo", {"", "the launcher's own test calls it so, where packages are missing"}},
    {"umbral check --watch", {"timeout -s INT 2 umbral check --watch; [ $? = 124 ]", "it ends when somebody ends it"}},
    {"umbral debug sphere head-on",
     {"umbral debug sphere head-on --no-debugger", "a debugger waits for what is typed"}},
    {"umbral new-unit topic/my-unit",
     {"umbral new-unit topic/my-unit --help", "it writes into the sources; NewUnit's tests do, in a copy of them"}},
    {"umbral refresh sphere", {"umbral refresh sphere --check", "it writes into the sources"}},
    {"umbral validate sphere --seeds 5",
     {"umbral validate sphere --seeds 5 --help", "umbral validate --table runs with one set of inputs"}},
    {"umbral validate --table FILE", {"umbral validate sphere --seeds 1 --table FILE", "all units take minutes"}},
    {"umbral bench findings", {"umbral bench findings --help", "umbral validate --table runs"}},
    {"umbral bench outcomes",
     {"umbral bench outcomes --help", "all attacks take hours, and attacks-test runs a third of them"}},
    {"umbral bench fuzz", {"umbral bench fuzz --help", "it needs a build of its own"}},
    {"umbral bench budget --width 64 --rays 256 --error 0.03",
     {"umbral bench budget --quick", "it draws eight converged pictures, and all settings"}},
    {"umbral bench compilers",
     {"umbral bench compilers --help", "each setting compiles all references anew: minutes", true}},
    {"umbral bench raster --seconds 5", {"umbral bench raster --quick", "five seconds for each of sixteen rows"}},
};

std::vector<Command> readme()
{
    static const std::vector<Command> commands = commands_of(read(source / "README.md"));
    return commands;
}

bool measures(const Command& command) { return command.text.starts_with("umbral bench"); }

/// What is run for a command; empty if nothing is.
std::string call_of(const Command& command)
{
    auto found = not_as_it_stands.find(command.text);
    if (found != not_as_it_stands.end() && found->second.only_in_ci && tests_all()) found = not_as_it_stands.end();
    std::string call = found == not_as_it_stands.end() ? command.text : found->second.run;
    if (found == not_as_it_stands.end() && call.starts_with("umbral bench ")) call += " --quick";
    if (const std::size_t at = call.find("FILE"); at != std::string::npos) call.replace(at, 4, "made");
    return call;
}

/// The work of students falls short, pictures differ, and machines miss something: then these end with 1.
bool may_fall_short(const std::string& call)
{
    constexpr std::array judging{"umbral check", "umbral compare", "umbral doctor", "umbral locate"};
    return std::ranges::any_of(judging, [&](const char* command) { return call.starts_with(command); });
}

class Readme : public testing::Test {
protected:
    void SetUp() override
    {
        fs::create_directories(folder_ / "bin");
        fs::create_symlink(UMBRAL_PROGRAM, folder_ / "bin/umbral");
    }

    /// A folder with what readers are supposed to have.
    [[nodiscard]] fs::path prepared(const std::string& name) const
    {
        const fs::path here = folder_ / name;
        for (const char* const student : {"ana", "bruno"})
            folder_.write(fs::path(name) / "submissions" / student / "raytracing/sphere/sphere.cpp",
                          read(source / "reference/raytracing/sphere.cpp"));
        folder_.write(fs::path(name) / "secret", "a secret of this test's, long enough");
        fs::permissions(here / "secret", fs::perms::owner_read | fs::perms::owner_write);
        fs::create_directory_symlink(source / "reference", here / "reference");
        fs::create_directory_symlink(source / "build", here / "build");
        for (const char* const picture : {"mine.png", "right.png"})
            fs::copy_file(source / "docs/pictures/first-light.png", here / picture);
        return here;
    }

    void expect_runs(const Command& command, const fs::path& here) const
    {
        const std::string call = call_of(command);
        if (call.empty()) return;
        const auto start = std::chrono::steady_clock::now();
        const Printed printed =
            run("cd '" + here.string() + "' && exec </dev/null && export UMBRAL_CACHE='" +
                (folder_ / "cache").string() + "' PATH='" + (folder_ / "bin").string() + "':\"$PATH\" && " + call);
        std::printf("%5.1f s  %s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                    call.c_str());
        (void)std::fflush(stdout);
        EXPECT_TRUE(printed.status == 0 || (printed.status == 1 && may_fall_short(call)))
            << "README.md:" << command.line << ": `" << command.text << "` ended with " << printed.status << "\n"
            << printed.text;
        EXPECT_EQ(printed.text.find("umbral: a fault of Umbral's own"), std::string::npos) << printed.text;
    }

    TemporaryFolder folder_;
};

// The lines of a block follow one another, as `cd` says.
TEST_F(Readme, commands_in_blocks_run)
{
    int block = -1;
    fs::path here;
    for (const Command& command : readme()) {
        if (command.block < 0 || measures(command)) continue;
        if (command.block != block) here = prepared("block" + std::to_string(command.block));
        block = command.block;
        if (command.text.starts_with("cd "))
            here /= command.text.substr(3);
        else
            expect_runs(command, here);
        ASSERT_TRUE(fs::is_directory(here)) << here;
    }
    EXPECT_GE(block, 4);
}

TEST_F(Readme, commands_in_sentences_and_tables_run)
{
    const fs::path here = prepared("here");
    const Printed made = run(std::string(UMBRAL_PROGRAM) + " new " + (here / "work").string() + " sphere");
    ASSERT_EQ(made.status, 0) << made.text;
    fs::create_directory_symlink(source / "reference", here / "work/reference");
    std::set<std::string> seen;
    for (const Command& command : readme())
        if (command.block >= 0) seen.insert(command.text);
    const std::size_t in_blocks = seen.size();
    for (const Command& command : readme())
        if (command.block < 0 && !measures(command) && seen.insert(command.text).second)
            expect_runs(command, here / "work");
    EXPECT_GE(seen.size(), in_blocks + 3);
}

TEST_F(Readme, benchmarks_run)
{
    const fs::path here = prepared("here");
    std::set<std::string> seen;
    // Each takes some seconds: CI runs every fourth.
    std::size_t count = 0;
    for (const Command& command : readme())
        if (measures(command) && seen.insert(command.text).second && (tests_all() || count++ % 4 == 0))
            expect_runs(command, here);
    // Figures of the documents come from these, so that each is named.
    for (const grader::Benchmark& benchmark : grader::benchmarks())
        EXPECT_TRUE(std::ranges::any_of(
            seen,
            [&](const std::string& text) { return (text + " ").starts_with("umbral bench " + benchmark.name + " "); }))
            << "README.md does not name umbral bench " << benchmark.name;
}

TEST_F(Readme, what_is_run_in_another_way_stands_there)
{
    for (const auto& [text, instead] : not_as_it_stands)
        EXPECT_TRUE(std::ranges::any_of(readme(), [&](const Command& command) { return command.text == text; }))
            << text << ": " << instead.reason;
}

TEST_F(Readme, commands_that_do_not_exist_are_noticed)
{
    for (const char* const text :
         {"umbral bench nothing", "umbral nothing", "umbral check --nothing", "build/release/bin/nothing"}) {
        const fs::path here = folder_.path();
        const Printed printed = run("cd '" + here.string() + "' && PATH='" + (here / "bin").string() +
                                    "':\"$PATH\" && " + call_of({text, 1, -1}));
        EXPECT_GE(printed.status, 2) << text << printed.text;
    }
}

}
}
