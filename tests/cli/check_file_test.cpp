#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "program.hpp"
#include "support/temporary_folder.hpp"

// `umbral check meshes/ply --file FILE`, with the real program: what two readings of one file have in common.
namespace umbral::test {
namespace {

const std::filesystem::path source = UMBRAL_SOURCE;

const std::string header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

class CheckFile : public testing::Test {
protected:
    TemporaryFolder folder;

    /// Hands the reference in, with one text, which it must hold, in place of another.
    void hand_in(const std::string& from = "", const std::string& to = "")
    {
        std::string text = read(source / "reference/meshes/ply.cpp");
        if (!from.empty()) {
            const std::size_t place = text.find(from);
            ASSERT_NE(place, std::string::npos) << from;
            text.replace(place, from.size(), to);
        }
        std::filesystem::create_directories(folder / "meshes/ply");
        folder.write("meshes/ply/ply.cpp", text);
    }

    Printed check(const std::string& bytes)
    {
        folder.write("own.ply", bytes);
        return check_named((folder / "own.ply").string());
    }
    Printed check_named(const std::string& file)
    {
        return umbral("check meshes/ply --dir " + folder.path().string() + " --file " + file);
    }
    static void expect_said(const Printed& printed, const std::string& text)
    {
        EXPECT_NE(printed.text.find(text), std::string::npos) << text << "\nis not in\n" << printed.text;
    }
};

TEST_F(CheckFile, counts_what_both_read)
{
    hand_in();
    const Printed printed = check(header + "0 0 0\n1 0 0\n0 0.1 nan\n3 0 1 2\n");
    EXPECT_EQ(printed.status, 0) << printed.text;
    expect_said(printed, "Your reading is the reference's.");
    expect_said(printed, "read, both");
    expect_said(printed, "vertices      3, both");
    expect_said(printed, "corners       3, both");
}

TEST_F(CheckFile, the_first_row_that_differs_is_shown)
{
    hand_in("PolygonMesh read_ply(std::span<const std::byte> bytes)",
            "static PolygonMesh read_rightly(std::span<const std::byte> bytes);\n"
            "PolygonMesh read_ply(std::span<const std::byte> bytes)\n{\n    PolygonMesh mesh = read_rightly(bytes);\n"
            "    if (mesh.positions.size() > 1) mesh.positions[1].y = 7;\n    return mesh;\n}\n"
            "static PolygonMesh read_rightly(std::span<const std::byte> bytes)");
    const Printed printed = check(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_EQ(printed.status, 1) << printed.text;
    expect_said(printed, "row 1: yours (1, 7, 0), expected (1, 0, 0)");
    expect_said(printed, "Your reading is not the reference's.");
}

TEST_F(CheckFile, what_is_no_ply_is_refused_by_both_with_their_reasons)
{
    hand_in();
    for (const std::string& bytes : {std::string(), std::string("solid cube\n"), std::string("\0\xff\x1b[2J", 7)}) {
        const Printed printed = check(bytes);
        EXPECT_EQ(printed.status, 0) << printed.text;
        expect_said(printed, "refused, not_ply, both");
        EXPECT_EQ(printed.text.find('\x1b'), std::string::npos) << "escapes reach the terminal";
    }
    expect_said(check(header + "0 0 0\n"), "refused, truncated, both");
}

TEST_F(CheckFile, a_count_that_lies_ends_the_run_of_who_believes_it_and_nothing_else)
{
    hand_in("PolygonMesh read_ply(std::span<const std::byte> bytes)\n{",
            "PolygonMesh read_ply(std::span<const std::byte> bytes)\n{\n    std::vector<std::byte> all;\n"
            "    if (bytes.size() > 200) all.resize(std::size_t{1} << 40U);\n");
    const Printed printed = check(header + std::string(200, '0'));
    EXPECT_EQ(printed.status, 1) << printed.text;
    expect_said(printed, "Your reading is not the reference's.");
}

TEST_F(CheckFile, refuses_what_it_should_not_read)
{
    hand_in();
    EXPECT_EQ(check_named("/dev/zero").status, 2);
    EXPECT_EQ(check_named(folder.path().string()).status, 2);
    EXPECT_EQ(check_named((folder / "missing.ply").string()).status, 2);
    const std::string pipe = (folder / "pipe.ply").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(check_named(pipe).status, 2) << "nothing is waited for";
    std::ofstream(folder / "large.ply").close();
    std::filesystem::resize_file(folder / "large.ply", (std::uintmax_t{16} << 20U) + 1);
    const Printed large = check_named((folder / "large.ply").string());
    EXPECT_EQ(large.status, 2);
    expect_said(large, "16384 KiB");
}

TEST_F(CheckFile, a_unit_that_reads_no_files_says_so)
{
    hand_in();
    std::filesystem::create_directories(folder / "raytracing/sphere");
    std::filesystem::copy_file(source / "reference/raytracing/sphere.cpp", folder / "raytracing/sphere/sphere.cpp");
    folder.write("own.ply", header);
    const std::string rest = " --dir " + folder.path().string() + " --file " + (folder / "own.ply").string();
    const Printed printed = umbral("check sphere" + rest);
    EXPECT_EQ(printed.status, 2);
    expect_said(printed, "reads no files");
    EXPECT_EQ(umbral("check" + rest).status, 2) << "which unit?";
    EXPECT_EQ(umbral("check meshes/ply --json" + rest).status, 2);
}

}
}
