#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <umbral/core/png.hpp>

#include "support/all_tests.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Small pictures: what is asked here does not depend on their size, and the program draws eight hundred of them.
json drawn(const fs::path& folder, const std::string& more = "")
{
    const std::string command =
        std::string("'" UMBRAL_BENCH_SCENES "' '") + folder.string() + "' --size 64 " + more + " > /dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::ifstream file(folder / "pictures.json");
    return json::parse(file);
}

class BenchScenesProgram : public testing::Test {
protected:
    static void SetUpTestSuite()
    {
        folder_ = new TemporaryFolder;
        document_ = new json(drawn(folder_->path() / "a"));
    }
    static void TearDownTestSuite()
    {
        delete document_;
        delete folder_;
    }
    static const json& document() { return *document_; }
    static fs::path file(const json& name) { return folder_->path() / "a" / name.get<std::string>(); }

    static inline TemporaryFolder* folder_ = nullptr;
    static inline json* document_ = nullptr;
};

TEST_F(BenchScenesProgram, has_enough_scenes_and_operators)
{
    EXPECT_EQ(document()["format"], 1);
    EXPECT_FALSE(document()["gl"].get<std::string>().empty());
    EXPECT_GE(document()["scenes"].size(), 26U);
    std::map<bool, std::set<std::string>> operators;
    std::size_t noisy = 0;
    for (const json& scene : document()["scenes"]) {
        noisy += scene["noise"].get<bool>() ? 1 : 0;
        EXPECT_FALSE(scene["about"].get<std::string>().empty());
        std::map<bool, std::set<std::string>> here;
        for (const json& variant : scene["variants"]) {
            EXPECT_TRUE(here[variant["harmful"]].insert(variant["operator"]).second)
                << scene["name"] << ": " << variant["operator"] << " comes twice";
            EXPECT_FALSE(variant["about"].get<std::string>().empty());
            operators[variant["harmful"]].insert(variant["operator"]);
        }
        EXPECT_GE(here[true].size(), 8U) << scene["name"];
        EXPECT_GE(here[false].size(), 3U) << scene["name"];
    }
    EXPECT_GE(operators[true].size(), 34U);
    EXPECT_GE(operators[false].size(), 8U);
    EXPECT_GE(noisy, 3U);
}

// A harmful variant that equals the expected picture says so, and says it only then; the same holds for harmless ones.
TEST_F(BenchScenesProgram, pictures_have_one_size_and_differ_as_they_say)
{
    for (const json& scene : document()["scenes"]) {
        const Image expected = read_png(file(scene["expected"]));
        for (const json& variant : scene["variants"]) {
            const Image image = read_png(file(variant["file"]));
            EXPECT_EQ(image.width, expected.width) << variant["file"];
            EXPECT_EQ(image.height, expected.height) << variant["file"];
            EXPECT_EQ(image.cells == expected.cells, variant.value("equal", false)) << variant["file"];
        }
    }
}

TEST_F(BenchScenesProgram, draws_the_same_bytes_again)
{
    if (!tests_all()) GTEST_SKIP() << "set UMBRAL_TEST_ALL: NOTHING WAS DRAWN A SECOND TIME";
    const json again = drawn(folder_->path() / "b");
    EXPECT_EQ(again, document());
    for (const json& scene : document()["scenes"])
        for (const json& variant : scene["variants"]) {
            const std::string name = variant["file"];
            EXPECT_EQ(read_png(file(name)).cells, read_png(folder_->path() / "b" / name).cells) << name;
        }
}

}
}
