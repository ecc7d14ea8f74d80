#include "readme/commands.hpp"

#include <gtest/gtest.h>

namespace umbral::test {
namespace {

TEST(Commands, are_found_in_blocks_tables_and_sentences)
{
    const auto found = commands_of(
        "`umbral` stands for the launcher; `umbral list --html FILE` shows pictures.\n"
        "```sh\n"
        "umbral new work   # a workspace\n"
        "cd work\n"
        "# nothing\n"
        "umbral hint sphere        # a hint; `umbral hint sphere 2` is a step more\n"
        "```\n"
        "| what | 3 ms | `A=1 B=$(mktemp -d) build/release/bin/bench-x --seconds 5` |\n"
        "```\n"
        "cmake --install build\n"
        "./umbral test\n"
        "```\n");
    ASSERT_EQ(found.size(), 7U);
    const auto expect = [&](std::size_t i, const char* text, int line, int block) {
        EXPECT_EQ(found[i].text, text);
        EXPECT_EQ(found[i].line, line);
        EXPECT_EQ(found[i].block, block);
    };
    expect(0, "umbral list --html FILE", 1, -1);
    expect(1, "umbral new work", 3, 0);
    expect(2, "cd work", 4, 0);
    expect(3, "umbral hint sphere", 6, 0);
    expect(4, "umbral hint sphere 2", 6, -1);
    expect(5, "A=1 B=$(mktemp -d) build/release/bin/bench-x --seconds 5", 8, -1);
    expect(6, "./umbral test", 11, 1);
}

TEST(Commands, of_other_programs_are_none)
{
    for (const char* const text :
         {"umbral", "umbrals list", "cmake --install build", "grader/cli/umbral list", "libumbral-gl", ".ci/run"})
        EXPECT_FALSE(calls_umbral(text)) << text;
}

}
}
