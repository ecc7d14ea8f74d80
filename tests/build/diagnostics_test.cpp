#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

/// Sources that a compiler chokes on, or that want to read what they must not.
struct Bomb {
    const char* name;
    std::string text;
    bool builds = false;  ///< may also end well
};

class Bombs : public testing::TestWithParam<Bomb> {};

TEST_P(Bombs, end_within_limits)
{
    const Workbench bench;
    const Built built = bench.build_sphere(GetParam().text);
    if (!GetParam().builds) {
        EXPECT_EQ(to_string(built.verdict), "compile_error");
    }
    EXPECT_NE(to_string(built.verdict), "grader_fault");
    if (built.verdict != Verdict::ok) {
        EXPECT_FALSE(built.message.empty());
    }
    EXPECT_LE(built.message.size(), 8300U);
    // The next student's build works.
    EXPECT_EQ(to_string(bench.build_sphere(sphere_with("", "")).verdict), "ok");
}

const std::vector<Bomb> bombs = {
    {"dev_zero", "#include \"/dev/zero\"\n"},
    {"dev_random", "#include \"/dev/urandom\"\n"},
    {"itself", "#include \"sphere.cpp\"\n"},
    {"deep_templates",
     "template <int n> struct Deep { static constexpr int value = Deep<n + 1>::value; };\nint x = Deep<0>::value;\n"},
    {"wide_templates",
     "template <int n> struct W { W<n - 1> a; W<n - 2> b; static constexpr int v = W<n - 1>::v + W<n - 2>::v; "
     "};\ntemplate <class A, class B> struct P {};\n"
     "template <int n, class T> struct G { using type = typename G<n - 1, P<T, P<T, T>>>::type; };\ntemplate <class T> "
     "struct G<0, T> { using type = T; };\n"
     "G<60, int>::type x = 7;\n"},
    {"constexpr_loop", "constexpr int loop() { int n = 0; for (;;) ++n; return n; }\nconstexpr int x = loop();\n"},
    {"large_array", sphere_with("char hundred[100 << 20] = {1};\n", "    hundred[5] = 1;"), true},
    {"macro_laughter",
     "#define A(x) x x x x x x x x x x\n#define B(x) A(A(A(x)))\n#define C(x) B(B(B(x)))\nint y[] = {C(1,)};\n"},
    {"deep_brackets", "int x = " + std::string(200000, '(') + "1" + std::string(200000, ')') + ";\n"},
    {"large_tables", "static int a[60 << 20] = {1};\nint b[60 << 20] = {2};\nint* c = a;\n"},
    {"empty", ""},
};
INSTANTIATE_TEST_SUITE_P(All, Bombs, testing::ValuesIn([] {
                             std::vector<Bomb> all = bombs;
                             std::erase_if(all, [](const Bomb& bomb) { return std::string(bomb.name) == "empty"; });
                             return all;
                         }()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Diagnostics, name_the_students_file_and_line_and_nothing_of_ours)
{
    const Workbench bench;
    std::string text = "namespace umbral::raytracing {\n";
    for (int i = 0; i < 100; ++i)
        text += "int f" + std::to_string(i) + "() { return unknown_" + std::to_string(i) + "; }\n";
    const Built built = bench.build_sphere(text + "}\n");
    ASSERT_EQ(to_string(built.verdict), "compile_error");
    EXPECT_TRUE(built.message.starts_with("sphere.cpp:")) << built.message;
    EXPECT_NE(built.message.find("sphere.cpp:2:"), std::string::npos) << built.message;
    EXPECT_LE(std::count(built.message.begin(), built.message.end(), '\n'), 25);
}

TEST(Diagnostics, hold_no_path_of_this_machine)
{
    const Workbench bench;
    for (const std::string text :
         {"namespace umbral { struct Ray {}; }\n", "int x = glm::vec3(1);\n",
          "#include <umbral/record/wire.hpp>\nint x = umbral::wire::padded();\n", "#include \"nothing.hpp\"\n",
          "int twice() { return 1; }\nint twice() { return 2; }\n",
          "namespace umbral::raytracing { int intersect(const Ray&, const Sphere&); }\n"}) {
        const Built built = bench.build_sphere(text);
        ASSERT_EQ(to_string(built.verdict), "compile_error") << text;
        EXPECT_EQ(built.message.find(bench.folder()), std::string::npos) << built.message;
        EXPECT_EQ(built.message.find(bench.tools().framework), std::string::npos) << built.message;
        EXPECT_EQ(built.message.find(bench.tools().units.parent_path()), std::string::npos) << built.message;
    }
}

TEST(Diagnostics, of_two_files_that_define_the_same)
{
    const Workbench bench;
    const Built built = build(bench.tools(), bench.exercise("raytracing/sphere"),
                              {{"sphere.cpp", sphere_with("int needed();\nint same() { return needed(); }\n", "")},
                               {"other.cpp", "int same() { return 2; }\nint needed() { return 3; }\n"}});
    ASSERT_EQ(to_string(built.verdict), "compile_error");
    EXPECT_NE(built.message.find("same"), std::string::npos) << built.message;
    EXPECT_EQ(built.message.find(bench.folder()), std::string::npos) << built.message;
}

// Who keeps an older version in the same folder means the unit's own file.
TEST(Diagnostics, a_copy_beside_the_unit_is_left_out_and_named)
{
    const Workbench bench;
    const std::string helper = "int helper() { return 1; }\n";
    const std::string text = sphere_with("int helper();\nint used() { return helper(); }\n", "");
    const Built built = build(bench.tools(), bench.exercise("raytracing/sphere"),
                              {{"sphere.cpp", text}, {"sphere_old.cpp", text}, {"helper.cpp", helper}});
    EXPECT_EQ(to_string(built.verdict), "ok") << built.message;
    EXPECT_EQ(built.message.find("sphere_old.cpp was left out: it defines what another"), 0U) << built.message;
}

// The linker's messages name objects whose names are new each time.
TEST(Diagnostics, of_equal_work_are_equal)
{
    const std::string text = sphere_with("extern \"C\" void _init() {}\n", "");
    const Built once = Workbench().build_sphere(text);
    const Built again = Workbench().build_sphere(text);
    EXPECT_EQ(once.verdict, Verdict::compile_error);
    EXPECT_NE(once.message.find("object file"), std::string::npos) << once.message;
    EXPECT_EQ(once.message, again.message);
}

TEST(Secrets, cannot_be_included)
{
    const Workbench bench;
    const std::filesystem::path secret =
        bench.write("cache/builds/aa/other/sphere.cpp", "int secret_of_another = nonsense_of_another;\n");
    for (const std::filesystem::path& path :
         {std::filesystem::path("/etc/passwd"), std::filesystem::path("/proc/self/environ"), secret,
          bench.tools().reference / "raytracing/sphere.cpp",
          bench.tools().exercises / "raytracing/sphere/driver.cpp"}) {
        const Built built = bench.build_sphere("#include \"" + path.string() + "\"\n");
        EXPECT_EQ(to_string(built.verdict), "compile_error") << path;
        // What is there and what is not cannot be told apart.
        EXPECT_NE(built.message.find("No such file"), std::string::npos) << built.message;
        EXPECT_EQ(built.message.find("root:"), std::string::npos) << built.message;
        EXPECT_EQ(built.message.find("nonsense_of_another"), std::string::npos) << built.message;
    }
}

// The assembler could put any file into a library.
TEST(Secrets, cannot_be_assembled_in)
{
    const Workbench bench;
    const Built built =
        bench.build_sphere(sphere_with("asm(\".data\\nstolen: .incbin \\\"/etc/passwd\\\"\\n.text\");\n", ""));
    EXPECT_EQ(to_string(built.verdict), "forbidden") << built.message;
    EXPECT_EQ(built.message, "sphere.cpp:1: assembler is not allowed");
}

// Which files there are on this machine is nobody's business either: the reference, wherever it is installed, and
// neighbours' work.
TEST(Secrets, cannot_be_asked_for)
{
    const Workbench bench;
    const std::filesystem::path unit = unit_folder(bench.tools(), "raytracing/sphere");
    std::vector<std::filesystem::path> paths{"/etc/passwd",
                                             "/proc/self/fd/1",
                                             "/proc/self/environ",
                                             "/usr/lib/os-release",
                                             unit / "reference.so",
                                             bench.tools().reference / "raytracing/sphere.cpp",
                                             bench.write("cache/neighbour.cpp", "int x;\n")};
    const umbral::test::TemporaryFolder outside;
    outside.write("here.hpp", "int x;\n");
    paths.push_back(outside / "here.hpp");
    for (const std::filesystem::path& path : paths) {
        const std::string question = "#if __has_include(\"" + path.string() + "\")\n#error it is there\n#endif\n";
        const Built built = bench.build_sphere(question + sphere_with("", ""));
        EXPECT_EQ(to_string(built.verdict), "ok") << path << ": " << built.message;
    }
    // But the question works where it may be asked.
    EXPECT_EQ(
        to_string(bench.build_sphere("#if __has_include(<vector>)\n#error it is there\n#endif\n" + sphere_with("", ""))
                      .verdict),
        "compile_error");
}

// What a unit teaches is not to be had from whatever is installed here and not elsewhere. The tests need GoogleTest.
TEST(Headers, of_other_libraries_are_not_there)
{
    ASSERT_TRUE(std::filesystem::exists("/usr/include/gtest/gtest.h"));
    const Workbench bench;
    for (const char* header : {"gtest/gtest.h", "nlohmann/json.hpp"}) {
        const std::string included = std::string("#include <") + header + ">\n";
        const Built built = bench.build_sphere(included + sphere_with("", ""));
        EXPECT_EQ(to_string(built.verdict), "compile_error") << header;
        EXPECT_NE(built.message.find("No such file"), std::string::npos) << built.message;
    }
    // All of the standard library is, and what the course is about.
    const Built built = bench.build_sphere(
        "#include <bits/stdc++.h>\n#include <execution>\n#include <GLFW/glfw3.h>\n"
        "#include <glm/gtx/intersect.hpp>\n#include <errno.h>\n" +
        sphere_with("", ""));
    EXPECT_EQ(to_string(built.verdict), "ok") << built.message;
}

TEST(Secrets, a_reference_installed_below_usr_is_out_of_reach)
{
    const std::filesystem::path folder = "/usr/lib/umbral-test-of-secrets";
    std::error_code failed;
    std::filesystem::create_directory(folder, failed);
    if (failed) GTEST_SKIP() << "may not write below /usr";
    std::ofstream(folder / "reference.cpp") << "int the_reference = nonsense_of_the_reference;\n";
    const Workbench bench;
    const Built included =
        bench.build_sphere("#include \"" + (folder / "reference.cpp").string() + "\"\n" + sphere_with("", ""));
    const Built asked = bench.build_sphere("#if __has_include(\"" + (folder / "reference.cpp").string() +
                                           "\")\n#error there\n#endif\n" + sphere_with("", ""));
    std::filesystem::remove_all(folder);
    EXPECT_EQ(to_string(included.verdict), "compile_error");
    EXPECT_EQ(included.message.find("nonsense"), std::string::npos) << included.message;
    EXPECT_EQ(to_string(asked.verdict), "ok") << asked.message;
}

// Too much text is a compile error like any other that a compiler has with it.
TEST(Diagnostics, of_more_text_than_is_read)
{
    const Workbench bench;
    std::string text = "#define A(x) x x x x x x x x x x\n#define B(x) A(A(A(A(x))))\n";
    for (int i = 0; i < 300; ++i) text += "B(int x; struct y { float z; };)\n";
    const Built built = bench.build_sphere(text);
    EXPECT_EQ(to_string(built.verdict), "compile_error") << built.message;
    EXPECT_NE(built.message.find("more text"), std::string::npos) << built.message;
}

// A file whose name looks like an option is a file.
TEST(Options, are_never_taken_from_file_names)
{
    const Workbench bench;
    const Built built = build(bench.tools(), bench.exercise("raytracing/sphere"),
                              {{"sphere.cpp", sphere_with("int helper();\n", "(void)helper();")},
                               {"-oX.cpp", "int helper() { return 1; }\n"}});
    EXPECT_EQ(to_string(built.verdict), "ok") << built.message;
}

}
}
