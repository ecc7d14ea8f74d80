#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/schema.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::test {
namespace {

const std::string scene = UMBRAL_SOURCE_DIR "/reference/scenes/first-light.json";

std::string line_of(const Printed& printed) { return printed.text.substr(0, printed.text.find('\n')); }

/// One sentence on one line, and the right status.
void expect_refused(const std::string& arguments, const std::string& says, const std::string& before = "")
{
    const Printed printed = umbral(arguments, before);
    EXPECT_EQ(printed.status, 2) << arguments << "\n" << printed.text;
    EXPECT_NE(printed.text.find(says), std::string::npos) << arguments << "\n" << printed.text;
    EXPECT_EQ(printed.text.size(), line_of(printed).size() + 1) << "more than one line: " << printed.text;
}

TEST(RenderProgram, draws_with_every_renderer)
{
    const TemporaryFolder folder;
    for (const std::string renderer : {"software", "gl", "gl-fixed", "vertices"}) {
        const std::string out = (folder / (renderer + ".png")).string();
        const Printed printed = umbral(scene + " --size 80x60 --renderer " + renderer + " --out " + out);
        EXPECT_EQ(printed.status, 0) << printed.text;
        EXPECT_EQ(printed.text, "");
        EXPECT_TRUE(read(out).starts_with("\x89PNG"));
    }
}

TEST(RenderProgram, takes_an_error_or_a_time_from_those_who_follow_rays)
{
    const std::string rays = scene + " --size 40x30 --renderer raytrace ";
    for (const char* wrong : {"--error 0", "--error -1%", "--error=-1%", "--error abc", "--error 1"})
        expect_refused(rays + wrong, "--error: expected a part of full scale");
    expect_refused(rays + "--time 2", "--time: expected a time");
    expect_refused(rays + "--time 2s --error 1%", "got both");
    expect_refused(rays + "--time 2s --rays 4", "leave out --rays");
    expect_refused(scene + " --error 1%", "expected --renderer raytrace (got software)");
    const Printed printed = umbral(rays + "--error 4%");
    EXPECT_EQ(printed.status, 0);
    for (const char* says : {"Asked: error 4 %", "Pilot: ", "Chosen: ", "Why: ", "Predicted: ", "Measured: "})
        EXPECT_NE(printed.text.find(says), std::string::npos) << says << printed.text;
    const nlohmann::json json = nlohmann::json::parse(umbral(rays + "--error 4% --json").text);
    EXPECT_TRUE(json["budget"]["reached"]);
    EXPECT_LE(json["budget"]["predicted"]["error"], 0.04);
}

TEST(RenderProgram, explains_and_compares)
{
    const Printed explained = umbral(scene + " --size 64x64 --explain");
    EXPECT_EQ(explained.status, 0);
    EXPECT_NE(explained.text.find("yes textured"), std::string::npos) << explained.text;
    EXPECT_NE(explained.text.find("no two_sided"), std::string::npos) << explained.text;
    const Printed fixed = umbral(scene + " --size 64x64 --explain --renderer gl-fixed");
    EXPECT_NE(fixed.text.find("How gl-fixed leaves the others out: "), std::string::npos) << fixed.text;
    EXPECT_NE(fixed.text.find(" 0 instances without culling  (two_sided is not called for)"), std::string::npos);
    const nlohmann::json json = nlohmann::json::parse(umbral(scene + " --size 64x64 --explain --json").text);
    EXPECT_EQ(json["format"], "umbral-render");
    EXPECT_TRUE(json["effects"]["textured"]["called_for"]);
    EXPECT_EQ(json["counters"]["triangles turned"], 0);
}

TEST(RenderProgram, compares_all_renderers)
{
    const Printed compared = umbral(scene + " --size 64x64 --compare");
    EXPECT_EQ(compared.status, 0) << compared.text;
    for (const char* says : {"| First light | software, gl |", "| First light | software, gl-fixed |",
                             "| First light | vertices, gl-fixed |", "software and gl: they agree\n",
                             "vertices and gl-fixed: they agree\n", "light at vertices: "})
        EXPECT_NE(compared.text.find(says), std::string::npos) << says << "\n" << compared.text;

    const TemporaryFolder folder;
    std::filesystem::copy(scene, folder / "b.json");
    nlohmann::json many = nlohmann::json::parse(read(scene));
    many["title"] = "Nine lights";
    for (int i = 0; i < 7; ++i)
        many["lights"].push_back({{"name", "lamp " + std::to_string(i)}, {"towards", {0, 1, i}}});
    folder.write("a.json", many.dump());
    const Printed printed = umbral(folder.path().string() + " --size 64x64 --compare --json");
    EXPECT_EQ(printed.status, 0);
    const nlohmann::json json = nlohmann::json::parse(printed.text);
    EXPECT_EQ(Schema("render-agreement").complaints(json), "");
    EXPECT_TRUE(json["agree"]);
    ASSERT_EQ(json["scenes"].size(), 2U);
    EXPECT_EQ(json["scenes"][0]["pairs"].size(), 2U) << "the fixed function has eight lights";
    EXPECT_NE(json["scenes"][0]["missing"].dump().find("expected at most 8 lights, got 9"), std::string::npos);
    ASSERT_EQ(json["scenes"][1]["pairs"].size(), 5U);
    EXPECT_EQ(json["scenes"][1]["pairs"][0]["pixels"], 64 * 64);
    EXPECT_LT(json["scenes"][1]["pairs"][1]["normal_degrees_mean"], 0.01);
    expect_refused((folder / "a.json").string() + " --renderer gl-fixed --explain", "expected at most 8 lights, got 9");
}

TEST(RenderProgram, writes_buffers)
{
    const TemporaryFolder folder;
    const Printed printed = umbral(scene + " --size 40x30 --buffers " + (folder / "a/b").string());
    EXPECT_EQ(printed.status, 0) << printed.text;
    for (const char* name :
         {"color.npy", "depth.npy", "ids.npy", "coverage.npy", "depth.png", "ids.png", "coverage.png"})
        EXPECT_FALSE(read(folder / "a/b" / name).empty()) << name;
    EXPECT_EQ(read(folder / "a/b/depth.npy").size() % 64, 40U * 30U * 4U % 64U);
}

TEST(RenderProgram, refuses_sizes)
{
    for (const char* size : {"0x0", "1e9", "512", "512x", "x512", "512x0", "-5x5", "5x5x5", "512X512", "9000x10",
                             "99999999999x1", "12.5x3"})
        expect_refused(scene + " --out x.png --size=" + size, "--size: expected WIDTHxHEIGHT");
    expect_refused(scene + " --out x.png --size 8000x8000", "expected at most 33554432 samples");
    expect_refused(scene + " --out x.png --size 4000x4000 --samples 4", "expected at most 33554432 samples");
}

TEST(RenderProgram, refuses_scenes)
{
    const TemporaryFolder folder;
    folder.write("not.json", "{");
    folder.write("unknown.json", R"({"format": "umbral-scene", "version": 1, "fog": 3})");
    expect_refused((folder / "none.json").string() + " --explain", "expected a readable regular file, got nothing");
    expect_refused(folder.path().string() + " --explain", "expected a readable regular file");
    expect_refused((folder / "not.json").string() + " --explain", "expected JSON");
    expect_refused((folder / "unknown.json").string() + " --explain",
                   "unknown.json: fog: expected no field of this name");
}

TEST(RenderProgram, refuses_names_that_are_no_scenes)
{
    const TemporaryFolder folder;
    folder.write("file", "text");
    const std::string hostile = "bell\a \x1b]0;owned\x1b\\ \x1b[2J";
    std::filesystem::create_directories(folder / hostile);
    for (const std::string& name :
         {std::string("no.json"), std::string("."), std::string("file"), std::string(), hostile}) {
        const Printed printed = umbral("'" + name + "'", "cd '" + folder.path().string() + "' &&");
        EXPECT_EQ(printed.status, 2) << name << printed.text;
        EXPECT_FALSE(printed.text.empty()) << name;
        EXPECT_EQ(printed.text.find_first_of("\x1b\a"), std::string::npos) << printed.text;
    }
    EXPECT_EQ(umbral("").status, 2);
}

TEST(RenderProgram, refuses_what_it_cannot_write)
{
    const TemporaryFolder folder;
    expect_refused(scene + " --size 20x20 --out " + (folder / "none/x.png").string(), "x.png");
    expect_refused(scene + " --size 20x20 --out " + folder.path().string(), folder.path().filename().string());
    folder.write("file", "");
    expect_refused(scene + " --size 20x20 --buffers " + (folder / "file/x").string(), "cannot make this folder");
    expect_refused(scene + " --size 20x20 --out /dev/full/x.png", "x.png");
    // As on a full disk: no file may grow beyond a kilobyte.
    expect_refused(scene + " --size 200x200 --out " + (folder / "y.png").string(), "y.png",
                   "ulimit -f 1; trap '' XFSZ;");
    EXPECT_FALSE(std::filesystem::exists(folder / "y.png"));
    const Printed full = umbral(scene + " --explain --size 20x20 2>&1 >/dev/full");
    EXPECT_EQ(full.status, 2) << full.text;
}

TEST(RenderProgram, refuses_options)
{
    expect_refused(scene, "nothing to do");
    expect_refused(scene + " --compare --out x.png", "--compare draws with all");
    for (const char* options : {"--renderer vulkan --explain", "--samples 0 --explain", "--samples 99 --explain",
                                "--kernel none --explain", "--wat", ""}) {
        const Printed printed = umbral((*options == 0 ? "" : scene + " ") + options);
        EXPECT_EQ(printed.status, 2) << options << printed.text;
    }
    EXPECT_EQ(umbral("--help").status, 0);
}

}
}
