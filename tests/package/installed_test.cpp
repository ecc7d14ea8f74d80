#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "installation.hpp"
#include "support/without_times.hpp"

// Everything that people do with an installation, where neither sources nor build are: the same results as in the
// checkout.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path sample = UMBRAL_SOURCE "/tests/class";

/// The installed program, with a cache of the tests' own.
std::string installed(const Installation& installation, const TemporaryFolder& folder)
{
    return without_sources() + "env UMBRAL_CACHE=" + (folder / "cache").string() + " " +
           (installation.prefix() / "bin/umbral").string() + " ";
}

/// The sample class's submission, in a workspace that students' program made.
void hand_in(const TemporaryFolder& folder, const std::string& submission)
{
    fs::copy(sample / submission, folder / "work", fs::copy_options::recursive | fs::copy_options::overwrite_existing);
}

class StudentsPackage : public testing::Test {
protected:
    TemporaryFolder folder_;
    std::string umbral_ = installed(students(), folder_);
    void SetUp() override
    {
        const Printed made = run(umbral_ + "new " + (folder_ / "work").string() + " sphere view-matrix shaders");
        ASSERT_EQ(made.status, 0) << made.text;
        ASSERT_TRUE(fs::exists(folder_ / "work/raytracing/sphere/goal.png"));
    }
    [[nodiscard]] Printed check(const std::string& options = "") const
    {
        return run(umbral_ + "check sphere view-matrix shaders --dir " + (folder_ / "work").string() + " " + options);
    }
};

TEST_F(StudentsPackage, says_of_right_work_that_it_is_right)
{
    hand_in(folder_, "ana-all-right");
    const Printed checked = check();
    EXPECT_EQ(checked.status, 0) << checked.text;
    // The precompiled header was made by `new`, once.
    EXPECT_EQ(checked.text.find("preparing"), std::string::npos) << checked.text;
}

TEST_F(StudentsPackage, explains_wrong_work_as_the_checkout_does)
{
    hand_in(folder_, "carla-typical-mistakes");
    const Printed checked = check("--json");
    EXPECT_EQ(checked.status, 1) << checked.text;
    const Printed in_checkout = run(with_sources() + "env UMBRAL_CACHE=" + (folder_ / "other-cache").string() +
                                    " " UMBRAL_BUILD "/bin/umbral check sphere view-matrix shaders --json --dir " +
                                    (folder_ / "work").string());
    const json here = json::parse(checked.text);
    EXPECT_EQ(without_times(here), without_times(json::parse(in_checkout.text)));
    // By the hints that somebody wrote, the one in GLSL too.
    std::size_t explained = 0;
    for (const json& unit : here.at("submission").at("units")) explained += unit.at("explanation").is_null() ? 0 : 1;
    EXPECT_GE(explained, 2U) << checked.text;
}

TEST_F(StudentsPackage, says_what_else_to_install)
{
    for (const char* const command :
         {"validate sphere", "render scene.json", "bench accuracy", "demo", "doctor --attack"}) {
        const Printed refused = run(umbral_ + command);
        EXPECT_EQ(refused.status, 2) << command << refused.text;
        EXPECT_NE(refused.text.find("umbral-instructor"), std::string::npos) << command << refused.text;
    }
}

// Not by a package, then, which says the same again.
TEST_F(StudentsPackage, says_what_needs_the_sources)
{
    for (const char* const command : {"new-unit raytracing/torus", "locate sphere"}) {
        const Printed refused = run(umbral_ + command);
        EXPECT_EQ(refused.status, 2) << command << refused.text;
        EXPECT_NE(refused.text.find("in a checkout"), std::string::npos) << command << refused.text;
        EXPECT_EQ(refused.text.find("umbral-instructor"), std::string::npos) << command << refused.text;
    }
}

// What is built from the tests, or from sources that no package holds, is measured in the checkout.
TEST(InstructorsPackage, says_what_is_measured_in_the_checkout_only)
{
    const TemporaryFolder folder;
    const std::string umbral = installed(everything(), folder);
    for (const char* const name : {"run", "raster", "fuzz"}) {
        const Printed refused = run(umbral + "bench " + name);
        EXPECT_EQ(refused.status, 2) << name << refused.text;
        EXPECT_NE(refused.text.find("needs the checkout"), std::string::npos) << name << refused.text;
    }
    const Printed quick =
        run("cd " + folder.path().string() + " && " + umbral + "bench accuracy --quick --knob ray-sphere");
    EXPECT_EQ(quick.status, 0) << quick.text;
}

TEST(InstructorsPackage, grades_the_sample_class_as_the_checkout_does)
{
    const TemporaryFolder folder;
    folder.write("secret", "the same secret gives the same hidden cases");
    // All ten, twice, take two minutes: `./umbral test --all`.
    const bool all = std::getenv("UMBRAL_TEST_ALL") != nullptr;
    const std::string only = all ? "" : " --only ana-all-right --only carla-typical-mistakes";
    const auto class_json = [&](const std::string& umbral, const std::string& submissions, const std::string& out) {
        const Printed graded = run(umbral + "grade --handed-in --jobs 2 --secret-file " + (folder / "secret").string() +
                                   only + " --out " + (folder / out).string() + " " + submissions);
        EXPECT_EQ(graded.status, 0) << graded.text;
        return without_times(json::parse(read(folder / out / "class.json")));
    };
    const json here =
        class_json(installed(everything(), folder), (everything().prefix() / "share/umbral/class").string(), "here");
    const json there = class_json(
        with_sources() + "env UMBRAL_CACHE=" + (folder / "other-cache").string() + " " UMBRAL_BUILD "/bin/umbral ",
        sample.string(), "there");
    EXPECT_EQ(here, there);
    EXPECT_EQ(here.at("submissions").size(), all ? 10U : 2U);
}

TEST(InstructorsPackage, validates_a_unit_and_draws_a_scene)
{
    const TemporaryFolder folder;
    const std::string umbral = installed(everything(), folder);
    for (const char* const command : {"validate --quiet --seeds 1 sphere shaders", "doctor"}) {
        const Printed printed = run(umbral + command);
        EXPECT_EQ(printed.status, 0) << command << printed.text;
    }
    const Printed drawn =
        run(umbral + "render " + (everything().prefix() / "share/umbral/reference/scenes/first-light.json").string() +
            " --size 64x64 --out " + (folder / "picture.png").string());
    EXPECT_EQ(drawn.status, 0) << drawn.text;
    EXPECT_TRUE(fs::exists(folder / "picture.png"));
}

TEST(Package, holds_no_path_of_the_build)
{
    std::size_t seen = 0;
    for (const fs::path& file : files_below(everything().prefix())) {
        const std::string text = read(file);
        ++seen;
        for (const char* const path : {UMBRAL_SOURCE, UMBRAL_BUILD})
            EXPECT_EQ(text.find(path), std::string::npos) << file << " holds " << path;
    }
    EXPECT_GT(seen, 1000U);
}

}
}
