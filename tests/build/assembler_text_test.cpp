#include "build/assembler_text.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "support/temporary_folder.hpp"

namespace umbral::grader::test {
namespace {

std::string foreign_in(const std::string& text) { return find_foreign_assembler(text).value_or("nothing"); }

TEST(AssemblerText, of_instructions_labels_and_data_is_the_compilers)
{
    for (const char* text :
         {"", "\n", "\t.text\n_Z1fv:\n.LFB0:\n\t.cfi_startproc\n\trep movsq\n\tmovl\t%fs:_ZTIi@tpoff, %eax\n",
          "\t.string\t\"a;b /* c \\\" .incbin # d\"\n", "\tret # a; b\n", "# 12 \"a.cpp\"\n", "#NO_APP\n",
          "\t.section\t.text._Z1fv,\"axG\",@progbits,_Z1fv,comdat\n", "\t.section\t.debug_str,\"MS\",@progbits,1\n",
          "_Z6größei:\n", "\t{vex} vpdpbusd\t%xmm1, %xmm0, %xmm0\n", "\t{evex} vpaddd %xmm1, %xmm0, %xmm0\n",
          "\t.section\t.note.gnu.property,\"a\"\n", "\t.section\t.note.GNU-stack,\"\",@progbits\n",
          "\t.section\t.rodata.str1.1,\"aMS\",@progbits,1\n"})
        EXPECT_EQ(foreign_in(text), "nothing") << text;
}

TEST(AssemblerText, that_was_written_by_hand_is_told)
{
    EXPECT_EQ(foreign_in("\tret\n#APP\n\tsyscall\n#NO_APP\n"), "syscall");
    EXPECT_EQ(foreign_in("#APP\n"), "");
    EXPECT_EQ(foreign_in("\t.incbin \"/etc/passwd\"\n"), ".incbin \"/etc/passwd\"");
    EXPECT_EQ(foreign_in(".include \"a\""), ".include \"a\"");
    for (const char* text : {"\tret; .incbin \"a\"\n",
                             "\tret /* .incbin */\n",
                             "f: .incbin \"a\"\n",
                             "\tf:\t.incbin \"a\"\n",
                             "\t.string \"a\n\t.ascii b\"\n",
                             "\t.section .debug_info,\"aw\"\n",
                             "\t.section .eh_frame,\"a\",@progbits\n",
                             "\t.section .textual,\"ax\"\n",
                             "\t.macro ret\n",
                             "\t.symver a,b@c\n",
                             "\t.print \"a\"\n",
                             "\t.end\n",
                             "\"f\":\n",
                             "\t.rept 100000000\n",
                             "\t.org 1000000\n",
                             "\t.fill 1000000\n",
                             "\t.reloc 1\n",
                             "\t.pushsection .init,\"ax\"\n",
                             "{vex} .incbin \"a\"\n",
                             "gr\xC3\xB6\xC3\x9F"
                             "e .incbin \"a\"\n",
                             "\t{disp8} ret\n"})
        EXPECT_NE(foreign_in(text), "nothing") << text;
}

/// The compiler's own text of a file with these lines, in other settings, too.
class CompiledText : public testing::Test {
protected:
    [[nodiscard]] std::string of(const std::string& lines, const std::string& options) const
    {
        folder_.write("a.cpp", lines);
        const std::string command =
            "cd '" + folder_.path().string() + "' && " UMBRAL_COMPILER " -std=c++20 " + options + " -S a.cpp -o a.s";
        EXPECT_EQ(std::system(command.c_str()), 0);
        std::ostringstream text;
        text << std::ifstream(folder_.path() / "a.s").rdbuf();
        EXPECT_FALSE(text.str().empty());
        return foreign_in(text.str());
    }

    umbral::test::TemporaryFolder folder_;
};

TEST_F(CompiledText, of_cpp_is_the_compilers)
{
    const char* const lines =
        "#include <algorithm>\n#include <atomic>\n#include <cmath>\n#include <functional>\n#include <immintrin.h>\n"
        "#include <iostream>\n#include <map>\n#include <numeric>\n#include <random>\n"
        "#include <stdexcept>\n#include <string>\n#include <variant>\n#include <vector>\n"
        "thread_local std::string kept = \"a;b\\n#APP\\n\\t.incbin \\\"x\\\" /* c */ \\x01\\xff\";\n"
        "static std::map<std::string, std::function<double(double)>> table{{\"sin\", [](double x) { return "
        "std::sin(x); }}};\n"
        "struct Base { virtual ~Base() = default; virtual int f() { return 1; } };\n"
        "struct Derived : Base { int f() override { throw std::runtime_error(kept); } };\n"
        "std::atomic<long> counter;\nconst long double e = 2.5L;\n__int128 wide = 1;\nalignas(64) float many[100] = "
        "{1};\n"
        "__attribute__((weak, visibility(\"hidden\"))) int weak() { return 2; }\n"
        "extern \"C\" int renamed() __asm__(\"plain_name\");\n"
        "__m128 twice(__m128 v) { return _mm_add_ps(v, v); }\n"
        "namespace größe { template <class T> struct Maß { virtual T länge() const { return T(3); } }; "
        "static int \\u00f1(int año) { static int caché = año; return ++caché; } }\n"
        "double volumen(int año) { return größe::Maß<double>().länge() + größe::\\u00f1(año); }\n"
        "template struct größe::Maß<float>;\n"
        "int g(Base& b, std::variant<int, std::string> v, int k)\n{\n    static std::vector<int> all(100);\n"
        "    std::mt19937 engine(1);\n    std::iota(all.begin(), all.end(), renamed() + weak());\n"
        "    std::sort(all.begin(), all.end(), std::greater<>());\n    counter += k;\n"
        "    try { return b.f() + std::get<int>(v) + all[k] + int(engine()) + int(table[\"sin\"](k) * e); }\n"
        "    catch (const std::exception& error) { std::cerr << error.what(); }\n"
        "    switch (k) { case 0: return 5; case 1: return 8; case 2: return 13; case 3: return 2; case 4: return 77; "
        "}\n"
        "    return new Derived != &b;\n}\n";
    for (const char* options :
         {UMBRAL_TEST_STUDENT_FLAGS, "-O0 -g", "-O3 -g2 -fPIC -ffunction-sections -fdata-sections",
          UMBRAL_TEST_STUDENT_FLAGS " -fsanitize-coverage=trace-pc"})
        EXPECT_EQ(of(lines, options), "nothing") << options;
}

TEST_F(CompiledText, of_what_was_slipped_in_is_not)
{
    EXPECT_EQ(of("void f() { asm(\"nop\"); }", "-O1"), "a.cpp:1: nop");
    EXPECT_EQ(of("\nasm(\".globl x\");", "-O1"), ".globl x");
    EXPECT_EQ(of("int x __attribute__((section(\".data\\n\\t.incbin \\\"/etc/passwd\\\"#\"))) = 1;", "-O1"),
              ".incbin \"/etc/passwd\"#,\"aw\"");
    EXPECT_EQ(of("extern int x __asm__(\"y\\n\\t.print \\\"z\\\"\\n\"); int f() { return x; }", "-O1 -fPIC"),
              ".print \"z\"");
    EXPECT_NE(of("int x __attribute__((section(\".debug_info\"))) = 1;", "-O1"), "nothing");
    EXPECT_NE(of("int x __attribute__((section(\".init\"))) = 1;", "-O1"), "nothing");
}

TEST(OwnAssembler, refuses_what_it_would_not_have_been_given_for_cpp)
{
    const umbral::test::TemporaryFolder folder;
    folder.write("good.cpp", "int f(int x) { return x + 1; }\n");
    folder.write("bad.cpp", "int f(int x) { asm(\".incbin \\\"good.cpp\\\"\"); return x + 1; }\n");
    const auto compile = [&](const std::string& name) {
        const std::string command = "cd '" + folder.path().string() +
                                    "' && " UMBRAL_COMPILER " -B" UMBRAL_ASSEMBLER_FOLDER " " UMBRAL_TEST_STUDENT_FLAGS
                                    " -c " +
                                    name + ".cpp 2>" + name + ".txt";
        return std::system(command.c_str()) == 0;
    };
    EXPECT_TRUE(compile("good"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "good.o"));
    EXPECT_FALSE(compile("bad"));
    std::ostringstream said;
    said << std::ifstream(folder.path() / "bad.txt").rdbuf();
    EXPECT_EQ(said.str().find(std::string(assembler_refused) + "bad.cpp:1: .incbin"), 0U) << said.str();
}

}
}
