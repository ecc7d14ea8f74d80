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
    ASSERT_EQ(
        run("accuracy --quick --json --markdown " + out + "/accuracy.md --out " + out + " > " + out + "/printed.json"),
        0);
    const nlohmann::json json = nlohmann::json::parse(text_of(folder.path() / "accuracy.json"));
    EXPECT_EQ(umbral::test::Schema("accuracy").complaints(json), "");
    EXPECT_EQ(nlohmann::json::parse(text_of(folder.path() / "printed.json")), json);
    EXPECT_TRUE(json["quick"]);
    ASSERT_GE(json["knobs"].size(), 23U);
    EXPECT_EQ(json["knobs"][0]["results"].size(), 4U * 6);
    EXPECT_NE(json["machine"]["gl"].get<std::string>().find("llvmpipe"), std::string::npos);
    for (const nlohmann::json& curve : json["knobs"][1]["curves"]) EXPECT_GE(curve["front"].size(), 3U) << curve;
    const std::string page = text_of(folder.path() / "accuracy.html");
    EXPECT_NE(page.find("</html>"), std::string::npos);
    int laws = 0;
    for (const nlohmann::json& knob : json["knobs"]) {
        const std::string id = knob["id"];
        EXPECT_NE(page.find("href=\"#" + id + "\""), std::string::npos) << id;
        EXPECT_NE(page.find("id=\"" + id + "\""), std::string::npos) << id;
        for (const nlohmann::json& law : knob["laws"]) {
            // Errors follow from seeds alone; times do not, and are no matter for a test. Good weights of normals
            // leave so little of the first order that the second is seen.
            if (law["measure"].is_null() || id == "normal-weights") continue;
            ++laws;
            EXPECT_NE(law["verdict"], "differs") << id << ": " << law;
        }
    }
    EXPECT_GE(laws, 30);
    const std::string table = text_of(folder.path() / "accuracy.md");
    EXPECT_NE(table.find("| Samples a pixel |"), std::string::npos) << table;
}

TEST(BenchProgram, measures_one_knob_alone)
{
    const umbral::test::TemporaryFolder folder;
    const std::string out = folder.path().string();
    ASSERT_EQ(run("accuracy ray-sphere --quick --html " + out + "/page.html --out " + out + " > " + out + "/printed"),
              0);
    EXPECT_EQ(nlohmann::json::parse(text_of(folder.path() / "accuracy.json"))["knobs"].size(), 1U);
    EXPECT_NE(text_of(folder.path() / "page.html").find("href=\"#ray-sphere\""), std::string::npos);
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
