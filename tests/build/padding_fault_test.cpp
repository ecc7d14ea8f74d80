#include "build/padding_fault.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "support/temporary_folder.hpp"

// Where g++ fills padding, as its text of functions shows it.
namespace umbral::grader::test {
namespace {

bool fault_in(const std::string& before, const std::string& fills)
{
    std::istringstream text("void put ()\n{\n" + before + fills + "  sink (&t);\n}\n");
    return has_padding_fault(text);
}

const std::string loop =
    "  D.4 = &t + 8;\n  _1 = D.4 + 128;\n  goto <D.6>;\n  <D.5>:\n  D.4 = D.4 + 32;\n  <D.6>:\n"
    "  if (D.4 != _1) goto <D.5>; else goto <D.7>;\n  <D.7>:\n";

std::string fill(const std::string& base, int offset)
{
    return "  MEM <char[7]> [(struct Joint *)" + base + " + " + std::to_string(offset) + "B] = {};\n";
}

TEST(PaddingFault, is_a_fill_before_the_end_of_the_array_in_front_of_it)
{
    const std::string written = "  t.on = 1;\n";
    EXPECT_TRUE(fault_in(written, fill("&t", 4) + loop + fill("&t", 9)));
    EXPECT_FALSE(fault_in(written, fill("&t", 4) + loop + fill("&t", 137)));
    EXPECT_FALSE(fault_in(written, fill("&t", 4) + loop));
    EXPECT_FALSE(fault_in(written, fill("&t", 1) + fill("&t", 28)));
    EXPECT_FALSE(fault_in(written, loop + "  f (&u);\n" + fill("&t", 9)));
}

TEST(PaddingFault, is_none_in_a_variable_that_nothing_was_written_to)
{
    EXPECT_FALSE(fault_in("  t = .DEFERRED_INIT (144, 1, &\"t\"[0]);\n", fill("&t", 4) + loop + fill("&t", 9)));
}

/// Does g++ overwrite something in a value of a struct with these members? As its text says, and as a program sees it.
struct Seen {
    bool in_text;
    bool in_program;
};

Seen compile(const std::string& members, const std::string& values, const std::string& sums)
{
    const umbral::test::TemporaryFolder folder;
    folder.write("a.cpp",
                 "#include <array>\n#include <cstdlib>\nstruct V { double x, y, z, w; };\nstruct P { double x; char c; "
                 "};\nstruct T { " +
                     members + " };\nvolatile double one = 1;\nint main() { const auto sum = [](const T& t) { return " +
                     sums + "; };\n const double a = one; return sum(T{" + values + "}) == 100 ? 0 : 3; }\n");
    const LoweredText lowered(folder.path());
    const std::string command = "cd '" + folder.path().string() +
                                "' && " UMBRAL_COMPILER
                                " -std=c++20 -O1 -ftrivial-auto-var-init=pattern -fno-elide-constructors "
                                "-fno-lifetime-dse -fno-tree-sra a.cpp -o a " +
                                fmt::format("{}", fmt::join(lowered.options(), " ")) + " && ./a";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 3) << members;
    return {lowered.has_padding_fault(), WEXITSTATUS(status) == 3};
}

TEST(PaddingFault, is_found_where_a_program_of_this_compiler_has_it)
{
    const std::string v = "{a, a, a, a}";
    const struct {
        std::string members, values, sums;
    } all[] = {
        {"int k; V v[4]; bool on;", "1, {" + v + ", " + v + "}, true", "t.v[0].x * 50 + t.v[1].w * 49 + t.k"},
        {"V v[4]; bool on;", "{" + v + ", " + v + "}, true", "t.v[0].x * 50 + t.v[1].w * 50"},
        {"V v[4]; int k;", "{" + v + ", " + v + "}, 1", "t.v[0].x * 50 + t.v[1].w * 49 + t.k"},
        {"int k; V v[4];", "1, {" + v + ", " + v + "}", "t.v[0].x * 50 + t.v[1].w * 49 + t.k"},
        {"int k; V v[2]; bool on;", "1, {" + v + ", " + v + "}, true", "t.v[0].x * 50 + t.v[1].w * 49 + t.k"},
        {"int k; P p[6]; bool on;", "1, {{a, 1}, {a, 2}}, true", "t.p[0].x * 50 + t.p[1].x * 49 + t.k"},
        {"int k; double d[30]; bool on;", "1, {a, a, a}, true", "t.d[0] * 50 + t.d[1] * 49 + t.k"},
        {"int k; std::array<V, 8> v; bool on;", "1, {{" + v + ", " + v + "}}, true",
         "t.v[0].x * 50 + t.v[1].w * 49 + t.k"},
        {"int k; struct { V v[3][3]; } in; bool on;", "1, {{{" + v + "}}}, true", "t.in.v[0][0].x * 99 + t.k"},
        {"int k; bool on; V v[4];", "1, true, {" + v + "}", "t.v[0].x * 99 + t.k"},
    };
    for (const auto& [members, values, sums] : all) {
        const Seen seen = compile(members, values, sums);
        EXPECT_EQ(seen.in_text, seen.in_program) << members;
    }
}

}
}
