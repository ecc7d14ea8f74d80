#include <gtest/gtest.h>

#include <random>

#include "collect/archive.hpp"
#include "collect/desk.hpp"
#include "model/caps.hpp"
#include "support/archive_writer.hpp"

namespace umbral::grader::test {
namespace {

using umbral::test::ArchiveEntry;
using umbral::test::write_archive;

using Files = std::vector<std::pair<std::string, std::string>>;

class Archives : public testing::Test {
protected:
    Desk desk;
    [[nodiscard]] Unpacked unpacked(const std::string& bytes) const { return unpack(desk.tools(), bytes); }
};

TEST_F(Archives, paths_lead_nowhere_else)
{
    for (const char* const format : {"zip", "ustar"}) {
        const Unpacked result = unpacked(write_archive(format, "none",
                                                       {{"../../etc/sphere.cpp", "up"},
                                                        {"/root/abs.cpp", "absolute"},
                                                        {"a/./b/../c.cpp", "dots"},
                                                        {"C:\\temp\\drive.cpp", "drive"},
                                                        {"..\\back.cpp", "back"}}));
        EXPECT_EQ(result.files, (Files{{"etc/sphere.cpp", "up"},
                                       {"root/abs.cpp", "absolute"},
                                       {"a/b/c.cpp", "dots"},
                                       {"temp/drive.cpp", "drive"},
                                       {"back.cpp", "back"}}))
            << format;
        EXPECT_TRUE(result.notes.empty());
    }
    EXPECT_EQ(harmless_path("../.."), "");
    EXPECT_EQ(harmless_path(std::string_view("a/b\0c/d", 7)), "a/d");
}

TEST_F(Archives, links_and_devices_are_ignored)
{
    const Unpacked tar = unpacked(write_archive("ustar", "gzip",
                                                {{"link.cpp", "", AE_IFLNK, "/etc/passwd"},
                                                 {"zero.cpp", "", AE_IFCHR},
                                                 {"pipe.cpp", "", AE_IFIFO},
                                                 {"folder.cpp", "", AE_IFDIR},
                                                 {"sphere.cpp", "mine"}}));
    EXPECT_EQ(tar.files, (Files{{"sphere.cpp", "mine"}}));
    EXPECT_EQ(tar.ignored.size(), 3U);
    const Unpacked zip =
        unpacked(write_archive("zip", "none", {{"link.cpp", "", AE_IFLNK, "/etc/passwd"}, {"sphere.cpp", "mine"}}));
    EXPECT_EQ(zip.files, (Files{{"sphere.cpp", "mine"}}));
    EXPECT_EQ(zip.ignored.size(), 1U);
}

TEST_F(Archives, names_beyond_ascii_come_as_they_are)
{
    EXPECT_EQ(unpacked(write_archive("pax", "none", {{"Práctica/esfera ñ.cpp", "x"}})).files,
              (Files{{"Práctica/esfera ñ.cpp", "x"}}));
    EXPECT_EQ(unpacked(write_archive("ustar", "none", {{"caf\xe9.cpp", "x"}})).files, (Files{{"caf\xe9.cpp", "x"}}));
}

// As some programs on Windows write it: said to be UTF-8, and in another encoding.
TEST_F(Archives, a_name_that_cannot_be_read_is_told)
{
    std::string zip = write_archive("zip", "none", {{"Práctica.cpp", "x"}});
    for (std::size_t at = zip.find("á"); at != std::string::npos; at = zip.find("á")) zip.replace(at, 2, "\xE1z");
    const Unpacked result = unpacked(zip);
    EXPECT_TRUE(result.files.empty() || result.files.front().first == "Pr\xE1zctica.cpp");
    EXPECT_EQ(result.files.size() + result.ignored.size(), 1U);
}

TEST_F(Archives, of_two_files_of_one_path_the_later_one_counts)
{
    desk.write("ana.tar", write_archive("ustar", "none", {{"sphere.cpp", "old"}, {"sphere.cpp", "new"}}));
    EXPECT_EQ(desk.collected().files.at("sphere.cpp"), "new");
}

TEST_F(Archives, what_is_no_source_code_stays_inside)
{
    const Unpacked result = unpacked(write_archive("zip", "none",
                                                   {{"a.exe", "x"},
                                                    {"__MACOSX/._sphere.cpp", "x"},
                                                    {".git/sphere.cpp", "x"},
                                                    {"node_modules/a/b.cpp", "x"},
                                                    {"b.hpp", "b"}}));
    EXPECT_EQ(result.files, (Files{{"b.hpp", "b"}}));
    EXPECT_TRUE(result.ignored.empty());
}

TEST_F(Archives, bombs_go_off_harmlessly)
{
    const std::string zeros(std::size_t{300} << 20U, '\0');
    for (const auto& [format, filter] : {std::pair("zip", "none"), std::pair("ustar", "gzip")}) {
        const std::string bomb =
            write_archive(format, filter, {{"first.cpp", "first"}, {"zeros.cpp", zeros}, {"last.cpp", "last"}});
        EXPECT_LT(bomb.size(), std::size_t{2} << 20U);
        const Unpacked result = unpacked(bomb);
        ASSERT_FALSE(result.files.empty()) << format << filter;
        EXPECT_EQ(result.files.front(), (std::pair<std::string, std::string>("first.cpp", "first")));
        EXPECT_LE(result.files.size(), 2U);
    }
}

TEST_F(Archives, many_files_are_bounded)
{
    std::vector<ArchiveEntry> entries;
    for (std::size_t i = 0; i < caps::submission_files + 1000; ++i)
        entries.push_back({std::to_string(i) + ".cpp", "x"});
    const Unpacked result = unpacked(write_archive("ustar", "gzip", entries));
    EXPECT_EQ(result.files.size(), caps::submission_files);
    EXPECT_EQ(result.ignored.size(), caps::submission_ignored);
    entries.clear();
    for (std::size_t i = 0; i < caps::submission_entries + 10; ++i) entries.push_back({std::to_string(i), ""});
    EXPECT_EQ(unpacked(write_archive("ustar", "gzip", entries)).notes.size(), 1U);
}

// Names are compared for each unit: longer ones than any folder has would cost as much as they like.
TEST_F(Archives, names_that_no_folder_could_hold_are_passed_over)
{
    const std::string longest = std::string(251, 'n') + ".cpp";
    const Unpacked result = unpacked(write_archive("pax", "gzip", {{"a/" + longest, "x"}, {"a/n" + longest, "x"}}));
    EXPECT_EQ(result.files, (Files{{"a/" + longest, "x"}}));
}

// What stands before a file in a 7z must be unpacked to reach it.
TEST_F(Archives, what_is_passed_over_in_a_7z_counts_as_well)
{
    const std::string zeros(caps::archive_unpacked + (std::size_t{16} << 20U), '\0');
    const Unpacked result = unpacked(write_archive("7zip", "none", {{"zeros.bin", zeros}, {"sphere.cpp", "mine"}}));
    EXPECT_TRUE(result.files.empty());
    EXPECT_EQ(result.notes, std::vector<std::string>{"it unpacks to too many bytes; the rest is not read"});
}

TEST_F(Archives, share_the_time_that_unpacking_may_take)
{
    for (const char* const name : {"a.zip", "b.zip"})
        desk.write(name, write_archive("zip", "none", {{"sphere.cpp", "mine"}}));
    ArchiveTools tools = desk.tools();
    tools.seconds = 1;
    const SubmittedFiles submitted = read_submission(desk.folder(), {}, tools);
    EXPECT_EQ(submitted.files, (Sources{{"a.zip/sphere.cpp", "mine"}}));
    EXPECT_EQ(submitted.ignored, (std::vector<Ignored>{{"b.zip", "unpacking the archives before it took too long"}}));
}

TEST_F(Archives, within_archives_are_opened_once)
{
    std::string bytes = write_archive("zip", "none", {{"sphere.cpp", "mine"}});
    for (int i = 0; i < 2; ++i)
        bytes = write_archive("zip", "none", {{"inner.zip", bytes}, {"at" + std::to_string(i) + ".cpp", "x"}});
    desk.write("outer.zip", bytes);
    const SubmittedFiles submitted = desk.submitted();
    EXPECT_EQ(submitted.files, (Sources{{"outer.zip/at1.cpp", "x"}, {"outer.zip/inner.zip/at0.cpp", "x"}}));
    ASSERT_EQ(submitted.ignored.size(), 1U);
    EXPECT_EQ(submitted.ignored[0].path, "outer.zip/inner.zip/inner.zip");
}

TEST_F(Archives, only_a_few_are_opened)
{
    for (int i = 0; i < 20; ++i)
        desk.write("a" + std::to_string(i) + ".zip", write_archive("zip", "none", {{"sphere.cpp", "mine"}}));
    const SubmittedFiles submitted = desk.submitted();
    EXPECT_EQ(submitted.files.size(), caps::submission_archives);
    EXPECT_EQ(submitted.ignored.size(), 20 - caps::submission_archives);
}

TEST_F(Archives, damaged_ones_say_so_and_give_what_can_be_read)
{
    std::string noise(200'000, '\0');
    std::mt19937 random(7);
    for (char& c : noise) c = static_cast<char>(random());
    for (const char* const format : {"zip", "ustar", "7zip"}) {
        const std::string whole = write_archive(format, "none", {{"sphere.cpp", "mine"}, {"rest.hpp", noise}});
        for (const std::size_t size :
             {std::size_t{0}, std::size_t{3}, std::size_t{700}, whole.size() / 2, whole.size() - 30}) {
            const Unpacked result = unpacked(whole.substr(0, size));
            // Behind the last file there is only what is needed to find the others.
            const bool all = result.files == Files{{"sphere.cpp", "mine"}, {"rest.hpp", noise}};
            EXPECT_TRUE(all || !result.notes.empty() || !result.ignored.empty()) << format << " " << size;
        }
    }
    desk.write("work.zip", "PK\x03\x04 and no more");
    const Handed handed = desk.collected();
    EXPECT_EQ(handed.missing, std::vector<std::string>{"sphere.cpp"});
    ASSERT_EQ(handed.notes.size(), 1U);
    EXPECT_EQ(handed.notes[0].find("work.zip: "), 0U) << handed.notes[0];
}

TEST_F(Archives, spoilt_at_random_do_no_harm)
{
    const std::string whole =
        write_archive("zip", "none", {{"sphere.cpp", "mine"}, {"a/b.hpp", std::string(3000, 'b')}});
    const unsigned seed = 11;
    std::mt19937 random(seed);
    for (int i = 0; i < 60; ++i) {
        std::string spoilt = whole;
        for (int k = 0; k < 1 + i / 6; ++k) spoilt[random() % spoilt.size()] = static_cast<char>(random());
        const Unpacked result = unpacked(spoilt);
        for (const auto& [path, bytes] : result.files) EXPECT_EQ(path, harmless_path(path)) << "seed " << seed;
    }
}

TEST(UnpackedText, is_not_believed)
{
    EXPECT_EQ(parse_unpacked("end\n").notes.size(), 0U);
    EXPECT_EQ(parse_unpacked("file 1 2\naxxend\n").files, (Files{{"a", "xx"}}));
    for (const std::string text :
         {"", "end", "end\nmore", "file", "file 1", "file 1 2\na", "file 99999999999999999999 1\n", "file -1 2\naxx",
          "file 1 68719476736\na", "file 0 1\nx", "file 2 1\n..xend\n", "odd 1 1\nab", "file  1 1\nab", "file 5000 0\n",
          "\x7f\x45\x4c\x46", "note 0 5\nab"}) {
        const Unpacked result = parse_unpacked(text);
        EXPECT_TRUE(result.files.empty()) << text;
        EXPECT_EQ(result.notes.back(), "it could not be read to its end") << text;
    }
    EXPECT_TRUE(parse_unpacked("file 5000 0\n" + std::string(5000, 'p') + "end\n").files.empty());
    // What came before the damage counts.
    EXPECT_EQ(parse_unpacked("file 1 2\naxxfile").files.size(), 1U);
    EXPECT_EQ(parse_unpacked("file 13 1\n../../etc/x.cxend\n").files, (Files{{"etc/x.c", "x"}}));
    EXPECT_EQ(parse_unpacked("note 0 4\n\x1b[2Jend\n").notes, std::vector<std::string>{"\xEF\xBF\xBD[2J"});
}

}
}
