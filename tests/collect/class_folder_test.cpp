#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "collect/class_folder.hpp"
#include "collect/roster.hpp"
#include "collect/submission_id.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

class ClassFolders : public testing::Test {
protected:
    umbral::test::TemporaryFolder folder;

    void make(const std::string& name) const { fs::create_directories(folder / "class" / name); }
    [[nodiscard]] ClassFolder read() const { return class_folder(folder / "class"); }
    [[nodiscard]] std::map<std::string, std::string> ids() const
    {
        std::map<std::string, std::string> result;
        for (const SubmissionFolder& one : read().submissions) result[one.folder.filename()] = one.id;
        return result;
    }
    [[nodiscard]] ClassFolder with_roster(const std::string& text) const
    {
        folder.write("roster.csv", text);
        return class_folder(folder / "class", folder / "roster.csv");
    }
    /// What is said of a wrong roster; empty if nothing is.
    [[nodiscard]] std::string complaint(const std::string& text) const
    {
        try {
            (void)with_roster(text);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(ClassFolders, plain_names_are_ids)
{
    for (const char* const name : {"ana", "Team_7.x-y", "0", "ANA"}) make(name);
    EXPECT_EQ(ids(), (std::map<std::string, std::string>{
                         {"ana", "ana"}, {"Team_7.x-y", "Team_7.x-y"}, {"0", "0"}, {"ANA", "ANA"}}));
}

TEST_F(ClassFolders, of_learning_platforms_get_ids_that_people_recognise)
{
    make("García López, José_123_assignsubmission_file_");
    make("Ana Gil");
    make("Łukasz Šťastný");
    make("Nguyễn Thị Ánh");
    make("Jose\xCC\x81 Mun\xCC\x83oz");  // as Macs write it
    const auto all = ids();
    EXPECT_EQ(all.at("García López, José_123_assignsubmission_file_"), "Garcia-Lopez-Jose_123_assignsubmission_file");
    EXPECT_EQ(all.at("Ana Gil"), "Ana-Gil");
    EXPECT_EQ(all.at("Łukasz Šťastný"), "Lukasz-Stastny");
    EXPECT_EQ(all.at("Nguyễn Thị Ánh"), "Nguyen-Thi-Anh");
    EXPECT_EQ(all.at("Jose\xCC\x81 Mun\xCC\x83oz"), "Jose-Munoz");
    EXPECT_EQ(read().submissions[0].shown, "Ana Gil");
}

TEST_F(ClassFolders, names_of_reports_files_are_nobodys)
{
    for (const char* const name : {"class.json", "Index.HTML", "marks.csv", "-rf", "a.json"}) make(name);
    const auto all = ids();
    EXPECT_EQ(all.at("class.json"), "class-json");
    EXPECT_EQ(all.at("Index.HTML"), "Index-HTML");
    EXPECT_EQ(all.at("marks.csv"), "marks-csv");
    EXPECT_EQ(all.at("-rf"), "rf");
    EXPECT_EQ(all.size(), 5U);
}

TEST_F(ClassFolders, names_that_another_system_cannot_hold_are_nobodys)
{
    for (const char* const name : {"NUL", "com1.ana", "gil.", "console", "com10"}) make(name);
    const auto all = ids();
    EXPECT_EQ(all.at("NUL"), "id-NUL");
    EXPECT_EQ(all.at("com1.ana"), "com1-ana");
    EXPECT_EQ(all.at("gil."), "gil");
    EXPECT_EQ(all.at("console"), "console");
    EXPECT_EQ(all.at("com10"), "com10");
}

TEST_F(ClassFolders, whatever_the_names_ids_are_plain_and_unique)
{
    const std::vector<std::string> names{"a b",
                                         "a-b",
                                         "a,b",
                                         "á b",
                                         "😀",
                                         "😀😀",
                                         "\xff\xfe",
                                         "new\nline",
                                         "\x1b[31mred",
                                         " ",
                                         std::string(255, 'x'),
                                         std::string(254, 'x') + "y",
                                         "Ana.json.",
                                         "日本",
                                         "...x",
                                         "class.json",
                                         "class-json",
                                         "%s%n",
                                         "*",
                                         "$(id)",
                                         "`id`",
                                         "con",
                                         "\xcc",
                                         "a\xcc",
                                         "a\xcc\x81"};
    for (const std::string& name : names) make(name);
    make("a-b-" + short_hash("a b"));
    const ClassFolder result = read();
    std::set<std::string> seen;
    for (const SubmissionFolder& one : result.submissions) {
        EXPECT_TRUE(is_submission_id(one.id) && !is_reserved_id(one.id)) << one.id;
        EXPECT_TRUE(seen.insert(one.id).second) << one.id;
        EXPECT_EQ(one.shown.find_first_of("\n\x1b\xff"), std::string::npos) << one.shown;
        EXPECT_TRUE(fs::is_directory(one.folder));
    }
    EXPECT_EQ(result.submissions.size() + result.ignored.size(), names.size() + 1);
    EXPECT_EQ(result.ignored.size(), 1U);  // ...x
    EXPECT_EQ(ids().at("a-b"), "a-b");
    EXPECT_EQ(ids().at("class-json"), "class-json");
    EXPECT_EQ(ids(), ids());
}

TEST_F(ClassFolders, archives_are_submissions)
{
    for (const char* const name : {"class/ana.zip", "class/bruno.tar.gz", "class/García.zip", "class/carla.zip"})
        folder.write(name, "");
    make("carla");
    const auto all = ids();
    EXPECT_EQ(all.at("ana.zip"), "ana");
    EXPECT_EQ(all.at("bruno.tar.gz"), "bruno");
    EXPECT_EQ(all.at("García.zip"), "Garcia");
    EXPECT_EQ(all.at("carla"), "carla");
    EXPECT_EQ(all.at("carla.zip"), "carla-" + short_hash("carla.zip"));
}

TEST_F(ClassFolders, what_is_no_submission_is_listed)
{
    make("ana");
    make(".git");
    make("__MACOSX");
    folder.write("class/notes.txt", "x");
    folder.write("class/bad\nname.cpp", "x");
    fs::create_symlink("ana", folder / "class/link");
    fs::create_symlink("loop.zip", folder / "class/loop.zip");
    ASSERT_EQ(mkfifo((folder / "class/pipe.zip").c_str(), 0600), 0);
    const ClassFolder result = read();
    ASSERT_EQ(result.submissions.size(), 1U);
    ASSERT_EQ(result.ignored.size(), 7U);
    for (const Ignored& one : result.ignored) {
        EXPECT_EQ(one.path.find('\n'), std::string::npos);
        EXPECT_FALSE(one.reason.empty());
    }
}

TEST_F(ClassFolders, only_the_class_itself_throws)
{
    EXPECT_THROW((void)class_folder(folder / "nowhere"), std::runtime_error);
    folder.write("file", "x");
    EXPECT_THROW((void)class_folder(folder / "file"), std::runtime_error);
    fs::create_directories(folder / "class/shut");
    fs::permissions(folder / "class/shut", fs::perms::none);
    EXPECT_EQ(read().submissions.size(), 1U);
    fs::permissions(folder / "class/shut", fs::perms::all);
    fs::remove_all(folder / "class/shut");
    EXPECT_TRUE(read().submissions.empty());
}

TEST_F(ClassFolders, a_roster_decides)
{
    make("García, Ana");
    make("bruno");
    folder.write("class/Carla Ruiz.zip", "");
    const ClassFolder result = with_roster(
        "\xEF\xBB\xBF"
        "folder,id,name\r\n\"García, Ana\",s1,\"Ana \"\"la rápida\"\" García\"\r\nCarla "
        "Ruiz,s0,\r\nabsent,s9,Nobody\r\n");
    ASSERT_EQ(result.submissions.size(), 3U);
    EXPECT_EQ(result.submissions[0].id, "bruno");
    EXPECT_EQ(result.submissions[1].id, "s0");
    EXPECT_EQ(result.submissions[1].shown, "Carla Ruiz.zip");
    EXPECT_EQ(result.submissions[2].id, "s1");
    EXPECT_EQ(result.submissions[2].shown, "Ana \"la rápida\" García");
    ASSERT_EQ(result.ignored.size(), 1U);
    EXPECT_EQ(result.ignored[0], (Ignored{"absent", "line 4 of the roster: there is no such folder"}));
}

// As Macs write it: the accent is a character of its own. Nobody becomes José by a folder that looks like his.
TEST_F(ClassFolders, a_name_that_is_spelt_with_other_characters_is_pointed_out)
{
    make("Jose\u0301");
    const ClassFolder result = with_roster("folder,id\nJosé,s1\n");
    ASSERT_EQ(result.submissions.size(), 1U);
    EXPECT_EQ(result.submissions[0].id, "Jose");
    ASSERT_EQ(result.ignored.size(), 1U);
    EXPECT_NE(result.ignored[0].reason.find("looks alike"), std::string::npos) << result.ignored[0].reason;
}

// José was graded as Jose. Whoever hands in a folder of that name later does not become him, nor makes him another.
TEST_F(ClassFolders, ids_of_an_earlier_grading_stay_with_their_folders)
{
    const auto ids = [&](const std::map<std::string, std::string>& known) {
        std::map<std::string, std::string> found;
        for (const SubmissionFolder& one : class_folder(folder / "class", {}, known).submissions)
            found[one.folder.filename().string()] = one.id;
        return found;
    };
    make("José");
    EXPECT_EQ(ids({}).at("José"), "Jose");
    make("Jose");
    EXPECT_EQ(ids({}).at("Jose"), "Jose");
    const auto later = ids({{"José", "Jose"}});
    EXPECT_EQ(later.at("José"), "Jose");
    EXPECT_NE(later.at("Jose"), "Jose");
    EXPECT_EQ(ids({{"José", "../out"}}).at("Jose"), "Jose") << "whatever lies in the folder of reports";
}

TEST_F(ClassFolders, a_folder_named_like_an_id_of_the_roster_gives_way)
{
    for (const char* const name : {"a", "b", "b.zip"}) make(name);
    const ClassFolder found = with_roster("folder,id\na,b\n");
    ASSERT_EQ(found.submissions.size(), 3U);
    std::set<std::string> ids;
    for (const SubmissionFolder& one : found.submissions) {
        ids.insert(one.id);
        EXPECT_EQ(one.id == "b", one.folder.filename() == "a") << one.id;
        EXPECT_TRUE(one.id.starts_with("b")) << one.id;
    }
    EXPECT_EQ(ids.size(), 3U);
}

// Who hands in ana.tar.gz beside Ana's ana.zip must not become Ana.
TEST_F(ClassFolders, an_archive_named_like_another_one_is_not_taken_for_it)
{
    for (const char* const name : {"class/ana.tar.gz", "class/ana.zip", "class/bruno.zip"}) folder.write(name, "");
    const ClassFolder found = with_roster("folder,id\nana,4711\nbruno,4712\n");
    ASSERT_EQ(found.submissions.size(), 3U);
    EXPECT_EQ(found.submissions[0].id, "4712");
    for (const std::size_t i : {1U, 2U}) EXPECT_TRUE(found.submissions[i].id.starts_with("ana-"));
    EXPECT_EQ(found.ignored, (std::vector<Ignored>{{"ana",
                                                    "line 2 of the roster: each of ana.tar.gz, ana.zip could be "
                                                    "it: list an archive by its whole name, or rename one of them"}}));
    EXPECT_EQ(with_roster("folder,id\nana.zip,4711\n").submissions[0].folder.filename(), "ana.zip");
}

// Nor who hands in a folder of that name.
TEST_F(ClassFolders, a_folder_named_like_an_archive_is_not_taken_for_it)
{
    make("ana");
    folder.write("class/ana.zip", "");
    const ClassFolder found = with_roster("folder,id\nana,4711\n");
    for (const SubmissionFolder& one : found.submissions) EXPECT_NE(one.id, "4711");
    ASSERT_EQ(found.ignored.size(), 1U);
    EXPECT_NE(found.ignored[0].reason.find("each of ana, ana.zip could be it"), std::string::npos);
    const ClassFolder named = with_roster("folder,id\nana.zip,4711\n");
    EXPECT_EQ(std::ranges::find(named.submissions, "4711", &SubmissionFolder::id)->folder.filename(), "ana.zip");
}

TEST_F(ClassFolders, wrong_rosters_are_refused_with_the_line)
{
    for (const char* const name : {"a", "b", "c.zip"}) make(name);
    const std::map<std::string, std::string> wrong{
        {"", ":1: expected the first line"},
        {"id,folder\na,b\n", ":1: expected the first line"},
        {"folder,id\na\n", ":2: expected 2 fields, got 1"},
        {"folder,id\n\na,x,y\n", ":3: expected 2 fields, got 3"},
        {"folder,id\na,b c\n", ":2: expected an id"},
        {"folder,id\na,class.json\n", ":2: expected an id"},
        {"folder,id\na,\n", ":2: expected an id"},
        {"folder,id\n../a,x\n", ":2: expected the name of a folder"},
        {"folder,id\na,x\na,y\n", ":3: the folder 'a' stands in line 2 already"},
        {"folder,id\na,x\nb,x\n", ":3: the id 'x' stands in line 2 already"},
        {"folder,id\n\"a,x\n", ":2: the quote that begins here does not end"},
        {"folder,id\n\"a\"b,x\n", ":2: expected ',' or the end of the line"},
        {"folder,id\na\"b,x\n", ":2: a quote within a field"},
        {"folder,id\n\"x\ny\",ok\nq,b c\n", ":4: expected an id"},
    };
    for (const auto& [text, expected] : wrong)
        EXPECT_NE(complaint(text).find(expected), std::string::npos) << text << "\n" << complaint(text);
    EXPECT_EQ(complaint("folder,id\na,b\nb,a\n"), "");
    EXPECT_EQ(complaint("folder,id\na,x"), "");
    EXPECT_THROW((void)class_folder(folder / "class", folder / "no-roster.csv"), std::runtime_error);
}

}
}
