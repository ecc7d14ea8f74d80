#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "attack/measured.hpp"
#include "attack/setting.hpp"
#include "support/temporary_folder.hpp"

// What goes wrong without any ill will, on the whole path: no submission is lost, no right work becomes a zero, and the
// next run heals.
namespace umbral::grader::attack {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

void check(bool good, const char* what)
{
    if (!good) throw std::system_error(errno, std::generic_category(), what);
}

/// A class of right work and the calls that grade it.
class Slips : public testing::Test {
protected:
    Slips()
    {
        fs::permissions(folder.path(), fs::perms::others_exec | fs::perms::group_exec, fs::perm_options::add);
        for (const char* const id : {"ana", "berta", "carlos"}) {
            const fs::path unit = submissions / id / "raytracing" / "sphere";
            fs::create_directories(unit);
            fs::copy_file(fs::path(UMBRAL_SOURCE) / "reference" / "raytracing" / "sphere.cpp", unit / "sphere.cpp");
            // Each its own file: one built library must not serve all.
            std::ofstream(unit / "sphere.cpp", std::ios::app) << "// " << id << "\n";
        }
        for (const char* const name : {"cache", "home", "tmp"}) fs::create_directories(folder.path() / name);
    }

    [[nodiscard]] Measured grade(const fs::path& to, const std::function<void()>& before = {},
                                 const std::function<bool()>& interrupt = {}) const
    {
        Call call;
        call.words = {UMBRAL_PROGRAM,
                      "grade",
                      submissions.string(),
                      "--out",
                      to.string(),
                      "--secret-file",
                      (folder.path() / "secret").string(),
                      "--jobs",
                      "2",
                      "--unit",
                      "raytracing/sphere"};
        call.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", "HOME=" + (folder.path() / "home").string(),
                            "TMPDIR=" + (folder.path() / "tmp").string(), "UMBRAL_CACHE=" + cache.string()};
        call.output = folder.path() / "printed.txt";
        call.seconds = 240;
        call.before = before;
        call.interrupt = interrupt;
        return run_measured(call);
    }

    /// All of it belongs to nobody, who grades from now on: root's runs could not read what nobody built.
    void give_to_nobody() const
    {
        const auto give = [](const fs::path& path) { check(lchown(path.c_str(), 65534, 65534) == 0, "lchown"); };
        for (const auto& entry : fs::recursive_directory_iterator(folder.path())) give(entry.path());
        give(folder.path());
    }
    static void as_nobody() { enter({.as_nobody = true, .without_namespaces = false, .gl = ""}); }

    [[nodiscard]] static Json unit_of(const fs::path& to, const std::string& id)
    {
        const Json report = Json::parse(bytes_of_file(to / id / "report.json"), nullptr, false);
        return report.is_object() ? report.at("submission").at("units").at(0) : Json();
    }

    void expect_no_false_zero(const fs::path& to) const
    {
        for (const char* const id : {"ana", "berta", "carlos"}) {
            const Json unit = unit_of(to, id);
            if (!unit.is_object() || unit.at("verdict") == "grader_fault") continue;
            EXPECT_EQ(unit.at("score"), 10000) << id << ": " << unit.at("verdict") << ": " << unit.at("message");
        }
    }

    void expect_all_right(const fs::path& to, const std::function<void()>& before = {}) const
    {
        const Measured again = grade(to, before);
        EXPECT_EQ(again.status, 0) << again.printed;
        for (const char* const id : {"ana", "berta", "carlos"})
            EXPECT_EQ(unit_of(to, id).value("score", 0), 10000) << id << again.printed;
    }

    void expect_submissions_there() const
    {
        for (const char* const id : {"ana", "berta", "carlos"})
            EXPECT_TRUE(fs::exists(submissions / id / "raytracing" / "sphere" / "sphere.cpp")) << id;
    }

    void expect_refused(const fs::path& to) const
    {
        const Measured run = grade(to);
        EXPECT_EQ(run.status, 2) << run.printed;
        expect_submissions_there();
    }

    /// A disk of its own for one folder, which only the grader sees and which is full soon.
    [[nodiscard]] std::function<void()> with_small_disk(const fs::path& at, const char* size) const
    {
        return [at, size] {
            check(unshare(CLONE_NEWNS) == 0, "unshare");
            check(mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0, "mount /");
            check(mount("none", at.c_str(), "tmpfs", 0, size) == 0, "mount tmpfs");
        };
    }

    umbral::test::TemporaryFolder folder;
    fs::path submissions = folder.path() / "class";
    fs::path cache = folder.path() / "cache";
    fs::path out = folder.path() / "out";
};

TEST_F(Slips, out_equals_the_submissions) { expect_refused(submissions); }
TEST_F(Slips, out_lies_in_the_submissions) { expect_refused(submissions / "reports"); }
TEST_F(Slips, out_lies_in_one_submission) { expect_refused(submissions / "ana" / "out"); }
TEST_F(Slips, out_holds_the_submissions) { expect_refused(folder.path()); }

TEST_F(Slips, out_equals_the_submissions_by_a_link)
{
    fs::create_directory_symlink(submissions, out);
    expect_refused(out);
}

TEST_F(Slips, out_equals_the_submissions_by_dots) { expect_refused(submissions / ".." / "class" / "."); }

TEST_F(Slips, foreign_files_in_out_stay)
{
    for (const char* const name : {"notes.txt", "ana/precious.txt", "other/precious.txt"}) {
        fs::create_directories((out / name).parent_path());
        std::ofstream(out / name) << "precious";
    }
    (void)grade(out);
    for (const char* const name : {"notes.txt", "ana/precious.txt", "other/precious.txt"})
        EXPECT_EQ(bytes_of_file(out / name), "precious") << name;
    expect_submissions_there();
}

TEST_F(Slips, links_in_out_are_not_followed)
{
    fs::create_directories(folder.path() / "elsewhere");
    std::ofstream(folder.path() / "elsewhere" / "precious.txt") << "precious";
    fs::create_directories(out);
    fs::create_directory_symlink(folder.path() / "elsewhere", out / "ana");
    fs::create_symlink(folder.path() / "elsewhere" / "precious.txt", out / "class.json");
    (void)grade(out);
    EXPECT_EQ(bytes_of_file(folder.path() / "elsewhere" / "precious.txt"), "precious");
    EXPECT_FALSE(fs::exists(folder.path() / "elsewhere" / "report.json"));
}

TEST_F(Slips, full_disk_of_the_cache)
{
    if (geteuid() != 0) GTEST_SKIP() << "only root can mount a small disk";
    for (const char* const size : {"size=64k", "size=300k", "size=1m"}) {
        fs::remove_all(out);
        const Measured run = grade(out, with_small_disk(cache, size));
        // Where there is just enough room, all is right; else the exit status says that something is not.
        bool whole = true;
        for (const char* const id : {"ana", "berta", "carlos"})
            whole = whole && unit_of(out, id).value("score", 0) == 10000;
        EXPECT_EQ(run.status == 0, whole) << size << run.printed;
        expect_no_false_zero(out);
        expect_all_right(out);
    }
}

TEST_F(Slips, full_disk_of_the_reports)
{
    if (geteuid() != 0) GTEST_SKIP() << "only root can mount a small disk";
    fs::create_directories(out);
    const Measured run = grade(out, with_small_disk(out, "size=32k"));
    EXPECT_NE(run.status, 0) << run.printed;
    EXPECT_EQ(run.signal, 0);
    EXPECT_NE(run.printed.find("space"), std::string::npos) << run.printed;
    expect_all_right(out);
}

TEST_F(Slips, full_disk_for_temporary_files)
{
    if (geteuid() != 0) GTEST_SKIP() << "only root can mount a small disk";
    (void)grade(out, with_small_disk(folder.path() / "tmp", "size=4k"));
    expect_no_false_zero(out);
    expect_all_right(out);
}

TEST_F(Slips, few_descriptors)
{
    for (const rlim_t most : {8U, 12U, 16U, 24U}) {
        const Measured run = grade(out, [most] {
            const rlimit limit{most, most};
            check(setrlimit(RLIMIT_NOFILE, &limit) == 0, "setrlimit");
        });
        EXPECT_EQ(run.signal, 0) << run.printed;
        expect_no_false_zero(out);
    }
    expect_all_right(out);
}

TEST_F(Slips, few_processes)
{
    if (geteuid() != 0) GTEST_SKIP() << "root is bound by no limit of processes: only as nobody";
    give_to_nobody();
    for (const rlim_t most : {3U, 6U, 9U}) {
        const Measured run = grade(out, [most] {
            const rlimit limit{most, most};
            check(setrlimit(RLIMIT_NPROC, &limit) == 0, "setrlimit");
            as_nobody();
        });
        EXPECT_EQ(run.signal, 0) << run.printed;
        expect_no_false_zero(out);
    }
    expect_all_right(out, as_nobody);
}

TEST_F(Slips, out_is_read_only)
{
    if (geteuid() != 0) GTEST_SKIP() << "root writes everywhere: only as nobody";
    fs::create_directories(out);
    give_to_nobody();
    fs::permissions(out, fs::perms::owner_read | fs::perms::owner_exec);
    const Measured run = grade(out, as_nobody);
    EXPECT_GE(run.status, 2) << run.printed;
    EXPECT_EQ(run.signal, 0);
    fs::permissions(out, fs::perms::owner_all);
    expect_all_right(out, as_nobody);
}

TEST_F(Slips, little_memory)
{
    for (const rlim_t mib : {96U, 200U, 400U}) {
        const Measured run = grade(out, [mib] {
            const rlimit limit{mib << 20U, mib << 20U};
            check(setrlimit(RLIMIT_AS, &limit) == 0, "setrlimit");
        });
        EXPECT_FALSE(run.timed_out) << run.printed;
        expect_no_false_zero(out);
    }
    expect_all_right(out);
}

TEST_F(Slips, killed_in_the_middle)
{
    // Killed as soon as a first report is there, then a little later each time.
    for (int patience = 0; patience < 3; ++patience) {
        int seen = 0;
        const Measured run =
            grade(out, {}, [&] { return fs::exists(out / "ana" / "report.json") && ++seen > 10 * patience; });
        if (run.signal == 0) continue;
        const Json unit = unit_of(out, "ana");
        EXPECT_TRUE(unit.is_object()) << "a report that was there is whole";
        expect_no_false_zero(out);
    }
    expect_all_right(out);
}

TEST_F(Slips, damaged_cache)
{
    expect_all_right(out);
    for (const auto& entry : fs::recursive_directory_iterator(cache))
        if (entry.is_regular_file()) fs::resize_file(entry.path(), entry.file_size() / 2);
    fs::remove_all(out);
    expect_all_right(out);
}

TEST_F(Slips, cache_of_links_and_rights)
{
    fs::create_directory_symlink("/proc", cache / "builds");
    const Measured run = grade(out);
    EXPECT_EQ(run.signal, 0) << run.printed;
    expect_no_false_zero(out);
    fs::remove(cache / "builds");
    expect_all_right(out);
}

}
}
