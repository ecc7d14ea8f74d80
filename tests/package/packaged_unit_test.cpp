#include "worker/packaged_unit.hpp"
#include "manifest/units.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/temporary_folder.hpp"

// What a students' package holds instead of the answers' sources says the same to whoever grades.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;
using namespace umbral::grader;

const fs::path source = UMBRAL_SOURCE;
const fs::path reference = source / "reference";

/// A unit as a students' package holds it, and tools that know no reference.
struct Packaged {
    TemporaryFolder folder;
    Exercise whole;
    Exercise unit;
    Toolchain tools;
    explicit Packaged(const std::string& id) : whole(load_exercise(source / "exercises" / id))
    {
        const fs::path exercise = folder / "exercises" / id;
        fs::create_directories(exercise);
        for (const std::string& file : whole.files) fs::copy_file(whole.folder / file, exercise / file);
        fs::copy_file(whole.folder / "exercise.json", exercise / "exercise.json");
        tools.reference = folder / "reference";
        tools.units = folder / "units";
        write_packaged(reference, whole, tools.units / id);
        fs::rename(tools.units / id / packaged_file, exercise / packaged_file);
        unit = load_exercise(exercise);
    }
};

class PackagedUnit : public testing::TestWithParam<const char*> {};

TEST_P(PackagedUnit, has_the_digest_the_mistakes_and_the_shaders_of_the_whole_one)
{
    const Packaged packaged(GetParam());
    EXPECT_EQ(packaged.unit.digest, packaged.whole.digest);
    const std::vector<KnownSolution> mistakes = known_mistakes(packaged.tools, packaged.unit);
    const std::vector<KnownSolution> expected = mistakes_of(reference, packaged.whole);
    ASSERT_EQ(mistakes.size(), expected.size());
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        EXPECT_EQ(mistakes[i].name, expected[i].name);
        EXPECT_EQ(mistakes[i].what, expected[i].what);
        EXPECT_EQ(mistakes[i].hint, expected[i].hint);
        EXPECT_EQ(mistakes[i].verdict, expected[i].verdict);
        EXPECT_EQ(texts_of(mistakes[i].sources), texts_of(expected[i].sources));
    }
    EXPECT_EQ(reference_shaders(packaged.tools, packaged.unit), texts_of(reference_sources(reference, packaged.whole)));
}

INSTANTIATE_TEST_SUITE_P(Both, PackagedUnit, testing::Values("raytracing/sphere", "lighting/shaders"),
                         [](const auto& test) {
                             return test.param == std::string("raytracing/sphere") ? "cpp" : "glsl";
                         });

TEST(PackagedShaders, are_veiled)
{
    const Packaged packaged("lighting/shaders");
    const std::string bytes = read_text(packaged.tools.units / "lighting/shaders/shaders");
    for (const char* const word : {"phong", "gl_Position", "reference", "mistakes"})
        EXPECT_EQ(bytes.find(word), std::string::npos) << word;
    // No run of text in it at all.
    std::size_t longest = 0;
    std::size_t now = 0;
    for (const char c : bytes) longest = std::max(longest, now = c >= ' ' && c <= '~' ? now + 1 : 0);
    EXPECT_LT(longest, 24U);
}

TEST(PackagedLibraries, are_veiled_and_unveiled_where_they_are_needed)
{
    const TemporaryFolder folder;
    const std::string library =
        "\x7f"
        "ELF gl_Position = projection * place;";
    folder.write("units/raytracing/sphere/reference.so", library);
    folder.write("units/raytracing/sphere/mistakes/far_root.so", library + "!");
    folder.write("units/raytracing/sphere/driver.so", library);
    veil_libraries(folder / "units");
    EXPECT_TRUE(fs::exists(folder / "units/raytracing/sphere/driver.so"));
    EXPECT_FALSE(fs::exists(folder / "units/raytracing/sphere/reference.so"));
    EXPECT_EQ(read_text(folder / "units/raytracing/sphere/reference.veiled").find("gl_Position"), std::string::npos);

    Toolchain tools;
    tools.units = folder / "units";
    const Exercise sphere = load_exercise(source / "exercises/raytracing/sphere");
    EXPECT_EQ(read_text(answer_library(tools, sphere, "reference", folder / "scratch")), library);
    EXPECT_EQ(read_text(answer_library(tools, sphere, "mistakes/far_root", folder / "scratch")), library + "!");
    // A build has its libraries as they are.
    folder.write("units/raytracing/sphere/oracle.so", library);
    EXPECT_EQ(answer_library(tools, sphere, "oracle", folder / "scratch"),
              folder / "units/raytracing/sphere/oracle.so");
}

TEST(PackagedShaders, that_are_damaged_are_named)
{
    const Packaged packaged("lighting/shaders");
    packaged.folder.write("units/lighting/shaders/shaders", "nonsense");
    try {
        (void)reference_shaders(packaged.tools, packaged.unit);
        FAIL() << "nonsense was read";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("lighting/shaders/shaders"), std::string::npos) << error.what();
    }
}

}
}
