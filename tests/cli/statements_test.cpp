#include <gtest/gtest.h>

#include <filesystem>

#include "cli/application.hpp"
#include "cli/authors/interface_block.hpp"
#include "cli/commands.hpp"
#include "collect/sources.hpp"
#include "manifest/statement_table.hpp"
#include "manifest/statements.hpp"
#include "support/temporary_folder.hpp"
#include "validate/validate.hpp"

// What the program does with statements: interface blocks, hints, missing languages.
namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

const std::string header = R"(#pragma once

#include <vector>
#include <umbral/core/ray.hpp>

namespace umbral::meshes {

/// A thing.
struct Thing {
    int a = 0;

    int b = 0;
};

/// Has secrets.
class Keeper {
public:
    Keeper() { count_ = {}; }

private:
    int count_;
};

/// Counts { and ;.
[[nodiscard]] inline int count(const Thing& thing)
{
    return thing.a;
}

enum class Kind : int { one, two };

/// Of the thing.
namespace measures {
inline constexpr int height = 2;
}

}
)";

TEST(InterfaceOfAHeader, leaves_out_what_only_the_compiler_needs)
{
    EXPECT_EQ(shown_of_header(header, {}), R"(/// A thing.
struct Thing {
    int a = 0;

    int b = 0;
};

/// Has secrets.
class Keeper {
public:
    Keeper() { count_ = {}; }
};

/// Counts { and ;.
[[nodiscard]] inline int count(const Thing& thing)
{
    return thing.a;
}

enum class Kind : int { one, two };

/// Of the thing.
namespace measures {
inline constexpr int height = 2;
}
)");
}

TEST(InterfaceOfAHeader, shows_only_what_is_named)
{
    EXPECT_EQ(
        shown_of_header(header, {"Kind", "Thing"}),
        "/// A thing.\nstruct Thing {\n    int a = 0;\n\n    int b = 0;\n};\n\nenum class Kind : int { one, two };\n");
    EXPECT_TRUE(shown_of_header(header, {"count"}).starts_with("/// Counts")) << "a function's name, not its types'";
    EXPECT_THROW((void)shown_of_header(header, {"Thing", "nothing"}), std::runtime_error);
}

TEST(InterfaceOfAShader, ends_before_main)
{
    // Spelled in two parts, or the test of tidiness would find it.
    EXPECT_EQ(shown_of_shader("#version 330\n\nin vec3 position;\n\n// TO"
                              "DO: all\n\nvoid main()\n{\n}\n"),
              "#version 330\n\nin vec3 position;\n");
}

TEST(InterfaceBlock, is_made_and_kept_up_to_date)
{
    const Application application = make_application();
    const Exercise sphere = application.chosen({"sphere"}).front();
    const InterfaceSources sources{sphere, application.tools.framework};
    EXPECT_EQ(interface_files(sphere), (std::vector<std::string>{"umbral/raytracing/intersect.hpp"}));
    const std::string made = with_interfaces("# T\n\n## What\nOne.\n\n## Why\nTwo.\n", "## Interface", sources);
    EXPECT_TRUE(made.starts_with(
        "# T\n\n## What\nOne.\n\n## Interface\n\n<!-- interface umbral/raytracing/intersect.hpp -->\n```cpp\n"))
        << made;
    EXPECT_TRUE(made.ends_with("```\n<!-- /interface -->\n\n## Why\nTwo.\n")) << made;
    EXPECT_EQ(with_interfaces(made, "## Interface", sources), made);
    std::string stale = made;
    stale.insert(stale.find("intersect("), "old_");
    EXPECT_EQ(with_interfaces(stale, "## Interface", sources), made);
}

TEST(InterfaceBlock, that_cannot_be_made_is_named_by_its_line)
{
    const Application application = make_application();
    const Exercise sphere = application.chosen({"sphere"}).front();
    const auto complaint = [&](const std::string& text) -> std::string {
        try {
            (void)with_interfaces(text + "\n<!-- interface umbral/raytracing/intersect.hpp -->\n<!-- /interface -->\n",
                                  "## Interface", {sphere, application.tools.framework});
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(complaint("# T\n"), "none");
    EXPECT_NE(complaint("# T\n<!-- interface umbral/core/ray.hpp -->\n").find("line 2: expected"), std::string::npos);
    EXPECT_NE(
        complaint("<!-- interface umbral/core/ray.hpp: Beam -->\n<!-- /interface -->").find("nothing called Beam"),
        std::string::npos);
    EXPECT_NE(complaint("<!-- interface umbral/no.hpp -->\n<!-- /interface -->").find("umbral/no.hpp"),
              std::string::npos);
}

TEST(Statements, show_their_interfaces_as_they_are)
{
    const Application application = make_application();
    for (const Exercise& exercise : application.exercises)
        for (const Language& language : languages) {
            const std::string statement = read_text(exercise.folder / language.statement);
            EXPECT_EQ(statement,
                      with_interfaces(statement, language.interface, {exercise, application.tools.framework}))
                << exercise.id << "/" << language.statement << " is not up to date; run: umbral refresh "
                << exercise.name;
        }
}

/// What `umbral hint` prints of a unit in a language.
std::string hint_of(Application& application, const std::string& line)
{
    CommandLine program("umbral", "", "");
    add_hint(program.program().command("hint", ""), application);
    testing::internal::CaptureStdout();
    EXPECT_EQ(program.run(line), "");
    return testing::internal::GetCapturedStdout();
}

/// A hidden check that fails alone leaves its student with nothing but this. A unit that is marked by a rubric shows
/// that instead of its checks.
TEST(Statements, say_of_each_hidden_check_what_it_looks_at)
{
    for (const Exercise& exercise : make_application().exercises)
        for (const Check& check : exercise.checks)
            EXPECT_TRUE(!check.hidden || !exercise.rubric.empty() || !check.about.empty())
                << exercise.id << ": 'What is checked' has no line called " << check.case_name;
}

TEST(StatementTable, finds_the_line_of_a_check)
{
    const std::vector<StatementLine> lines = statement_lines(
        "## What it is\n| far | no |\n## What is checked\nWords.\n| check | points | what is judged |\n|---|---|---|\n"
        "| far (hidden, hard) | 1 | far \\| `away`, see [that](there.md) |\n| near, nearly so (hidden) | 1 | the same, "
        "near |\n| laws/turned | 1 | a law |\n| frames: first | 1 | one |\n| frames: end, alive | 1 | ends |\n| "
        "lamps/near, far | 1 | likewise |\n| known, random (hidden) boxes | 1 | "
        "boxes "
        "|\n## What goes wrong\n| behind | no |\n");
    const auto says = [&](const char* case_name, const char* value) { return statement_says(lines, case_name, value); };
    EXPECT_EQ(lines.size(), 7U);
    EXPECT_EQ(says("far", "t"), "far | `away`, see that");
    EXPECT_EQ(says("near", "t"), "far | `away`, see that; the same, near");
    EXPECT_EQ(says("nearly so", "t"), says("near", "t"));
    EXPECT_EQ(says("laws", "turned"), "a law");
    EXPECT_EQ(says("frames", "alive"), "ends");
    EXPECT_EQ(says("frames", "middle"), "") << "other lines are about its other values";
    EXPECT_EQ(says("lamps", "far"), "ends");
    EXPECT_EQ(says("random boxes", "t"), "boxes");
    EXPECT_EQ(says("nearly", "t"), "") << "a part of a name is no name";
    EXPECT_EQ(says("behind", "t"), "");
    EXPECT_EQ(says("", "t"), "");
    EXPECT_TRUE(statement_lines("").empty());
}

TEST(Statements, have_as_many_hints_in_both_languages)
{
    Application application = make_application();
    for (const Exercise& exercise : application.exercises) {
        const std::string english = hint_of(application, "hint " + exercise.id);
        const std::string spanish = hint_of(application, "hint " + exercise.id + " --language es");
        ASSERT_TRUE(english.starts_with("Hint 1 of ")) << english;
        ASSERT_TRUE(spanish.starts_with("Pista 1 de ")) << spanish;
        EXPECT_EQ(english.substr(10, english.find(':') - 10), spanish.substr(11, spanish.find(':') - 11))
            << exercise.id;
        EXPECT_EQ(english.find("details>"), std::string::npos) << english;
        EXPECT_EQ(english.find("summary>"), std::string::npos) << english;
        EXPECT_NE(spanish.find("umbral hint " + exercise.name + " 2 --language es"), std::string::npos) << spanish;
    }
}

TEST(Statements, a_missing_one_is_a_finding_that_does_not_hold)
{
    const test::TemporaryFolder folder;
    Exercise exercise;
    exercise.folder = folder.path();
    EXPECT_EQ(expect_statements(exercise, 0).message, "missing: README.md, README.es.md");
    folder.write("README.md", "# T\n");
    EXPECT_FALSE(expect_statements(exercise, 0).holds);
    EXPECT_EQ(expect_statements(exercise, 0).message, "missing: README.es.md");
    folder.write("README.es.md", "# T\n");
    EXPECT_TRUE(expect_statements(exercise, 0).holds);
}

}
}
