#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "class/grade_class.hpp"
#include "model/faults.hpp"
#include "store/refused_folder.hpp"
#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

/// The same without times.
nlohmann::json without_times(nlohmann::json json)
{
    if (json.is_object()) {
        json.erase("seconds");
        json.erase("reference_seconds");
    }
    for (auto& below : json)
        if (below.is_structured()) below = without_times(below);
    return json;
}

class GradeClass : public testing::Test {
protected:
    Workbench bench;
    std::vector<Exercise> exercises{bench.exercise("raytracing/sphere"), bench.exercise("projections/view-matrix")};
    std::string good_sphere = project_file("reference/raytracing/sphere.cpp");
    std::string good_view = project_file("reference/projections/view_matrix.cpp");

    void hand_in(const std::string& id, const std::string& sphere, const std::string& view) const
    {
        bench.write("class/" + id + "/sphere.cpp", sphere);
        bench.write("class/" + id + "/projections/view-matrix/view_matrix.cpp", view);
    }
    [[nodiscard]] ClassGrading grade(const std::string& out, unsigned jobs,
                                     std::vector<std::string>* done = nullptr) const
    {
        ClassOptions options;
        options.submissions = bench.folder() / "class";
        options.out = bench.folder() / out;
        options.secret = "secret";
        options.jobs = jobs;
        return grade_class(bench.tools(), exercises, options, [&](const ClassProgress& now) {
            if (done != nullptr && !now.finished.empty()) done->push_back(now.finished);
        });
    }
};

TEST_F(GradeClass, twice_gives_the_same_but_for_times)
{
    hand_in("ada", good_sphere, good_view);
    hand_in("bob", sphere_with("", ""), good_view);
    hand_in("eve", "nonsense\n", good_view);
    bench.write("class/zoe/README.txt", "nothing handed in");
    std::vector<std::string> done;
    const nlohmann::json first = without_times(to_json(grade("first", 2, &done).result));
    const nlohmann::json second = without_times(to_json(grade("second", 1).result));
    EXPECT_EQ(first, second) << nlohmann::json::diff(first, second).dump(2);
    std::sort(done.begin(), done.end());
    EXPECT_EQ(done, (std::vector<std::string>{"ada", "bob", "eve", "zoe"}));
    for (const std::string& id : done) {
        const auto read = [&](const char* out) {
            return without_times(nlohmann::json::parse(read_text(bench.folder() / out / id / "report.json")));
        };
        EXPECT_EQ(read("first"), read("second")) << id;
    }
    EXPECT_EQ(without_times(nlohmann::json::parse(read_text(bench.folder() / "first/class.json"))), first);
}

TEST_F(GradeClass, a_hostile_submission_disturbs_no_other)
{
    for (const char* const id : {"good-1", "good-3", "good-5"}) hand_in(id, good_sphere, good_view);
    hand_in("bad-2", sphere_with("", "    volatile float* nowhere = nullptr;\n    *nowhere = 1;"),
            "#include \"/dev/zero\"\n");
    hand_in("bad-4",
            sphere_with("", "    std::vector<std::vector<char>> all;\n    for (;;) all.emplace_back(1U << 24U, 'x');"),
            "int x = " + std::string(10000, '(') + ";\n");
    hand_in("bad-6", sphere_with("", "    std::exit(0);"), good_view);
    fs::create_symlink("/", bench.folder() / "class" / "link");
    const ClassResult result = grade("out", 2).result;
    ASSERT_EQ(result.submissions.size(), 6U);
    for (const SubmissionResult& one : result.submissions) {
        EXPECT_EQ(one.max_score, 20000) << one.id;
        if (one.id.starts_with("good")) {
            EXPECT_EQ(one.score, 20000) << one.id;
        } else {
            EXPECT_EQ(one.units[0].score, 0) << one.id;
        }
        for (const UnitResult& unit : one.units)
            EXPECT_NE(to_string(unit.verdict), "grader_fault") << one.id << ' ' << unit.message;
    }
}

/// The path of a program of the toolchain, replaced by one that does not work.
class Broken {
public:
    Broken(Workbench& bench, Toolchain tools) : folder_(bench.folder() / "programs"), tools_(std::move(tools))
    {
        fs::create_directories(folder_);
        for (const auto& entry : fs::directory_iterator(tools_.programs))
            if (entry.path().filename().string().starts_with("umbral") || entry.path().filename() == "assembler")
                fs::create_symlink(entry.path(), folder_ / entry.path().filename());
        tools_.programs = folder_;
    }
    [[nodiscard]] const Toolchain& tools() const { return tools_; }
    void replace_spawner(const std::string& text) const
    {
        fs::remove(folder_ / "umbral-spawner");
        std::ofstream(folder_ / "umbral-spawner") << text;
        fs::permissions(folder_ / "umbral-spawner", fs::perms::owner_all);
    }

private:
    fs::path folder_;
    Toolchain tools_;
};

TEST_F(GradeClass, a_fault_is_retried_alone_and_then_told)
{
    hand_in("ana", good_sphere, good_view);
    hand_in("bo", sphere_with("", ""), good_view);
    Broken broken(bench, bench.tools());
    // The first starts of the spawner of sphere fail, one for each submission, as where the machine is out of
    // processes; later ones work.
    const std::string real = (bench.tools().programs / "umbral-spawner").string();
    const std::string count = (bench.folder() / "count").string();
    broken.replace_spawner("#!/bin/sh\necho >>" + count + "\n[ $(wc -l <" + count + ") -gt 2 ] || exit 1\nexec " +
                           real + "\n");
    ClassOptions options;
    options.submissions = bench.folder() / "class";
    options.out = bench.folder() / "out";
    options.secret = "secret";
    options.fingerprint = Fingerprint{};
    std::vector<std::string> again;
    const ClassGrading healed = grade_class(broken.tools(), exercises, options, [&](const ClassProgress& now) {
        if (now.again && !now.finished.empty()) again.push_back(now.finished);
    });
    EXPECT_EQ(again, (std::vector<std::string>{"ana", "bo"}));
    EXPECT_TRUE(faults(healed.result).empty());
    ASSERT_EQ(healed.result.submissions.size(), 2U);
    EXPECT_EQ(healed.result.submissions[0].score, 20000);

    broken.replace_spawner("#!/bin/sh\nexit 1\n");
    options.fresh = true;
    const ClassGrading broken_for_good = grade_class(broken.tools(), exercises, options, [](const ClassProgress&) {});
    const std::vector<Fault> told = faults(broken_for_good.result);
    ASSERT_EQ(told.size(), 1U) << "the same cause once";
    EXPECT_EQ(told[0].places.size(), 2U);
    EXPECT_EQ(told[0].points, 20000);
    for (const SubmissionResult& one : broken_for_good.result.submissions)
        EXPECT_EQ(one.max_score, 10000) << "nobody's zero";
    EXPECT_TRUE(broken_for_good.written);

    // The next run asks for what failed, and for nothing else.
    options.fresh = false;
    const ClassGrading after = grade_class(bench.tools(), exercises, options, [](const ClassProgress&) {});
    EXPECT_TRUE(faults(after.result).empty());
    EXPECT_GE(after.units_graded, 2U);
    EXPECT_EQ(after.result.submissions[0].score, 20000);
}

TEST_F(GradeClass, a_submission_that_cannot_be_read_costs_nobody_else)
{
    hand_in("ana", good_sphere, good_view);
    fs::create_directories(bench.folder() / "class/loop");
    fs::create_directory_symlink("raytracing", bench.folder() / "class/loop/raytracing");
    fs::create_symlink("sphere.cpp", bench.folder() / "class/loop/sphere.cpp");
    hand_in("locked", good_sphere, good_view);
    fs::permissions(bench.folder() / "class/locked", fs::perms::none);
    bench.write("class/class.json/sphere.cpp", good_sphere);
    bench.write("class/index.html/sphere.cpp", good_sphere);
    const ClassResult result = grade("out", 2).result;
    fs::permissions(bench.folder() / "class/locked", fs::perms::owner_all);
    ASSERT_EQ(result.submissions.size(), 5U);
    for (const SubmissionResult& one : result.submissions) {
        EXPECT_EQ(one.max_score, 20000) << one.id;
        if (one.id == "ana") {
            EXPECT_EQ(one.score, 20000);
        } else if (one.id == "loop") {
            EXPECT_EQ(to_string(one.units[0].verdict), "missing") << one.units[0].message;
        }
    }
    EXPECT_TRUE(fs::is_regular_file(bench.folder() / "out/class.json"));
    EXPECT_TRUE(fs::is_regular_file(bench.folder() / "out/index.html"));
}

TEST_F(GradeClass, folders_that_are_no_class_are_told)
{
    EXPECT_THROW((void)grade("out", 1), RefusedFolder);
    fs::create_directories(bench.folder() / "class");
    EXPECT_THROW((void)grade("out", 1), RefusedFolder);
    fs::create_directories(bench.folder() / "class" / "José Pérez");
    const ClassResult result = grade("out", 1).result;
    ASSERT_EQ(result.submissions.size(), 1U);
    EXPECT_EQ(result.submissions[0].folder, "José Pérez");
}

TEST(Progress, says_how_far_how_fast_and_how_long)
{
    ClassProgress now{
        .submissions_done = 12, .submissions = 200, .units_graded = 310, .units_to_grade = 1054, .seconds = 100};
    EXPECT_EQ(progress_text(now), "12/200 submissions, 3.1 units/s, about 4 min left");
    now.units_to_grade = 330;
    EXPECT_EQ(progress_text(now), "12/200 submissions, 3.1 units/s, about 10 s left");
    now.units_to_grade = 310;
    EXPECT_EQ(progress_text(now), "12/200 submissions, 3.1 units/s");
    now = {.submissions_done = 0, .submissions = 1, .units_graded = 4, .units_to_grade = 400, .seconds = 100};
    EXPECT_EQ(progress_text(now), "0/1 submission, 2.4 units/min, about 2 h 50 min left");
    now.units_graded = 1;
    EXPECT_EQ(progress_text(now), "0/1 submission");
    EXPECT_EQ(progress_text({}), "0/0 submissions");
}

}
}
