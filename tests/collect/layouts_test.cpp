#include <gtest/gtest.h>

#include "collect/desk.hpp"
#include "support/archive_writer.hpp"

namespace umbral::grader::test {
namespace {

using umbral::test::write_archive;

const std::string solution = "#include <optional>\n// a solution: ñ, €\nint answer() { return 42; }\n";

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

/// An independent way to UTF-16: every character of `solution` beyond ASCII is given by hand.
std::string utf16(const std::string& text, bool big, bool mark)
{
    std::u16string wide = mark ? u"\uFEFF" : u"";
    const std::string narrow = replaced(replaced(text, "ñ", "\x01"), "€", "\x02");
    for (const char c : narrow) wide += c == '\x01' ? u'ñ' : c == '\x02' ? u'€' : static_cast<char16_t>(c);
    std::string bytes;
    for (const char16_t unit : wide) {
        const auto low = static_cast<char>(unit & 0xFFU);
        const auto high = static_cast<char>(unit >> 8U);
        bytes += big ? high : low;
        bytes += big ? low : high;
    }
    return bytes;
}

struct Layout {
    std::string name;
    Sources files;
    std::string expected = solution;
    std::string taken_from{};  ///< what a note names; empty: no note
};

std::string stub_text()
{
    return read_text(std::filesystem::path(UMBRAL_SOURCE_DIR) / "exercises/raytracing/sphere/sphere.cpp");
}

std::vector<Layout> layouts()
{
    const std::string exact = "raytracing/sphere/sphere.cpp";
    const std::string zip = write_archive("zip", "none", {{"sphere.cpp", solution}});
    return {
        {"workspace", {{exact, solution}, {"raytracing/sphere/README.md", "# Sphere"}}},
        {"flat", {{"sphere.cpp", solution}, {"memoria.pdf", "%PDF"}}},
        {"capital", {{"Sphere.cpp", solution}}, solution, "Sphere.cpp"},
        {"all_capitals", {{"SPHERE.CPP", solution}}, solution, "SPHERE.CPP"},
        {"second_download", {{"sphere (1).cpp", solution}}, solution, "sphere (1).cpp"},
        {"windows_copy", {{"sphere - Copy (2).cpp", solution}}, solution, "sphere - Copy (2).cpp"},
        {"spanish_windows_copy", {{"sphere - copia.cpp", solution}}, solution, "sphere - copia.cpp"},
        {"spanish_mac_copy", {{"Copia de sphere.cpp", solution}}, solution, "Copia de sphere.cpp"},
        {"suffix_cc", {{"sphere.cc", solution}}, solution, "sphere.cc"},
        {"suffix_cxx", {{"Sphere.cxx", solution}}, solution, "Sphere.cxx"},
        {"suffix_capital_c", {{"sphere.C", solution}}, solution, "sphere.C"},
        {"suffix_of_mail", {{"sphere.cpp.txt", solution}}, solution, "sphere.cpp.txt"},
        {"capital_folders", {{"Raytracing/Sphere/sphere.cpp", solution}}, solution, "Raytracing/Sphere/sphere.cpp"},
        {"workspace_below", {{"work/" + exact, solution}}, solution, "work/" + exact},
        {"own_folder", {{"sphere/sphere.cpp", solution}}, solution, "sphere/sphere.cpp"},
        {"xcode",
         {{"P3/P3.xcodeproj/project.pbxproj", "// !$*UTF8*$!"},
          {"P3/P3/sphere.cpp", solution},
          {"P3/P3/main.cpp", "int main() {}"}},
         solution,
         "P3/P3/sphere.cpp"},
        {"visual_studio",
         {{"Lab/Lab.sln", "Microsoft"},
          {"Lab/.vs/Lab/sphere.cpp", "cached"},
          {"Lab/Lab/Sphere.cpp", solution},
          {"Lab/x64/Debug/Sphere.obj", "x"}},
         solution,
         "Lab/Lab/Sphere.cpp"},
        {"cmake_build",
         {{"src/sphere.cpp", solution}, {"build/CMakeFiles/sphere.cpp", "int x;"}},
         solution,
         "src/sphere.cpp"},
        {"git_and_mac",
         {{"sphere.cpp", solution}, {".git/sphere.cpp", "old"}, {"__MACOSX/._sphere.cpp", "x"}, {".DS_Store", "x"}}},
        {"zip", {{"entrega.zip", zip}}, solution, "entrega.zip/sphere.cpp"},
        {"zip_of_a_workspace",
         {{"w.ZIP", write_archive("zip", "none", {{exact, solution}})}},
         solution,
         "w.ZIP/" + exact},
        {"tar_gz",
         {{"w.tar.gz", write_archive("ustar", "gzip", {{"./w/sphere.cpp", solution}})}},
         solution,
         "w.tar.gz/w/sphere.cpp"},
        {"tar_xz",
         {{"w.tar.xz", write_archive("pax", "xz", {{"sphere.cpp", solution}})}},
         solution,
         "w.tar.xz/sphere.cpp"},
        {"seven_zip",
         {{"w.7z", write_archive("7zip", "none", {{"sphere.cpp", solution}})}},
         solution,
         "w.7z/sphere.cpp"},
        {"zip_in_zip", {{"a.zip", write_archive("zip", "none", {{"b.zip", zip}})}}, solution, "a.zip/b.zip/sphere.cpp"},
        {"accents_around", {{"Práctica 3 – José/sphere.cpp", solution}}, solution, "Práctica 3 – José/sphere.cpp"},
        {"utf16_little", {{"sphere.cpp", utf16(solution, false, true)}}},
        {"utf16_big", {{"sphere.cpp", utf16(solution, true, true)}}},
        {"utf16_little_without_mark", {{"sphere.cpp", utf16(solution, false, false)}}},
        {"utf16_big_without_mark", {{"sphere.cpp", utf16(solution, true, false)}}},
        {"utf8_with_mark", {{"sphere.cpp", "\xEF\xBB\xBF" + solution}}},
        {"line_ends_of_windows", {{"sphere.cpp", replaced(solution, "\n", "\r\n")}}, replaced(solution, "\n", "\r\n")},
        {"stub_in_the_workspace", {{exact, stub_text()}, {"sphere.cpp", solution}}},
        {"stub_and_solution_below", {{exact, stub_text()}, {"mine/Sphere.cpp", solution}}, solution, "mine/Sphere.cpp"},
        {"stub_in_every_place",
         {{exact, stub_text()}, {"sphere.cpp", stub_text() + "\n// mine\n"}, {"a/sphere.cpp", solution}},
         solution,
         "a/sphere.cpp"},
        {"framework_beside_it",
         {{exact, solution},
          {"compile_flags.txt", "-Iinclude"},
          {"include/umbral/raytracing/sphere.cpp", "int x;"},
          {"include/umbral/sphere.cpp", "int y;"}}},
        {"framework_beside_it_elsewhere",
         {{"w/mine.d/sphere.cpp", solution}, {"w/include/umbral/sphere.cpp", "int y;"}},
         solution,
         "w/mine.d/sphere.cpp"},
        {"framework_in_a_zip",
         {{"w.zip", write_archive("zip", "none",
                                  {{"w/" + exact, solution}, {"w/include/umbral/raytracing/sphere.cpp", "int x;"}})}},
         solution,
         "w.zip/w/" + exact},
        {"equal_copies", {{"a/sphere.cpp", solution}, {"b/Sphere.cpp", solution}}, solution, "a/sphere.cpp"},
        {"folder_and_its_zip",
         {{"sphere/sphere.cpp", solution}, {"sphere.zip", zip}},
         solution,
         "sphere.zip/sphere.cpp"},
    };
}

class Layouts : public testing::TestWithParam<Layout> {};

TEST_P(Layouts, is_found)
{
    const Layout& layout = GetParam();
    const Desk desk;
    for (const auto& [path, text] : layout.files) desk.write(path, text);
    const Handed handed = desk.collected();
    EXPECT_EQ(handed.files, (Sources{{"sphere.cpp", layout.expected}}));
    EXPECT_EQ(handed.missing, std::vector<std::string>{});
    EXPECT_EQ(handed.refused, "");
    if (layout.taken_from.empty())
        EXPECT_EQ(handed.notes, std::vector<std::string>{});
    else
        EXPECT_EQ(handed.notes, std::vector<std::string>{"sphere.cpp: taken from " + layout.taken_from});
}

INSTANTIATE_TEST_SUITE_P(All, Layouts, testing::ValuesIn(layouts()), [](const auto& one) { return one.param.name; });

TEST(Layouts, of_a_single_archive)
{
    const Desk desk;
    desk.write("ana.tar.gz",
               write_archive("ustar", "gzip",
                             {{"raytracing/sphere/sphere.cpp", solution}, {"raytracing/sphere/help.hpp", "x"}}));
    const Handed handed =
        collect(read_submission(desk.folder() / "ana.tar.gz", {}, desk.tools()), desk.exercise("raytracing/sphere"));
    EXPECT_EQ(handed.files, (Sources{{"sphere.cpp", solution}, {"help.hpp", "x"}}));
    EXPECT_EQ(handed.notes, std::vector<std::string>{});
}

// What `umbral new` copies for editors costs a submission nothing of its limits.
TEST(Layouts, of_a_workspace_with_the_framework)
{
    const Desk desk;
    desk.write("raytracing/sphere/sphere.cpp", solution);
    desk.write("include/umbral/raytracing/intersect.hpp", "struct Sphere;");
    desk.write("include/mine/sphere.hpp", "int x;");
    const SubmittedFiles submitted = desk.submitted();
    EXPECT_EQ(submitted.files,
              (Sources{{"include/mine/sphere.hpp", "int x;"}, {"raytracing/sphere/sphere.cpp", solution}}));
    EXPECT_EQ(submitted.ignored, std::vector<Ignored>{});
    EXPECT_EQ(desk.collected().files, (Sources{{"sphere.cpp", solution}}));
}

// Words of a unit's name are parted in many ways.
TEST(Layouts, of_a_name_of_several_words)
{
    for (const char* const path :
         {"view-matrix.cpp", "View Matrix.cpp", "ViewMatrix.cpp", "viewMatrix (3).cc", "view_matrix-copy.cpp"}) {
        const Desk desk;
        desk.write(path, solution);
        EXPECT_EQ(desk.collected("projections/view-matrix").files, (Sources{{"view_matrix.cpp", solution}})) << path;
    }
}

}
}
