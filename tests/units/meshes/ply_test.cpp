#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <locale>
#include <meshes/football.hpp>
#include <meshes/ply/malformed.hpp>
#include <sstream>

#include "../../fuzz/ply_property.hpp"

using namespace umbral;
using namespace umbral::meshes;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// 0 if the file is read.
int problem_of(const std::string& file)
{
    try {
        (void)tests::read(file);
        return 0;
    } catch (const PlyError& error) {
        return static_cast<int>(error.problem());
    }
}

std::vector<fs::path> files_in(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

}

TEST(Ply, course_example)
{
    const PolygonMesh mesh = tests::read(
        "ply\nformat ascii 1.0\ncomment Archivo de ejemplo del formato PLY (8 vertices y 6 caras)\nelement vertex "
        "8\nproperty float x\nproperty float y\n"
        "property float z\nelement face 6\nproperty list uchar int vertex_index\nend_header\n0.0 0.0 0.0\n0.0 0.0 "
        "2.0\n0.0 1.3 1.0\n0.0 1.4 0.0\n1.1 0.0 0.0\n"
        "1.0 0.0 2.0\n1.0 0.8 1.5\n0.5 1.0 0.0\n4 0 1 2 3\n4 7 6 5 4\n4 0 4 5 1\n4 1 5 6 2\n4 2 6 7 3\n4 3 7 4 0\n");
    ASSERT_EQ(mesh.positions.size(), 8U);
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1.3F, 1));
    ASSERT_EQ(mesh.faces.size(), 6U);
    EXPECT_EQ(mesh.faces[4], (std::vector<std::uint32_t>{2, 6, 7, 3}));
    // The two areas of the statement.
    const auto area = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        return length(cross(b - a, c - a)) / 2;
    };
    double fan = 0;
    double other = 0;
    for (const auto& f : mesh.faces) {
        const auto at = [&](std::size_t i) { return glm::dvec3(mesh.positions[f[i]]); };
        fan += area(at(0), at(1), at(2)) + area(at(0), at(2), at(3));
        other += area(at(0), at(1), at(3)) + area(at(1), at(2), at(3));
    }
    EXPECT_NEAR(fan, 9.086904, 1e-6);
    EXPECT_NEAR(other, 9.027515, 1e-6);
    EXPECT_EQ(fan_triangles(mesh).triangles.size(), 12U);
}

// Every problem of the header's list comes from the lists of the exercise, at the line that was changed.
TEST(Ply, malformed_files_are_refused)
{
    std::set<int> seen;
    for (const auto& list : {bad_headers(), bad_data(), bad_binaries()}) {
        for (const Malformed& bad : list) {
            const int problem = problem_of(bad.file);
            EXPECT_NE(problem, 0) << bad.file;
            seen.insert(problem);
        }
    }
    EXPECT_EQ(seen, (std::set<int>{1, 2, 3, 4, 5, 6, 7, 8}));
    try {
        (void)tests::read(changed(good_ascii, "1 0 0", "1 0 zero", "end_header"));
        FAIL();
    } catch (const PlyError& error) {
        EXPECT_EQ(error.place(), 12U);
        EXPECT_STREQ(error.what(), "PLY: line 12: expected a number of the property's type, got 'zero'");
    }
}

TEST(Ply, counts_that_lie_cost_nothing)
{
    const std::vector<Malformed> files = lying_counts();
    for (std::size_t i = 0; i < files.size(); ++i)
        EXPECT_EQ(problem_of(files[i].file) == 0, i + 2 >= files.size()) << i;
}

TEST(Ply, every_dialect_and_every_format_gives_the_mesh_back)
{
    constexpr std::uint64_t seed = 20275;
    Random random(seed);
    for (int i = 0; i < 600; ++i) {
        PolygonMesh mesh = football();
        for (glm::vec3& position : mesh.positions)
            position = random.in_cube() * std::exp2(static_cast<float>(random.below(40)) - 20);
        if (i % 5 == 0) mesh.faces.clear();
        const Dialect dialect = some_dialect(static_cast<PlyFormat>(i % 3), random);
        const std::string file = written_in(dialect, mesh, random);
        ASSERT_TRUE(tests::is_same(tests::read(file), mesh)) << "seed " << seed << ", file " << i;
        ASSERT_TRUE(tests::holds_for(file));
    }
}

// Bytes lost, changed and repeated: never anything but a PlyError or a mesh.
TEST(Ply, damaged_files_are_refused_or_read)
{
    constexpr std::uint64_t seed = 20276;
    Random random(seed);
    for (int i = 0; i < 20'000; ++i) {
        const PolygonMesh mesh{{{0, 0.5F, 1e-40F}, {1, 2, 3}, {4, 5, 6.25F}}, {{0, 1, 2}, {2, 1, 0, 1}}};
        std::string file = written_in(some_dialect(static_cast<PlyFormat>(i % 3), random), mesh, random);
        for (std::uint32_t k = random.below(4); k > 0; --k) {
            const std::size_t at = random.below(static_cast<std::uint32_t>(file.size()));
            const std::uint32_t kind = random.below(4);
            if (kind == 0) file[at] = static_cast<char>(random.bits());
            if (kind == 1) file.erase(at, 1 + random.below(5));
            if (kind == 2) file.insert(at, file.substr(at, 1 + random.below(9)));
            if (kind == 3) file[at] = static_cast<char>(file[at] ^ (1 << random.below(8)));
        }
        ASSERT_NO_THROW((void)tests::holds_for(file)) << "seed " << seed << ", file " << i;
    }
}

TEST(Ply, corpus_of_the_fuzzer)
{
    std::size_t read = 0;
    const std::vector<fs::path> files = files_in(UMBRAL_SOURCE_DIR "/tests/fuzz/corpus/ply");
    for (const fs::path& path : files) ASSERT_NO_THROW(read += tests::holds_for(text_of(path)) ? 1 : 0) << path;
    EXPECT_GT(read, 0U);
    EXPECT_LT(read, files.size());
}

// Real files, where Debian's package assimp-testmodels has put them.
TEST(Ply, models_of_other_programs)
{
    const fs::path folder = "/usr/share/assimp/models";
    if (!fs::exists(folder / "PLY")) GTEST_SKIP() << "the package assimp-testmodels is not installed";
    const auto expect = [&](const char* name, std::size_t vertices, std::size_t faces) {
        const std::string file = text_of(folder / name);
        const PolygonMesh mesh = tests::read(file);
        EXPECT_EQ(mesh.positions.size(), vertices) << name;
        EXPECT_EQ(mesh.faces.size(), faces) << name;
        EXPECT_TRUE(tests::holds_for(file)) << name;
    };
    expect("PLY/cube.ply", 8, 6);
    expect("PLY/cube_binary.ply", 8, 12);
    expect("PLY/cube_uv.ply", 24, 6);
    expect("PLY/float-color.ply", 3, 1);
    expect("PLY/points.ply", 4, 0);
    EXPECT_EQ(problem_of(text_of(folder / "invalid/empty.ply")), static_cast<int>(PlyProblem::not_ply));
    EXPECT_EQ(problem_of(text_of(folder / "PLY/Wuson.ply")), static_cast<int>(PlyProblem::header))
        << "line 3 is a comment that does not say so";
    EXPECT_EQ(problem_of(text_of(folder / "PLY/issue623.ply")), static_cast<int>(PlyProblem::line_length))
        << "declares a list that no line has";
    EXPECT_EQ(problem_of(text_of(folder / "PLY/pond.0.ply")), static_cast<int>(PlyProblem::truncated))
        << "69 bytes are missing";
}
