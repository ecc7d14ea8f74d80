#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "graded_class.hpp"
#include "program.hpp"
#include "support/remove_at_last.hpp"
#include "support/temporary_folder.hpp"
#include "support/without_times.hpp"

// Whenever grading is killed, nothing is lost, and nobody's grade changes.
namespace umbral::test {
namespace {

/// Starts the same in a process group of its own, and kills the group after a while. Says whether it was alive until
/// then.
bool killed_after(std::chrono::microseconds while_, const std::string& arguments, const std::string& environment)
{
    const pid_t child = fork();
    if (child == 0) {
        setpgid(0, 0);
        const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
        dup2(nothing, STDOUT_FILENO);
        dup2(nothing, STDERR_FILENO);
        const std::string command = environment + " exec " UMBRAL_PROGRAM " " + arguments;
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    setpgid(child, child);
    std::this_thread::sleep_for(while_);
    kill(-child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status);
}

class Resume : public GradedClass {};

TEST_F(Resume, killed_at_any_moment_it_goes_on_and_ends_the_same)
{
    const char* const wanted = std::getenv("UMBRAL_TEST_KILLS");
    const int kills = wanted != nullptr ? std::atoi(wanted) : 6;
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(grade("undisturbed").status, 0);
    const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - start);
    const json expected = class_json(folder / "undisturbed");
    ASSERT_EQ(expected.at("submissions").size(), 4U);

    const unsigned seed = std::random_device{}();
    std::mt19937 random(seed);
    int done = 0;
    int ends = 0;
    for (int run = 0; done < kills; ++run) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", class " + std::to_string(run));
        const std::string out = "out" + std::to_string(run);
        for (bool finished = false; !finished && done < kills;) {
            // Without a cache from earlier every start has to compile: kills meet all that a run does.
            if (random() % 2 == 0) remove_at_last(folder / "cache");
            const std::chrono::microseconds while_(random() % static_cast<unsigned>(whole.count()));
            finished = !killed_after(while_, arguments(out), environment());
            done += finished ? 0 : 1;
            // What a killed run leaves is JSON, and never names somebody's grade who was not graded so.
            if (!fs::exists(folder / out / "class.json")) continue;
            const json left = class_json(folder / out);
            for (const json& one : left.at("submissions")) ASSERT_EQ(one, submission(expected, one.at("id")));
        }
        const Printed last = grade(out);
        ASSERT_EQ(last.status, 0) << last.text;
        const json found = class_json(folder / out);
        ASSERT_EQ(found, expected) << json::diff(found, expected).dump(2);
        for (const char* id : {"ana", "bo", "cy", "dan"})
            for (const char* file : {"report.json", "report.student.json"})
                ASSERT_EQ(without_times(json::parse(read(folder / out / id / file))),
                          without_times(json::parse(read(folder / "undisturbed" / id / file))))
                    << id;
        for (const auto& entry : fs::recursive_directory_iterator(folder / out))
            ASSERT_EQ(entry.path().string().find(".tmp-"), std::string::npos) << entry.path() << " was left";
        const Printed again = grade(out);
        ASSERT_NE(again.text.find("4 units kept, 0 graded"), std::string::npos) << again.text;
        fs::remove_all(folder / out);
        ++ends;
    }
    std::printf("%d kills (seed %u), %d classes graded to the end\n", done, seed, ends);
}

TEST_F(Resume, only_what_changed_is_graded_again_and_other_points_are_told)
{
    ASSERT_EQ(grade("out").status, 0);
    const json before = class_json(folder / "out");
    const auto page = fs::last_write_time(folder / "out/ana/report.html");
    hand_in("cy", read(UMBRAL_SOURCE "/reference/raytracing/sphere.cpp"));
    const Printed second = grade("out");
    EXPECT_NE(second.text.find("3 units kept, 1 graded"), std::string::npos) << second.text;
    EXPECT_NE(second.text.find("cy, raytracing/sphere: 0 of 10 before, 10 of 10 now"), std::string::npos)
        << second.text;
    const json after = class_json(folder / "out");
    EXPECT_EQ(submission(after, "cy").at("score"), 10000);
    for (const char* id : {"ana", "bo", "dan"}) EXPECT_EQ(submission(after, id), submission(before, id));
    EXPECT_EQ(fs::last_write_time(folder / "out/ana/report.html"), page) << "nothing of hers changed";
    const Printed fresh = grade("out", "--fresh");
    EXPECT_EQ(fresh.text.find("units kept"), std::string::npos) << fresh.text;
    EXPECT_EQ(class_json(folder / "out"), after);
}

TEST_F(Resume, one_of_many_leaves_the_others_as_they_are)
{
    ASSERT_EQ(grade("out").status, 0);
    const json before = class_json(folder / "out");
    hand_in("bo", "int nothing;\n");
    hand_in("ana", "int nothing;\n");
    const Printed one = grade("out", "--only bo");
    EXPECT_EQ(one.status, 0) << one.text;
    json after = class_json(folder / "out");
    ASSERT_EQ(after.at("submissions").size(), 4U);
    EXPECT_EQ(submission(after, "bo").at("score"), 0);
    EXPECT_EQ(submission(after, "ana"), submission(before, "ana")) << "not asked for";
    const Printed nobody = grade("out", "--only zoe");
    EXPECT_EQ(nobody.status, 2);
    EXPECT_NE(nobody.text.find("ana, bo, cy, dan"), std::string::npos) << nobody.text;

    folder.write("late/zoe/sphere.cpp", read(UMBRAL_SOURCE "/reference/raytracing/sphere.cpp"));
    const std::string late =
        "grade " + (folder / "late").string() + " --out " + (folder / "out").string() + " --unit sphere --secret-file ";
    EXPECT_EQ(umbral(late + (folder / "secret").string(), environment()).status, 0);
    after = class_json(folder / "out");
    ASSERT_EQ(after.at("submissions").size(), 5U);
    EXPECT_EQ(submission(after, "zoe").at("score"), 10000);
    EXPECT_TRUE(after.at("unfinished").empty());

    // Other hidden inputs do not belong into the same table; --fresh would cost the others theirs.
    folder.write("other", "another secret of more than 16 characters");
    for (const char* more : {"", " --fresh"}) {
        const Printed mixed = umbral(late + (folder / "other").string() + more, environment());
        EXPECT_EQ(mixed.status, 2);
        EXPECT_NE(mixed.text.find("another secret"), std::string::npos) << mixed.text;
    }
    EXPECT_EQ(grade("out", "--attempt 3").status, 2);
    EXPECT_EQ(class_json(folder / "out"), after) << "whoever is refused changes nothing";
    EXPECT_NE(read(folder / "out/class.json").find("\"attempt\": 0"), std::string::npos);
    EXPECT_EQ(read(folder / "out/class.json").find("a secret of more"), std::string::npos);
}

TEST_F(Resume, units_that_are_not_asked_for_stay_in_the_report)
{
    ASSERT_EQ(grade("out", "--unit view-matrix").status, 0);
    const json both = class_json(folder / "out");
    ASSERT_EQ(submission(both, "ana").at("units").size(), 2U);
    hand_in("ana", "int nothing;\n");
    ASSERT_EQ(grade("out").status, 0);  // sphere alone
    const json after = class_json(folder / "out");
    ASSERT_EQ(submission(after, "ana").at("units").size(), 2U);
    EXPECT_EQ(submission(after, "ana").at("units").at(0), submission(both, "ana").at("units").at(0));
    EXPECT_NE(read(folder / "out/ana/report.html").find("id=\"u2\""), std::string::npos);
}

// A roster that swaps two ids, or takes one from a folder of that name: no unit's points go along.
TEST_F(Resume, of_an_id_that_another_folder_got_nothing_is_kept)
{
    ASSERT_EQ(grade("out").status, 0);
    folder.write("roster.csv", "folder,id\nana,bo\nbo,ana\n");
    std::string other_unit = arguments("out", "--roster " + (folder / "roster.csv").string());
    const std::string before = "--unit sphere";
    other_unit.replace(other_unit.find(before), before.size(), "--unit vectors");
    ASSERT_EQ(umbral(other_unit, environment()).status, 0);
    const json all = class_json(folder / "out");
    for (const char* const id : {"ana", "bo"}) EXPECT_EQ(submission(all, id).at("units").size(), 1U) << id;
    EXPECT_EQ(submission(all, "cy").at("units").size(), 2U) << "whose folder is the same";
}

TEST_F(Resume, reports_are_never_written_among_the_submissions)
{
    fs::create_directory_symlink(folder / "class", folder / "link");
    for (const char* out : {"class", "link", "class/ana", "class/out", "link/out", "."}) {
        const Printed refused = grade(out);
        EXPECT_EQ(refused.status, 2) << out << ": " << refused.text;
        EXPECT_NE(refused.text.find(fs::canonical(folder / "class").string()), std::string::npos) << refused.text;
    }
    EXPECT_EQ(read(folder / "class/cy/sphere.cpp"), "this is no C++\n");
    EXPECT_FALSE(fs::exists(folder / "class/out"));
    folder.write("mine/thesis.tex", "years of work");
    const Printed foreign = grade("mine");
    EXPECT_EQ(foreign.status, 2) << foreign.text;
    EXPECT_NE(foreign.text.find("Umbral did not make"), std::string::npos) << foreign.text;
    EXPECT_EQ(folder.count(), 4) << "class, secret, link, mine";
}

TEST_F(Resume, what_else_lies_in_the_folder_of_reports_is_not_touched)
{
    ASSERT_EQ(grade("out").status, 0);
    folder.write("out/notes.txt", "mine");
    folder.write("out/eve/letter.txt", "mine too");
    hand_in("eve", "int x;\n");
    const Printed second = grade("out");
    EXPECT_EQ(second.status, 3) << second.text;
    EXPECT_NE(second.text.find("Umbral did not make this folder"), std::string::npos) << second.text;
    EXPECT_EQ(read(folder / "out/notes.txt"), "mine");
    EXPECT_EQ(read(folder / "out/eve/letter.txt"), "mine too");
    const json after = class_json(folder / "out");
    EXPECT_EQ(after.at("submissions").size(), 4U);
    EXPECT_EQ(after.at("unfinished"), json::array({"eve"}));
    EXPECT_EQ(after.at("faults").at(0).at("units").at(0).at("submission"), "eve");
    for (const auto& entry : fs::recursive_directory_iterator(folder / "out")) {
        if (entry.path().filename() == "notes.txt" || entry.path().string().find("/eve") != std::string::npos) continue;
        struct stat status {};
        ASSERT_EQ(stat(entry.path().c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0077U, 0U) << entry.path() << " can be read by others";
    }
    fs::rename(folder / "out/eve", folder / "moved");
    EXPECT_EQ(grade("out").status, 0) << "as advised";
}

TEST_F(Resume, two_gradings_do_not_share_a_folder)
{
    ASSERT_EQ(grade("out").status, 0);
    const int mark = open((folder / "out/umbral-reports.json").c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(flock(mark, LOCK_EX), 0);
    const Printed refused = grade("out");
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_NE(refused.text.find("another `umbral grade`"), std::string::npos) << refused.text;
    close(mark);
    EXPECT_EQ(grade("out").status, 0);
}

TEST_F(Resume, a_full_disk_is_told_once_and_the_next_run_heals)
{
    ASSERT_EQ(grade("undisturbed").status, 0);
    // No file may grow beyond 8 blocks, 4 or 8 KiB: marks can be written, results cannot. SIGXFSZ is ignored, so that
    // writing fails as on a full disk.
    const Printed full = umbral(arguments("out"), "trap '' XFSZ; ulimit -f 8; " + environment());
    EXPECT_EQ(full.status, 3) << full.text;
    const std::string words = "File too large";
    const std::size_t first = full.text.find(words);
    ASSERT_NE(first, std::string::npos) << full.text;
    EXPECT_EQ(full.text.find(words, first + 1), std::string::npos) << full.text;
    EXPECT_NE(full.text.find("run the same command again"), std::string::npos) << full.text;
    const Printed healed = grade("out");
    EXPECT_EQ(healed.status, 0) << healed.text;
    EXPECT_EQ(class_json(folder / "out"), class_json(folder / "undisturbed"));
}

}
}
