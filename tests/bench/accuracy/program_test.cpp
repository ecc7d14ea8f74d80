#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <support/schema.hpp>
#include <support/temporary_folder.hpp>

// umbral-bench-accuracy itself, as `umbral bench` starts it.
namespace umbral::bench {
namespace {

int run(const std::string& arguments)
{
    const int status = std::system((std::string(UMBRAL_BENCH_ACCURACY) + " " + arguments + " 2>/dev/null").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string text_of(const std::filesystem::path& path)
{
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(BenchProgram, measures_and_writes_what_the_schema_says)
{
    const umbral::test::TemporaryFolder folder;
    const std::string out = folder.path().string();
    ASSERT_EQ(run("accuracy --quick --json --out " + out + " > " + out + "/printed.json"), 0);
    const nlohmann::json json = nlohmann::json::parse(text_of(folder.path() / "accuracy.json"));
    EXPECT_EQ(umbral::test::Schema("accuracy").complaints(json), "");
    EXPECT_EQ(nlohmann::json::parse(text_of(folder.path() / "printed.json")), json);
    EXPECT_TRUE(json["quick"]);
    ASSERT_EQ(json["knobs"].size(), 2U);
    EXPECT_EQ(json["knobs"][0]["results"].size(), 4U * 6);
    EXPECT_NE(json["machine"]["gl"].get<std::string>().find("llvmpipe"), std::string::npos);
    for (const nlohmann::json& curve : json["knobs"][1]["curves"]) EXPECT_GE(curve["front"].size(), 3U) << curve;
    EXPECT_NE(text_of(folder.path() / "accuracy.html").find("</html>"), std::string::npos);
}

TEST(BenchProgram, measures_one_knob_alone)
{
    const umbral::test::TemporaryFolder folder;
    const std::string out = folder.path().string();
    ASSERT_EQ(run("accuracy --quick --knob ray-sphere --out " + out + " > " + out + "/printed"), 0);
    EXPECT_EQ(nlohmann::json::parse(text_of(folder.path() / "accuracy.json"))["knobs"].size(), 1U);
    EXPECT_NE(text_of(folder.path() / "printed").find("school, float"), std::string::npos);
}

TEST(BenchProgram, tells_what_cannot_be_done)
{
    EXPECT_EQ(run("accuracy --knob nonsense > /dev/null"), 2);
    EXPECT_EQ(run("speed > /dev/null"), 2);
    EXPECT_EQ(run("accuracy --quick --knob ray-sphere --units /nowhere > /dev/null"), 3);
    EXPECT_EQ(run("accuracy --quick --knob ray-sphere --out /proc/nowhere > /dev/null"), 3);
    EXPECT_EQ(run("accuracy --help > /dev/null"), 0);
}

}
}
