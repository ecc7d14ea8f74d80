#include <gtest/gtest.h>

#include <map>

#include "collect/candidates.hpp"
#include "collect/desk.hpp"
#include "collect/file_names.hpp"
#include "manifest/units.hpp"
#include "model/caps.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

class Choices : public testing::Test {
protected:
    Desk desk;
};

TEST_F(Choices, of_several_that_differ_none_is_taken_and_all_are_named)
{
    desk.write("old/sphere.cpp", "one");
    desk.write("new/Sphere.cpp", "two");
    desk.write("newer/sphere.cc", "two");
    const Handed handed = desk.collected();
    EXPECT_TRUE(handed.files.empty());
    EXPECT_TRUE(handed.missing.empty());
    for (const char* const path : {"old/sphere.cpp", "new/Sphere.cpp", "newer/sphere.cc", "hand in only one"})
        EXPECT_NE(handed.refused.find(path), std::string::npos) << handed.refused;
    EXPECT_FALSE(handed.nothing());
}

TEST_F(Choices, the_list_of_candidates_is_bounded)
{
    for (int i = 0; i < 300; ++i)
        desk.write(std::string(200, 'f') + std::to_string(i) + "/sphere.cpp", std::to_string(i));
    const Handed handed = desk.collected();
    EXPECT_TRUE(handed.files.empty());
    EXPECT_NE(handed.refused.find("and 288 more"), std::string::npos);
    EXPECT_LT(handed.refused.size(), caps::message);
}

TEST_F(Choices, the_units_place_wins_and_a_note_names_the_others)
{
    desk.write("raytracing/sphere/sphere.cpp", "mine");
    desk.write("old/sphere.cpp", "older");
    desk.write("copy/sphere.cpp", "mine");
    const Handed handed = desk.collected();
    EXPECT_EQ(handed.files, (Sources{{"sphere.cpp", "mine"}}));
    ASSERT_EQ(handed.notes.size(), 1U);
    EXPECT_NE(handed.notes[0].find("old/sphere.cpp"), std::string::npos);
    EXPECT_EQ(handed.notes[0].find("copy/sphere.cpp"), std::string::npos);
}

TEST_F(Choices, a_workspace_below_wins_over_a_file_anywhere)
{
    desk.write("Entrega/Raytracing/Sphere/Sphere.cpp", "mine");
    desk.write("drafts/sphere.cpp", "older");
    EXPECT_EQ(desk.collected().files, (Sources{{"sphere.cpp", "mine"}}));
    desk.write("Entrega2/raytracing/sphere/sphere.cpp", "another");
    EXPECT_TRUE(desk.collected().files.empty());
}

TEST_F(Choices, only_stubs_give_the_stub)
{
    const std::string stub = read_text(desk.exercise("raytracing/sphere").folder / "sphere.cpp");
    desk.write("raytracing/sphere/sphere.cpp", stub);
    desk.write("b/sphere.cpp", "// mine\n" + stub);
    const Handed handed = desk.collected();
    EXPECT_EQ(handed.files, (Sources{{"sphere.cpp", stub}}));
    EXPECT_TRUE(handed.refused.empty());
}

TEST_F(Choices, two_files_of_a_unit_come_from_one_folder)
{
    const fs::path stubs = desk.exercise("lighting/shaders").folder;
    const std::string stub = read_text(stubs / "phong.vert");
    desk.write("lighting/shaders/phong.vert", stub);
    desk.write("lighting/shaders/phong.frag", "new");
    desk.write("old/phong.vert", "old vert");
    desk.write("old/phong.frag", "old frag");
    EXPECT_EQ(desk.collected("lighting/shaders").files, (Sources{{"phong.vert", stub}, {"phong.frag", "new"}}));
    fs::remove_all(desk.folder() / "lighting");
    EXPECT_EQ(desk.collected("lighting/shaders").files,
              (Sources{{"phong.vert", "old vert"}, {"phong.frag", "old frag"}}));
    fs::remove(desk.folder() / "old/phong.frag");
    EXPECT_EQ(desk.collected("lighting/shaders").missing, std::vector<std::string>{"phong.frag"});
}

TEST_F(Choices, helpers_come_from_the_units_own_folder_only)
{
    for (const char* const folder : {"Sphere/", "shapes/"}) {
        desk.write(std::string(folder) + "sphere.cpp", "mine");
        desk.write(std::string(folder) + "help.h", "h");
        desk.write(std::string(folder) + "help.cc", "cc");
        desk.write(std::string(folder) + "sphere (1).cpp", "mine");
        if (folder == std::string("Sphere/")) {
            EXPECT_EQ(desk.collected().files, (Sources{{"sphere.cpp", "mine"}, {"help.h", "h"}, {"help.cpp", "cc"}}));
            fs::remove_all(desk.folder() / "Sphere");
        }
    }
    EXPECT_EQ(desk.collected().files, (Sources{{"sphere.cpp", "mine"}}));
}

TEST_F(Choices, names_that_a_compiler_misreads_are_not_taken)
{
    desk.write("raytracing/sphere/sphere.cpp", "mine");
    for (const char* const name :
         {"-oX.cpp", "-include.hpp", "@x.cpp", "a b.cpp", "x\n.cpp", "\x1b[2J.cpp", "\xff.cpp"})
        desk.write(std::string("raytracing/sphere/") + name, "x");
    const Handed handed = desk.collected();
    EXPECT_EQ(handed.files, (Sources{{"sphere.cpp", "mine"}}));
    EXPECT_EQ(handed.notes.size(), 7U);
    for (const std::string& note : handed.notes) EXPECT_EQ(note.find_first_of("\n\x1b\xff"), std::string::npos) << note;
}

TEST_F(Choices, bytes_of_helpers_are_bounded)
{
    desk.write("raytracing/sphere/sphere.cpp", "mine");
    for (int i = 0; i < 10; ++i)
        desk.write("raytracing/sphere/a" + std::to_string(i) + ".hpp", std::string(caps::source_file, 'x'));
    const Handed handed = desk.collected();
    std::size_t bytes = 0;
    for (const auto& [name, text] : handed.files) bytes += text.size();
    EXPECT_LE(bytes, caps::unit_sources);
    EXPECT_TRUE(handed.files.contains("sphere.cpp"));
    EXPECT_EQ(handed.notes.size(), 1U);
}

TEST_F(Choices, what_was_not_read_is_the_reason_why_a_file_is_missing)
{
    desk.write("work/Sphere.cpp", std::string(caps::source_file + 1, 'x'));
    desk.write("work.rar", "Rar!\x1a\x07");
    const Handed handed = desk.collected();
    EXPECT_NE(handed.refused.find("work/Sphere.cpp: it has 524289 bytes"), std::string::npos) << handed.refused;
    ASSERT_EQ(handed.notes.size(), 1U);
    EXPECT_NE(handed.notes[0].find("work.rar: it is no archive that can be opened"), std::string::npos);
}

// In a flat folder, or in one that somebody renamed, only the name says which unit a file belongs to.
TEST(Units, ask_for_names_that_are_told_apart)
{
    std::map<std::string, std::string> seen;
    for (const Exercise& exercise : load_units(fs::path(UMBRAL_SOURCE_DIR) / "exercises").exercises)
        for (const std::string& name : exercise.files) {
            const auto [before, fresh] = seen.emplace(file_key(name), exercise.id);
            EXPECT_TRUE(fresh) << name << " of " << exercise.id << " looks like a file of " << before->second;
        }
    EXPECT_GT(seen.size(), 40U);
}

TEST(FileKey, is_the_same_for_names_of_one_file)
{
    for (const char* const name :
         {"view_matrix.cpp", "View-Matrix (1).cc", "ViewMatrix - Copy.cpp", "Copia de view_matrix.CXX",
          "view matrix copy 2.cpp", "view_matrix - copia (3).C", "view_matrix.cpp.txt", "view_matrix (1) (2).c++"})
        EXPECT_EQ(file_key(name), "viewmatrix.cpp") << name;
    EXPECT_EQ(file_key("copy.cpp"), "copy.cpp");
    EXPECT_EQ(file_key("(1).cpp"), "(1).cpp");
    EXPECT_EQ(file_key("phong (1).FRAG"), "phong.frag");
    EXPECT_EQ(file_key(""), "");
    EXPECT_NE(file_key("view_matrix2.cpp"), "viewmatrix.cpp");
    EXPECT_NE(file_key("view_matrix.hpp"), "viewmatrix.cpp");
}

}
}
