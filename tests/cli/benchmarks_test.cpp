#include "cli/authors/benchmarks.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <set>

#include "cli/checkout.hpp"
#include "support/printed.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

TEST(Benchmarks, have_names_of_their_own_and_programs)
{
    std::set<std::string> names;
    for (const Benchmark& one : benchmarks()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        EXPECT_EQ(find_benchmark(one.name), &one);
        EXPECT_EQ(one.program.empty(), one.home == BenchmarkHome::command) << one.name;
        EXPECT_NE(list_of_benchmarks().find("  " + one.name + " "), std::string::npos);
        EXPECT_TRUE(one.has_help || help_of(one).find("--quick") != std::string::npos) << one.name;
    }
    EXPECT_EQ(find_benchmark("nothing"), nullptr);
}

/// A checkout whose build is a folder with a cache, and a cmake that only notes how it was called, and fails if told to
/// configure tests where `broken` exists.
class Checkout : public testing::Test {
protected:
    void SetUp() override
    {
        folder_.write("bin/cmake", "#!/bin/sh\necho \"$*\" >>'" + (folder_ / "calls").string() +
                                       "'\ncase \"$*\" in *TESTING=ON) [ ! -e '" + (folder_ / "broken").string() +
                                       "' ] || { echo 'CMake Error: no GTest'; exit 1; };; esac\n");
        fs::permissions(folder_ / "bin/cmake", fs::perms::owner_all);
        path_ = getenv("PATH");
        setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
        application_.layout.build = folder_.path();
        application_.layout.data = "/sources";
        application_.tools.programs = folder_ / "bin";
    }
    void TearDown() override { setenv("PATH", path_.c_str(), 1); }

    void configured_with_tests(bool tests) const
    {
        folder_.write("CMakeCache.txt", std::string("A:BOOL=ON\nBUILD_TESTING:BOOL=") + (tests ? "ON\n" : "OFF\n"));
    }
    [[nodiscard]] std::string calls() const { return test::read(folder_ / "calls"); }
    [[nodiscard]] std::string here() const { return folder_.path().string(); }

    test::TemporaryFolder folder_;
    Application application_;
    std::string path_;
};

TEST_F(Checkout, builds_what_is_measured)
{
    configured_with_tests(true);
    EXPECT_EQ(have_fresh_program(application_, "bench-run", true), folder_ / "bin/bench-run");
    EXPECT_EQ(calls(), "--build " + here() + " --target bench-run\n");
}

TEST_F(Checkout, configures_tests_only_for_their_own_programs)
{
    configured_with_tests(false);
    (void)have_fresh_program(application_, "bench-raster", false);
    EXPECT_EQ(calls(), "--build " + here() + " --target bench-raster\n");
    (void)have_fresh_program(application_, "bench-run", true);
    EXPECT_EQ(calls(), "--build " + here() + " --target bench-raster\n-S /sources -B " + here() +
                           " -DBUILD_TESTING=ON\n--build " + here() + " --target bench-run\n");
}

TEST_F(Checkout, is_left_as_it_was_where_tests_cannot_be_configured)
{
    configured_with_tests(false);
    folder_.write("broken", "");
    try {
        (void)have_fresh_program(application_, "bench-run", true);
        FAIL() << "it was built";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("debian-packages-test.txt"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("no GTest"), std::string::npos) << error.what();
    }
    EXPECT_EQ(calls(),
              "-S /sources -B " + here() + " -DBUILD_TESTING=ON\n-S /sources -B " + here() + " -DBUILD_TESTING=OFF\n");
}

}
}
