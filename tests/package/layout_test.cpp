#include "cli/layout.hpp"

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

// A program knows by what lies around it whether it is in a build or below a prefix.
namespace umbral::test {
namespace {

using grader::Layout;
using grader::layout_around;

/// What layout_around says of a program at `program`.
std::string complaint_about(const std::filesystem::path& program)
{
    try {
        (void)layout_around(program);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(LayoutTest, of_a_build_is_the_checkout_that_its_note_names)
{
    const TemporaryFolder folder;
    folder.write("sources/exercises/topic/unit/exercise.json", "{}");
    folder.write("build/checkout.txt", (folder / "sources").string() + "\n");
    const Layout layout = layout_around(folder / "build/bin/umbral");
    EXPECT_FALSE(layout.installed);
    EXPECT_EQ(layout.build, folder / "build");
    EXPECT_EQ(layout.data, folder / "sources");
    EXPECT_EQ(layout.samples, folder / "sources/tests/class");
}

TEST(LayoutTest, of_an_installation_is_below_its_prefix)
{
    const TemporaryFolder folder;
    folder.write("any prefix/share/umbral/exercises/topic/unit/exercise.json", "{}");
    const Layout layout = layout_around(folder / "any prefix/lib/umbral/bin/umbral");
    EXPECT_TRUE(layout.installed);
    EXPECT_EQ(layout.build, folder / "any prefix/lib/umbral");
    EXPECT_EQ(layout.data, folder / "any prefix/share/umbral");
    EXPECT_EQ(layout.includes, folder / "any prefix/share/umbral/student/umbral_student.hpp");
}

TEST(LayoutTest, says_where_it_looked_in_vain)
{
    const TemporaryFolder folder;
    EXPECT_NE(complaint_about(folder / "lib/umbral/bin/umbral").find((folder / "share/umbral/exercises").string()),
              std::string::npos);
    folder.write("build/checkout.txt", "/no/such/folder\n");
    EXPECT_NE(complaint_about(folder / "build/bin/umbral").find("/no/such/folder"), std::string::npos);
}

}
}
