#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <fstream>

#include "collect/as_nobody.hpp"
#include "collect/desk.hpp"
#include "collect/folder_reader.hpp"
#include "model/caps.hpp"
#include "run/descriptor.hpp"

// Whatever a submission looks like, it gives a verdict of its own: nothing here may throw, wait for ever, or show raw
// bytes.
namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

class HostileFolder : public testing::Test {
protected:
    Desk desk;
    void SetUp() override { fs::create_directories(desk.folder()); }

    /// Is everything that may be shown bounded and printable, and is sphere.cpp found?
    [[nodiscard]] static bool is_sound(const SubmittedFiles& submitted)
    {
        bool sound = submitted.ignored.size() <= caps::submission_ignored && submitted.notes.size() <= caps::listed &&
                     submitted.files.size() <= caps::submission_files;
        for (const Ignored& one : submitted.ignored) sound = sound && one.reason == one_line(one.reason, caps::message);
        for (const std::string& note : submitted.notes) sound = sound && note == one_line(note, caps::message);
        return sound;
    }
    /// Makes that many empty files.
    void make_files(std::size_t count, const std::function<std::string(int)>& name) const
    {
        const Descriptor folder(open(desk.folder().c_str(), O_RDONLY | O_DIRECTORY));
        for (int i = 0; i < static_cast<int>(count); ++i)
            close(openat(folder.get(), name(i).c_str(), O_CREAT | O_WRONLY, 0644));
    }
    void expect_found_beside_it() const
    {
        desk.write("sphere.cpp", "mine");
        EXPECT_TRUE(is_sound(desk.submitted()));
        EXPECT_EQ(desk.collected().files, (Sources{{"sphere.cpp", "mine"}}));
    }
};

TEST_F(HostileFolder, links_in_a_circle)
{
    fs::create_symlink("raytracing", desk.folder() / "raytracing");
    EXPECT_EQ(desk.collected().missing, std::vector<std::string>{"sphere.cpp"});
    fs::create_symlink(".", desk.folder() / "here");
    fs::create_symlink("/", desk.folder() / "everything");
    fs::create_symlink("b.cpp", desk.folder() / "a.cpp");
    fs::create_symlink("a.cpp", desk.folder() / "b.cpp");
    expect_found_beside_it();
}

// A folder that was one when it was listed may be a link by now.
TEST_F(HostileFolder, no_part_of_a_path_is_followed_through_a_link)
{
    fs::create_directories(desk.elsewhere());
    std::ofstream(desk.elsewhere() / "sphere.cpp") << "somebody's";
    fs::create_symlink(desk.elsewhere(), desk.folder() / "link");
    const Descriptor folder(open(desk.folder().c_str(), O_RDONLY | O_DIRECTORY));
    EXPECT_FALSE(read_file_below(folder.get(), "link/sphere.cpp", 100).refused.empty());
    EXPECT_FALSE(list_folder_below(folder.get(), "link", 100).refused.empty());
}

TEST_F(HostileFolder, pipes_sockets_and_devices)
{
    ASSERT_EQ(mkfifo((desk.folder() / "pipe.cpp").c_str(), 0666), 0);
    ASSERT_EQ(mkfifo((desk.folder() / "pipe.zip").c_str(), 0666), 0);
    const int number = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{AF_UNIX, {}};
    const std::string path = desk.folder() / "socket.cpp";
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(bind(number, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    close(number);
    // Only root may make one; a link to it does not count as one.
    if (geteuid() == 0) (void)mknod((desk.folder() / "zero.cpp").c_str(), S_IFCHR | 0666, makedev(1, 5));
    fs::create_symlink("/dev/zero", desk.folder() / "linked.cpp");
    EXPECT_GE(desk.submitted().ignored.size(), 4U);
    expect_found_beside_it();
}

TEST_F(HostileFolder, what_nobody_may_read)
{
    desk.write("raytracing/sphere/sphere.cpp", "mine");
    desk.write("open/sphere.cpp", "also mine");
    desk.write("shut/sphere.cpp", "hidden");
    const fs::path unit = desk.folder() / "raytracing/sphere";
    fs::permissions(desk.folder().parent_path(), fs::perms::all);
    const auto gives = [&](const std::function<bool(const Handed&)>& right) {
        return as_nobody([&] {
            const SubmittedFiles submitted = desk.submitted();
            return is_sound(submitted) && right(collect(submitted, desk.exercise("raytracing/sphere")));
        });
    };
    EXPECT_TRUE(gives([](const Handed& handed) { return handed.files == Sources{{"sphere.cpp", "mine"}}; }));
    fs::permissions(desk.folder() / "shut", fs::perms::none);
    fs::permissions(unit / "sphere.cpp", fs::perms::none);
    EXPECT_TRUE(gives([](const Handed& handed) { return handed.files == Sources{{"sphere.cpp", "also mine"}}; }));
    fs::remove_all(desk.folder() / "open");
    EXPECT_TRUE(gives([](const Handed& handed) {
        return handed.files.empty() &&
               handed.refused == "raytracing/sphere/sphere.cpp: it cannot be opened: Permission denied" &&
               handed.notes ==
                   std::vector<std::string>{"not looked into: shut (it cannot be opened: Permission denied)"};
    }));
    fs::permissions(desk.folder(), fs::perms::none);
    EXPECT_TRUE(gives([](const Handed& handed) {
        return handed.files.empty() && !handed.missing.empty() && handed.notes.size() == 1;
    }));
    fs::permissions(desk.folder(), fs::perms::all);
    fs::permissions(desk.folder() / "shut", fs::perms::all);
}

TEST_F(HostileFolder, tens_of_thousands_of_files)
{
    make_files(30'000, [](int i) { return std::to_string(i) + (i % 2 == 0 ? ".hpp" : ".txt"); });
    expect_found_beside_it();
    make_files(caps::submission_files, [](int i) { return std::to_string(i) + ".cpp"; });
    expect_found_beside_it();
    // Only what lies elsewhere can be pushed out, and then it is said why.
    fs::create_directory(desk.folder() / "z");
    fs::rename(desk.folder() / "sphere.cpp", desk.folder() / "z/sphere.cpp");
    const Handed handed = desk.collected();
    EXPECT_EQ(handed.missing.size() + (handed.refused.empty() ? 0 : 1), 1U);
    ASSERT_FALSE(handed.notes.empty());
    EXPECT_NE(handed.notes[0].find("more than 4096 files"), std::string::npos);
    make_files(caps::submission_entries - 34'000, [](int i) { return "more " + std::to_string(i); });
    const SubmittedFiles cut = desk.submitted();
    EXPECT_TRUE(is_sound(cut));
    ASSERT_FALSE(cut.notes.empty());
    EXPECT_NE(cut.notes[0].find("not all were looked at"), std::string::npos);
    desk.write("raytracing/sphere/sphere.cpp", "mine too");
    desk.write("raytracing/sphere/helper.hpp", "help");
    EXPECT_EQ(desk.collected().files, (Sources{{"sphere.cpp", "mine too"}, {"helper.hpp", "help"}}));
    EXPECT_EQ(desk.collected("transforms/axis-rotation").missing.size(), 1U);
    desk.write("axis_rotation.cpp", "flat");
    EXPECT_EQ(desk.collected("transforms/axis-rotation").files, (Sources{{"axis_rotation.cpp", "flat"}}));
}

TEST_F(HostileFolder, ten_thousand_deep)
{
    Descriptor folder(open(desk.folder().c_str(), O_RDONLY | O_DIRECTORY));
    for (int i = 0; i < 10'000; ++i) {
        ASSERT_EQ(mkdirat(folder.get(), "d", 0755), 0);
        folder = Descriptor(openat(folder.get(), "d", O_RDONLY | O_DIRECTORY));
    }
    expect_found_beside_it();
    EXPECT_EQ(desk.submitted().notes.size(), 1U);
}

TEST_F(HostileFolder, folders_that_fan_out)
{
    for (int i = 0; i < 300; ++i) fs::create_directories(desk.folder() / std::to_string(i) / "a/b/c.cpp/d.zip");
    expect_found_beside_it();
}

TEST_F(HostileFolder, names_of_any_bytes)
{
    for (const char* const name : {"new\nline.cpp", "\x1b]0;title\x07.cpp", "\xff\xfe.cpp",
                                   "\xe2\x80\xae"
                                   "ppc.cpp",
                                   " .cpp", "-rf.cpp", "*.cpp", "%s%n.cpp", "a\\b.cpp", "\x1b[31m/sphere (1).cpp",
                                   "new\n/x.zip", "'; rm -rf ~; '.tar.gz", "con.cpp", "sphere.cpp\r.cpp"})
        desk.write(name, "x");
    std::string longest(255, 'n');
    longest.replace(251, 4, ".cpp");
    desk.write(longest, "x");
    expect_found_beside_it();
    fs::remove(desk.folder() / "sphere.cpp");
    const Handed handed = desk.collected();
    ASSERT_EQ(handed.notes.size(), 1U);
    EXPECT_EQ(handed.notes[0], one_line(handed.notes[0], caps::message));
    EXPECT_NE(handed.notes[0].find("sphere (1).cpp"), std::string::npos);
}

TEST_F(HostileFolder, huge_files)
{
    desk.write("sphere.cpp", "");
    fs::resize_file(desk.folder() / "sphere.cpp", std::uintmax_t{1} << 40U);
    desk.write("sphere.zip", "");
    fs::resize_file(desk.folder() / "sphere.zip", std::uintmax_t{1} << 40U);
    const Handed handed = desk.collected();
    EXPECT_NE(handed.refused.find("1099511627776 bytes"), std::string::npos);
    EXPECT_EQ(handed.notes.size(), 1U);
    expect_found_beside_it();
}

TEST_F(HostileFolder, more_source_code_than_is_taken)
{
    const std::string big(caps::source_file, 'x');
    for (int i = 0; i < 100; ++i) desk.write("lib/" + std::to_string(i) + ".hpp", big);
    const SubmittedFiles submitted = desk.submitted();
    std::size_t bytes = 0;
    for (const auto& [path, text] : submitted.files) bytes += text.size();
    EXPECT_LE(bytes, caps::submission_bytes);
    EXPECT_FALSE(submitted.ignored.empty());
    expect_found_beside_it();
}

// Not even in the unit's own folder.
TEST_F(HostileFolder, nothing_pushes_out_what_lies_at_its_exact_place)
{
    desk.write("raytracing/sphere/sphere.cpp", "mine");
    make_files(caps::submission_files, [](int i) { return "raytracing/sphere/" + std::to_string(i) + ".cpp"; });
    EXPECT_EQ(desk.collected().files.at("sphere.cpp"), "mine");
}

TEST_F(HostileFolder, no_folder_at_all)
{
    desk.write("file.txt", "x");
    EXPECT_EQ(read_submission(desk.folder() / "file.txt", {}, desk.tools()).notes.size(), 1U);
    EXPECT_EQ(read_submission("/dev/zero", {}, desk.tools()).notes.size(), 1U);
    fs::create_symlink("loop.zip", desk.folder() / "loop.zip");
    EXPECT_EQ(read_submission(desk.folder() / "loop.zip", {}, desk.tools()).notes.size(), 1U);
}

// Somebody moved the class's folder while it was graded, or its disk is gone: no work is missing for that.
TEST_F(HostileFolder, what_was_listed_and_is_gone_is_no_fault_of_the_students)
{
    EXPECT_THROW((void)read_submission(desk.folder() / "nowhere", {}, desk.tools()), std::system_error);
    const Descriptor folder(open(desk.folder().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    EXPECT_THROW((void)read_file_below(folder.get(), "gone.cpp", 100), std::system_error);
    EXPECT_THROW((void)list_folder_below(folder.get(), "gone", 100), std::system_error);
    EXPECT_FALSE(lies_below(folder.get(), "gone/sphere.cpp"));
}

TEST_F(HostileFolder, errors_of_disks_and_networks_are_the_machines)
{
    for (const int error : {EIO, ESTALE, ENOTCONN, ETIMEDOUT, EMFILE, ENFILE, ENOMEM, ENOENT})
        EXPECT_FALSE(may_be_made(error)) << error;
    for (const int error : {EACCES, ELOOP, ENAMETOOLONG, ENXIO, ENOTDIR}) EXPECT_TRUE(may_be_made(error)) << error;
}

// That is the machine's trouble, and nobody's missing work.
TEST_F(HostileFolder, no_descriptor_left_is_no_fault_of_the_students)
{
    desk.write("sphere.cpp", "mine");
    EXPECT_TRUE(as_nobody([&] {
        rlimit few{3, 3};
        if (setrlimit(RLIMIT_NOFILE, &few) != 0) return false;
        try {
            (void)read_submission(desk.folder(), {});
            return false;
        } catch (const std::system_error&) {
            return true;
        }
    }));
}

}
}
