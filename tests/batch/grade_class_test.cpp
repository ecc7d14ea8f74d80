#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "batch/grade_class.hpp"
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
    [[nodiscard]] ClassResult grade(const std::string& out, unsigned jobs, std::vector<std::string>* done = nullptr) const
    {
        ClassOptions options;
        options.submissions = bench.folder() / "class";
        options.out = bench.folder() / out;
        options.secret = "secret";
        options.jobs = jobs;
        return grade_class(bench.tools(), exercises, options, [&](const SubmissionResult& one) {
            if (done != nullptr) done->push_back(one.id);
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
    const nlohmann::json first = without_times(to_json(grade("first", 2, &done)));
    const nlohmann::json second = without_times(to_json(grade("second", 1)));
    EXPECT_EQ(first, second) << nlohmann::json::diff(first, second).dump(2);
    std::sort(done.begin(), done.end());
    EXPECT_EQ(done, (std::vector<std::string>{"ada", "bob", "eve", "zoe"}));
    for (const std::string& id : done) {
        const auto read = [&](const char* out) { return without_times(nlohmann::json::parse(read_text(bench.folder() / out / id / "report.json"))); };
        EXPECT_EQ(read("first"), read("second")) << id;
    }
    EXPECT_EQ(without_times(nlohmann::json::parse(read_text(bench.folder() / "first/class.json"))), first);
}

TEST_F(GradeClass, a_hostile_submission_disturbs_no_other)
{
    for (const char* const id : {"good-1", "good-3", "good-5"}) hand_in(id, good_sphere, good_view);
    hand_in("bad-2", sphere_with("", "    volatile float* nowhere = nullptr;\n    *nowhere = 1;"), "#include \"/dev/zero\"\n");
    hand_in("bad-4", sphere_with("", "    std::vector<std::vector<char>> all;\n    for (;;) all.emplace_back(1U << 24U, 'x');"),
            "int x = " + std::string(10000, '(') + ";\n");
    hand_in("bad-6", sphere_with("", "    std::exit(0);"), good_view);
    fs::create_symlink("/", bench.folder() / "class" / "link");
    const ClassResult result = grade("out", 2);
    ASSERT_EQ(result.submissions.size(), 6U);
    for (const SubmissionResult& one : result.submissions) {
        EXPECT_EQ(one.max_score, 20000) << one.id;
        if (one.id.starts_with("good")) {
            EXPECT_EQ(one.score, 20000) << one.id;
        } else {
            EXPECT_EQ(one.units[0].score, 0) << one.id;
        }
        for (const UnitResult& unit : one.units) EXPECT_NE(to_string(unit.verdict), "grader_fault") << one.id << ' ' << unit.message;
    }
}

TEST_F(GradeClass, folders_that_are_no_class_are_told)
{
    EXPECT_THROW((void)submission_ids(bench.folder() / "nowhere"), std::runtime_error);
    fs::create_directories(bench.folder() / "class");
    EXPECT_THROW((void)submission_ids(bench.folder() / "class"), std::runtime_error);
    fs::create_directories(bench.folder() / "class" / "a b");
    EXPECT_THROW((void)submission_ids(bench.folder() / "class"), std::runtime_error);
}

}
}
