#include "build/source_scan.hpp"

#include <gtest/gtest.h>

#include "build/cpp_tokens.hpp"

namespace umbral::grader::test {
namespace {

constexpr const char* header = "/build/student.hpp.gch";

std::string found_in(const std::string& text) { return find_assembler(text, header).value_or(""); }

TEST(Assembler, is_found_in_every_spelling)
{
    for (const char* text : {"asm(\"nop\");", "void f() { asm volatile(\"mov %0, %1\" : : ); }",
                             "void f() { __asm__ __volatile__ (\".byte 1\"); }",
                             "void f() { __asm goto (\"\" ::::x); }", "asm(R\"x(.incbin \"a\")x\");", "asm(\".end\");",
                             "void f() { asm(\"ret\"); }", "int x asm(\"a\\n.globl b\");",
                             "int x asm(\"a\" \"\\n\" \"b\");", "int f() asm(\"a b\");", "asm", "asm(", "asm(\"x"})
        EXPECT_NE(found_in(text).find("assembler is not allowed"), std::string::npos) << text;
}

// A statement of one plain word is no label of what stands before it.
TEST(Assembler, is_no_label_where_nothing_is_declared)
{
    for (const char* text :
         {"void f() { if (x) asm(\"ret\"); }", "void f() { while (a(b)) asm(\"ret\"); }",
          "void f() { for (int i = 0; i < 1; ++i) asm(\"ret\"); }", "void f() { switch (x) asm(\"ret\"); }",
          "void f() { if constexpr (true) asm(\"ret\"); }", "void f() { g([] { asm(\"ret\"); }); }",
          "void f() { int x = ({ [[]] asm(\"ret\"); 1; }); }", "[[maybe_unused]] asm(\"ret\");",
          "alignas(8) asm(\"ret\");", "__attribute__((unused)) asm(\"ret\");", "__extension__ asm(\"ret\");",
          "extern \"C\" asm(\"ret\");", "int f() { return 1; } asm(\"ret\");", "void f() { label: asm(\"ret\"); }",
          "void f() { if (x) do asm(\"ret\"); while (0); }", "int f() asm(\"f@VERSION\");"})
        EXPECT_NE(found_in(text).find("assembler is not allowed"), std::string::npos) << text;
    for (const char* text :
         {"int f(int x) asm(\"f_1\");", "int a[2] asm(\"a_1\"), b asm(\"b_1\");", "std::size_t f() asm(\"f_1\");",
          "extern \"C\" { extern int f(int) __asm__(\"\" \"f_1\") __attribute__((pure)); }",
          "void f() { register long x asm(\"rax\"); }", "int x;\n# 90 \"a.hpp\"\nint f()\n# 92 \"a.hpp\"\nasm(\"g\");"})
        EXPECT_EQ(found_in(text), "") << text;
}

TEST(Assembler, plain_labels_and_the_compilers_own_are_allowed)
{
    EXPECT_EQ(found_in("extern int sigpause(int) __asm__ (\"\" \"__xpg_sigpause\");"), "");
    EXPECT_EQ(found_in("f() { __asm__ __volatile__ (\"pconfig\\n\\t\" : \"=a\" (x)); }"), "");
    EXPECT_EQ(
        found_in("f() { __asm__ volatile (\"ldtilecfg\\t%X0\" :: \"m\" (x)); __asm__ volatile (\"tilerelease\" ::); }"),
        "");
    EXPECT_NE(found_in("f() { __asm__ volatile (\"ldtilecfg\\t%X0\\n.incbin\" :: \"m\" (x)); }"), "");
    EXPECT_EQ(found_in("f() { __asm__ __volatile__ (\"pconfig\\n\\t.incbin\" : \"=a\" (x)); }").empty(), false);
}

// From there a program walks to the tables of all libraries, and finds what it may not call by name.
TEST(Assembler, the_linkers_own_tables_may_not_be_named)
{
    for (const char* text :
         {"extern \"C\" void* _GLOBAL_OFFSET_TABLE_[];", "extern char d[] asm(\"_DYNAMIC\");",
          "extern char d[] asm(\"_DYN\" \"AMIC\");", "static int d __attribute__((weakref(\"__ehdr_start\")));",
          "static int d __attribute__((weakref(\"__ehdr\"\n# 3 \"a.hpp\"\n\"_start\")));",
          "auto* p = &_PROCEDURE_LINKAGE_TABLE_;"})
        EXPECT_NE(found_in(text).find("the linker's "), std::string::npos) << text;
    EXPECT_EQ(found_in("const char* text = \"_DYNAMIC\"; int MY_DYNAMIC;"), "");
}

TEST(Assembler, is_no_word_in_texts_names_or_numbers)
{
    for (const char* text :
         {"const char* s = \"asm(\\\"x\\\")\";", "int my_asm = 1; int asm_ = 2;", "R\"(asm(\"x\"))\" ;",
          "int x = 1'000'000; char c = '\"'; int y;", "u8R\"a(asm)a\";", "auto x = 0xasm;"})
        EXPECT_EQ(found_in(text), "") << text;
}

// An unclosed string or character ends with its line, or what follows would be hidden.
TEST(Assembler, is_not_hidden_by_what_is_not_closed)
{
    for (const char* text : {"char c = ';\nasm(\"nop\");", "\"open\nasm(\"nop\");", "'\\\nasm(\"nop\");",
                             "\"\\\nasm(\"nop\");", "R\"aaaaaaaaaaaaaaaaaaaaa(\nasm(\"nop\");", "1'\nasm(\"nop\");",
                             "#pragma x\nasm(\"nop\");", "# 1 \"/usr/include/immintrin.h\" 1 3\nasm(\"nop\");"})
        EXPECT_NE(found_in(text), "") << text;
}

// A ' behind a digit separates only where a digit or a letter of ASCII follows: else it begins a character, which ends
// where the compiler says.
TEST(Assembler, is_not_hidden_by_what_looks_like_a_number)
{
    for (const char* text : {"[[x::y(1'$')]] int a; asm(\"anything\");", "[[x::y(1'\xc3\xa9')]] int a; asm(\"x\");",
                             "[[x::y(1'.')]] int a; asm(\"x\");", "[[x::y(1'\"')]] int a; asm(\"x\");"})
        EXPECT_NE(found_in(text), "") << text;
    for (const char* text : {"int x = 1'000'000;", "auto y = 0x1'ffU;", "char c = '\\U0001F600';", "int m = 'abcd';",
                             "char q = '\\'', d = '\"';", "const char* s = \"'\"; auto r = R\"(')\";"})
        EXPECT_FALSE(find_unclosed(text)) << text;
    for (const char* text :
         {"char c = ';\nint x;", "\"open\nint x;", "R\"(open", "1'\n", "char c = ' asm(\"nop\"); ';"})
        EXPECT_TRUE(find_unclosed(text)) << text;
    EXPECT_EQ(find_unclosed("# 3 \"a.cpp\"\nchar c = 'x;\n"),
              "a.cpp:3: error: a character or a string that is not closed in its line");
}

TEST(Assembler, may_not_come_in_by_attributes_and_directives)
{
    for (const char* text :
         {"__attribute__((section(\".text\"))) int x;", "__attribute__((__section__(\"x\"))) int x;",
          "[[gnu::section(\"x\")]] int x;", "[[using gnu: noinline, naked]] void f();",
          "__attribute__((no_sanitize_coverage)) void f();", "[[gnu::no_sanitize(\"x\")]] void f();",
          "__attribute__((alias(\"a\\nb\"))) int f();", "__attribute__((symver(\"a@b\"))) int f();", "#ident \"x\"",
          "<:<:gnu::section(\"x\"):>:> int x;", "[<:gnu::section(\"x\")]:> int x;",
          "[\n# 90 \"a.cpp\"\n[gnu::section(\"x\")]] int x;", "[\n#pragma x\n<:gnu::naked:>] void f();",
          "__attribute__\n#pragma x\n((section(\"x\"))) int x;", "__attribute__((alias(\"a@b\"))) int f();",
          "#sccs \"x\"", "# ident \"x\"", "#pragma GCC pch_preprocess \"other.gch\""})
        EXPECT_NE(found_in(text), "") << text;
}

// What was never set would be right by chance.
TEST(Assembler, nor_may_variables_be_left_unfilled)
{
    for (const char* const text :
         {"int x __attribute__((uninitialized));", "[[gnu::uninitialized]] int x;", "int x [[gnu::__uninitialized__]];",
          "#pragma GCC optimize (\"trivial-auto-var-init=uninitialized\")",
          "#pragma GCC optimize (\"trivial-auto\" \"-var-init=uninitialized\")",
          "#pragma GCC optimize (\"trivial\\x2d"
          "auto\")",
          "#pragma GCC optimize \"O2\", \"trivial-auto-var-init=zero\"", "#pragma GCC optimize (\"O2,tree-fre\")",
          "[[gnu::optimize(\"tree-\" \"sra\")]] void f();",
          "#pragma GCC optimize(\"trivial-auto-v\" R\"(ar-init=uninitialized)\")",
          "#pragma GCC optimize(u8\"trivial-auto-v\" u8R\"x(ar-init=uninitialized)x\")",
          "__attribute__((optimize(\"trivial-auto-var-init=uninitialized\"))) void f();",
          "[[gnu::optimize(\"trivial-auto\" \"-var-init=zero\")]] void f();"})
        EXPECT_TRUE(find_assembler(text, header)) << text;
    for (const char* const text :
         {"int uninitialized = 0;", "__attribute__((optimize(\"O3\", \"fast-math\"))) void f();",
          "#pragma GCC optimize (\"O3,unroll-loops\")", "#pragma GCC optimize 3"})
        EXPECT_FALSE(find_assembler(text, header)) << text;
}

// As macros make them of a file of two KiB.
TEST(Assembler, texts_of_a_million_strings_are_read_once)
{
    std::string text = "[[gnu::optimize(";
    for (int i = 0; i < 1'000'000; ++i) text += "\"a\" ";
    EXPECT_FALSE(find_assembler(text + ")]] void f();", header));
    EXPECT_TRUE(find_assembler(text + "\"auto-var\" \"-init\")]] void f();", header));
    text.clear();
    for (int i = 0; i < 200'000; ++i) text += "R\"a\" ";
    EXPECT_FALSE(find_assembler(text, header));
}

TEST(Assembler, ordinary_code_is_allowed)
{
    for (const char* text :
         {"int section = 1; int alias[2][3]; x[section[0]];", "__attribute__((always_inline)) int f();",
          "[[nodiscard]] int naked();", "std::vector<::naked> x; a<::b[1]; int c<:2:>; f<:<:0:>:>;",
          "__attribute__((weakref(\"plain_name\"))) int f();", "#pragma GCC optimize(\"O3\")", "#pragma once",
          "# 12 \"a.cpp\" 2", "#pragma GCC pch_preprocess \"/build/student.hpp.gch\"", "", "[[", "__attribute__",
          "__attribute__((", "\"", "R\"("})
        EXPECT_EQ(found_in(text), "") << text;
}

TEST(Assembler, its_place_is_told)
{
    EXPECT_EQ(found_in("# 1 \"sphere.cpp\"\nint x;\nasm(\"nop\");\n"), "sphere.cpp:2: assembler is not allowed");
    EXPECT_EQ(found_in("# 7 \"/tmp/a/b.hpp\" 1\n\n__attribute__((naked)) int x;\n"),
              "b.hpp:8: the attribute naked is not allowed");
}

TEST(CppTokens, end_for_any_bytes)
{
    std::string all;
    for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
    for (std::size_t from = 0; from < all.size(); ++from) {
        const std::string text = all.substr(from) + all.substr(0, from);
        CppTokens tokens(text);
        std::size_t count = 0;
        while (tokens.next().kind != CppToken::Kind::end) ASSERT_LE(++count, text.size());
    }
}

}
}
