#include "mutants/schemata.hpp"

#include <gtest/gtest.h>

#include "mutants/equivalents.hpp"
#include "mutants/mutants_table.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader::test {
namespace {

Mutant expression(unsigned number, std::size_t begin, std::size_t end, const std::string& replacement)
{
    return {number, Mutant::Form::expression, begin, end, 1, replacement, "comparison", "a → b"};
}

/// Without the beginning that declares the switch, and without lines that only name lines.
std::string body(const std::string& text)
{
    std::string kept;
    std::istringstream stream(text.substr(text.find("#line 1\n")));
    for (std::string line; std::getline(stream, line);)
        if (!line.starts_with("#line")) kept += line;
    return kept;
}

TEST(Schemata, an_expression_is_chosen_by_its_number)
{
    EXPECT_EQ(body(with_mutants("x = a + b;", std::vector{expression(1, 4, 9, "a - b")})),
              "x = (umbral_mutant(1) ? umbral_as<decltype((a + b))>(a - b) :(a + b));");
}

TEST(Schemata, mutants_within_others_are_written_within_their_originals)
{
    const std::vector mutants{expression(1, 0, 5, "a - b"), expression(2, 0, 5, "a"), expression(3, 4, 5, "c")};
    EXPECT_EQ(body(with_mutants("a + b", mutants)),
              "(umbral_mutant(1) ? umbral_as<decltype((a + b))>(a - b) :((umbral_mutant(2) ? umbral_as<decltype((a + "
              "b))>(a) :(a + (umbral_mutant(3) ? umbral_as<decltype((b))>(c) :(b))))))");
}

TEST(Schemata, a_condition_may_be_of_any_type)
{
    Mutant mutant = expression(1, 4, 5, "false");
    mutant.kind = "condition";
    EXPECT_EQ(body(with_mutants("if (p) f();", std::vector{mutant})),
              "if ((umbral_mutant(1) ? (false) :static_cast<bool>(p))) f();");
}

TEST(Schemata, a_mutant_of_several_lines_stands_on_one)
{
    const std::string source = "f(a,  // one\n\"//\", b)";
    const std::string text = with_mutants(source, std::vector{expression(3, 0, source.size(), "g(a,  // one\n b)")});
    EXPECT_NE(text.find("umbral_as<decltype((f(a,   \"//\", b)))>(g(a,    b)) :"), std::string::npos) << text;
}

TEST(Schemata, statements_are_left_out_and_come_in)
{
    Mutant out = expression(2, 1, 6, "");
    out.form = Mutant::Form::statement;
    Mutant in = expression(1, 1, 1, "return;");
    in.form = Mutant::Form::inserted;
    EXPECT_EQ(body(with_mutants("{f(x);}", std::vector{in, out})),
              "{if (umbral_mutant(1)) return;{if (!umbral_mutant(2)) f(x); }}");
}

TEST(Schemata, statements_change_places)
{
    Mutant order = expression(1, 1, 11, "g(); f();");
    order.form = Mutant::Form::instead;
    EXPECT_EQ(body(with_mutants("{f(); g(); }", std::vector{order})),
              "{{if (umbral_mutant(1)) { g(); f(); } else {f(); g();  } }}");
}

TEST(Schemata, lines_of_diagnostics_tell_the_mutant)
{
    const std::string text = with_mutants("int x;\nint y = a < b;\n", std::vector{expression(7, 15, 20, "a <= b")});
    EXPECT_NE(text.find("#line 1000007\numbral_mutant(7) ? umbral_as<decltype((a < b))>(a <= b) :\n#line 2\n(a < b)"),
              std::string::npos)
        << text;
}

TEST(Schemata, one_change_leaves_the_lines_behind_it_where_they_are)
{
    const std::string source = "a = b +\n    c;\nd = e;\n";
    EXPECT_EQ(with_change(source, expression(1, 4, 13, "b - c")), "a = (b - c)\n;\nd = e;\n");
    Mutant mutant = expression(1, 15, 21, "");
    mutant.form = Mutant::Form::statement;
    EXPECT_EQ(with_change(source, mutant), "a = b +\n    c;\n;\n");
    mutant = expression(1, 15, 15, "return;");
    mutant.form = Mutant::Form::inserted;
    EXPECT_EQ(with_change(source, mutant), "a = b +\n    c;\nreturn;d = e;\n");
}

TEST(Equivalents, are_about_a_line_and_a_change)
{
    const umbral::test::TemporaryFolder folder;
    EXPECT_TRUE(equivalents_of(folder.path(), MutantFamily::syntax).empty());
    const auto write = [&](const std::string& text) { std::ofstream(folder.path() / "mutants.json") << text; };
    write(R"([{"line": "x = a;", "change": "a → b", "reason": "the same"}])");
    const std::vector<Equivalent> entries = equivalents_of(folder.path(), MutantFamily::syntax);
    ASSERT_EQ(entries.size(), 1U);
    Mutant mutant = expression(1, 0, 1, "b");
    mutant.line = 2;
    EXPECT_TRUE(is_about(entries[0], mutant, "y;\n    x = a;  \n"));
    EXPECT_FALSE(is_about(entries[0], mutant, "x = a;\n    y = a;\n"));
    mutant.change = "a → c";
    EXPECT_FALSE(is_about(entries[0], mutant, "y;\n    x = a;\n"));
    for (const char* wrong : {"{}", "[1]", R"([{"line": "x", "change": "y"}])", "no json",
                              R"([{"line": "x", "change": "y", "reason": ""}])"}) {
        write(wrong);
        EXPECT_THROW((void)equivalents_of(folder.path(), MutantFamily::syntax), std::runtime_error) << wrong;
    }
}

TEST(MutantsTable, says_what_survives_and_what_is_out_of_date)
{
    UnitMutants unit{"a/b", "a/b.cpp", {}, 0};
    unit.mutants = {{expression(1, 0, 1, "b"), {true, "x/y"}},
                    {expression(2, 0, 1, "b"), {}},
                    {expression(3, 0, 1, "b"), {}, "the same"}};
    EXPECT_FALSE(unit.holds());
    EXPECT_NE(mutants_text(unit).find("3 mutants,    1 killed,   1 equivalent,   1 survive"), std::string::npos);
    EXPECT_NE(mutants_markdown(MutantFamily::syntax, std::vector{unit}).find("| a/b | 3 | 1 | 1 | 1 |"),
              std::string::npos);
    EXPECT_EQ(mutants_json(std::vector{unit}).at("units").at(0).at("mutants").size(), 3U);
    unit.mutants.erase(unit.mutants.begin() + 1);
    EXPECT_TRUE(unit.holds());
    unit.stale.push_back({"x", "y", "z"});
    EXPECT_FALSE(unit.holds());
}

}
}
