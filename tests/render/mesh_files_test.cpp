#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <umbral/meshes/ply.hpp>

#include "scene/limits.hpp"
#include "scene/scene_json.hpp"
#include "support/temporary_folder.hpp"

// Meshes in files of their own, as a scene names them.
namespace umbral::scene::test {
namespace {

using nlohmann::json;
using umbral::test::TemporaryFolder;

/// A scene of this one geometry, called "thing".
std::string scene_with(const json& geometry)
{
    return json{{"format", "umbral-scene"},
                {"version", 1},
                {"camera", {{"eye", {0, 0, 5}}, {"target", {0, 0, 0}}, {"fovy_degrees", 40}, {"near", 1}, {"far", 10}}},
                {"lights", json::array()},
                {"geometries", {{"thing", geometry}}},
                {"instances", json::array()}}
        .dump();
}

/// What a scene has of `text`, a file beside it called `name`.
Triangles mesh_of(const std::string& text, const std::string& name = "thing.obj", bool fit = false)
{
    const TemporaryFolder folder;
    folder.write(name, text);
    folder.write("scene.json", scene_with({{"kind", "mesh"}, {"file", name}, {"fit", fit}}));
    return std::get<Triangles>(read_scene(folder / "scene.json").geometries.at(0).shape);
}

std::string complaint_of(const std::string& text, const std::string& name = "thing.obj", bool fit = false)
{
    try {
        (void)mesh_of(text, name, fit);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

const std::string square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

TEST(MeshFile, of_parsed_text_stays_a_name)
{
    const Scene scene = parse_scene(
        scene_with({{"kind", "mesh"}, {"file", "/nowhere/x.ply"}, {"package", "x-data"}, {"fit", true}}), "s.json");
    const auto& mesh = std::get<MeshFile>(scene.geometries.at(0).shape);
    EXPECT_EQ(mesh.file, "/nowhere/x.ply");
    EXPECT_EQ(mesh.package, "x-data");
    EXPECT_TRUE(mesh.fit);
}

TEST(MeshFile, is_found_from_the_scene_s_folder_and_by_an_absolute_path)
{
    const TemporaryFolder folder;
    folder.write("meshes/square.obj", square + "f 1 2 3 4\n");
    for (const std::string& name : {std::string("../meshes/square.obj"), (folder / "meshes/square.obj").string()}) {
        folder.write("scenes/scene.json", scene_with({{"kind", "mesh"}, {"file", name}}));
        const Scene scene = read_scene(folder / "scenes/scene.json");
        EXPECT_EQ(std::get<Triangles>(scene.geometries.at(0).shape).triangles.size(), 2U) << name;
    }
}

TEST(MeshFile, that_is_missing_is_named_with_the_package_that_has_it)
{
    const TemporaryFolder folder;
    const auto complaint = [&](const json& geometry) {
        folder.write("scene.json", scene_with(geometry));
        try {
            (void)read_scene(folder / "scene.json");
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(complaint({{"kind", "mesh"}, {"file", "/nowhere/x.obj"}, {"package", "x-data"}}),
              (folder / "scene.json").string() +
                  ": geometries.thing.file: expected a file, but there is none at /nowhere/x.obj; it comes with the "
                  "Debian package x-data: apt-get install x-data, got \"/nowhere/x.obj\"");
    EXPECT_NE(complaint({{"kind", "mesh"}, {"file", "x.obj"}}).find((folder / "x.obj").string()), std::string::npos);
    std::filesystem::create_directory(folder / "folder.obj");
    EXPECT_NE(complaint({{"kind", "mesh"}, {"file", "folder.obj"}}).find("expected a regular file"), std::string::npos);
}

TEST(MeshFile, of_obj_has_fans_of_polygons)
{
    const Triangles mesh = mesh_of("# a comment\r\no thing\r\n" + square + "v 0 2 1e0\nvn 0 0 1\n\ns off\nusemtl x\n" +
                                   "f 1//1 2//1 3//1 4//1\nf 4 3 5\n");
    ASSERT_EQ(mesh.positions.size(), 5U);
    EXPECT_EQ(mesh.positions[4], glm::vec3(0, 2, 1));
    EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}, {3, 2, 4}}));
}

TEST(MeshFile, of_obj_may_count_backwards)
{
    const Triangles mesh = mesh_of("v 9 9 9\n" + square + "f -4 -3 -2\nv 5 5 5\nf -1 2 -2\n");
    EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{1, 2, 3}, {5, 1, 4}}));
}

TEST(MeshFile, of_obj_keeps_texture_coordinates_with_indices_of_their_own)
{
    const Triangles mesh =
        mesh_of(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1 0\nvt 0.5\nf 1/4 2/3 3/2 4/1\nf 4/-1 3 1\n");
    ASSERT_EQ(mesh.uvs.size(), 6U);
    EXPECT_EQ(mesh.uvs[1], glm::vec2(1, 0));
    EXPECT_EQ(mesh.uvs[4], glm::vec2(0.5F, 0));
    EXPECT_EQ(mesh.uvs[5], glm::vec2(0)) << "of corners without";
    EXPECT_EQ(mesh.uv_triangles, (std::vector<glm::uvec3>{{3, 2, 1}, {3, 1, 0}, {4, 5, 5}}));
}

TEST(MeshFile, without_texture_coordinates_has_those_of_the_sphere)
{
    const Triangles mesh = mesh_of("v 0 0 3\nv 5 0 0\nv 0 7 0\nv -1 0 0\nf 1 2 3\nf 4 1 3\n");
    ASSERT_EQ(mesh.uv_triangles.size(), 2U);
    const auto uv = [&](std::size_t triangle, int corner) { return mesh.uvs[mesh.uv_triangles[triangle][corner]]; };
    EXPECT_EQ(uv(0, 0), glm::vec2(0, 0.5F));
    EXPECT_EQ(uv(0, 1), glm::vec2(0.25F, 0.5F));
    EXPECT_EQ(uv(0, 2).y, 1);
    EXPECT_EQ(uv(1, 0), glm::vec2(0.75F, 0.5F));
    EXPECT_EQ(uv(1, 1), glm::vec2(1, 0.5F)) << "on from there, not back to 0";
}

TEST(MeshFile, can_be_fitted_into_the_cube)
{
    const Triangles mesh = mesh_of("v 100 200 300\nv 104 200 300\nv 104 202 301\nv 0 0 0\nf 1 2 3\n", "a.obj", true);
    EXPECT_EQ(mesh.positions[0], glm::vec3(-1, -0.5F, -0.25F));
    EXPECT_EQ(mesh.positions[1], glm::vec3(1, -0.5F, -0.25F));
    EXPECT_EQ(mesh.positions[2], glm::vec3(1, 0.5F, 0.25F)) << "by what triangles use";
    EXPECT_NE(complaint_of("v 1 1 1\nf 1 1 1\n", "a.obj", true).find("a mesh with a size"), std::string::npos);
}

TEST(MeshFile, may_be_ply)
{
    const meshes::PolygonMesh pyramid{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5F, 0.5F, 1}},
                                      {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    for (const auto format : {meshes::PlyFormat::ascii, meshes::PlyFormat::little_endian}) {
        const Triangles mesh = mesh_of(meshes::write_ply(pyramid, format), "pyramid.ply");
        EXPECT_EQ(mesh.positions, pyramid.positions);
        EXPECT_EQ(mesh.triangles, meshes::fan_triangles(pyramid).triangles);
        EXPECT_EQ(mesh.uv_triangles.size(), mesh.triangles.size());
    }
    EXPECT_NE(complaint_of("ply\nformat ascii 2.0\n", "a.ply").find("PLY: line 2: expected once 'format ascii 1.0'"),
              std::string::npos);
    meshes::PolygonMesh bad = pyramid;
    bad.positions[2].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(complaint_of(meshes::write_ply(bad, meshes::PlyFormat::ascii), "a.ply").find("vertex 3: expected finite"),
              std::string::npos);
}

struct BadFile {
    std::string obj;
    const char* says;
};

TEST(MeshFile, is_refused_with_the_place_and_both_values)
{
    const std::vector<BadFile> files = {
        {"", "expected a mesh with faces, got none"},
        {square, "expected a mesh with faces, got none"},
        {square + "f 1 2\n", "expected a mesh with faces, got none"},
        {"v nan 0 0\n", "line 1: expected finite numbers after 'v', got 'nan'"},
        {"\r\nv 0 inf 0\n", "line 2: expected finite numbers after 'v', got 'inf'"},
        {"v 0 0\n", "line 1: expected finite numbers after 'v', got ''"},
        {"v 0 0 1e999\n", "line 1: expected finite numbers after 'v', got '1e999'"},
        {"v 0 0 0x1\n", "line 1: expected finite numbers after 'v', got '0x1'"},
        {square + "vt 0 zero\nf 1/1 2/1 3/1\n", "line 5: expected finite numbers after 'vt', got 'zero'"},
        {"v 0 0 1000001\nf 1 1 1\n", "vertex 1: expected finite coordinates of size 1000000 or less, got (0.000000"},
        {square + "vt 0 2000\nf 1/1 2/1 3/1\n", "texture coordinates 1: expected finite coordinates of size 1000"},
        {square + "f 1 2 3\nf 1 2 5\n", "face 2: expected indices of at most 4, the number of positions, got '5'"},
        {square + "f 1 2 3 5\n", "face 1: expected indices of at most 4, the number of positions, got '5'"},
        {square + "f 1 2 0\n",
         "face 1: expected indices from 1 on, or from -1 to minus the number of positions so far, "
         "4, got '0'"},
        {square + "f 1 2 -5\n", "so far, 4, got '-5'"},
        {square + "f 1/1 2/1 3/1\n", "face 1: expected indices of at most 0, the number of texture coordinates"},
        {square + "f 1 2 3.5\n", "line 5: expected corners of a face, as 7, 7/2, 7//3 or 7/2/3, got '3.5'"},
        {square + "f 1 2 4294967297\n", "got '4294967297'"},
        {square + "f 1 2 3/1/1/1\n", "got '3/1/1/1'"},
        {square + "f 1 2 \\\n3\n", "got '\\'"},
    };
    for (const BadFile& file : files) {
        const std::string message = complaint_of(file.obj);
        EXPECT_NE(message.find("scene.json: geometries.thing.file: expected a mesh that can be drawn ("),
                  std::string::npos)
            << message;
        EXPECT_TRUE(message.ends_with("), got \"thing.obj\"")) << message;
        EXPECT_NE(message.find(file.says), std::string::npos) << "'" << file.says << "' is not in: " << message;
    }
}

TEST(MeshFile, has_limits)
{
    const auto times = [](std::size_t count, const std::string& text) {
        std::string all;
        for (std::size_t i = 0; i < count; ++i) all += text;
        return all;
    };
    EXPECT_NE(complaint_of(times(maximum_vertices + 1, "v 0 0 0\n")).find("expected at most 1000000 positions"),
              std::string::npos);
    EXPECT_NE(complaint_of(square + "f" + times(maximum_vertices + 3, " 1") + "\n").find("at most 1000000 triangles"),
              std::string::npos);
    EXPECT_NE(complaint_of(std::string(maximum_mesh_bytes + 1, '\n')).find("at most 134217728 bytes"),
              std::string::npos);

    // Triangles that are drawn count as those of other geometries do.
    const TemporaryFolder folder;
    folder.write("large.obj", square + "f" + times(maximum_vertices + 2, " 1") + "\n");
    json scene = json::parse(scene_with({{"kind", "mesh"}, {"file", "large.obj"}}));
    scene["materials"]["dull"] = json::object();
    for (int i = 0; i < 9; ++i)
        scene["instances"].push_back({{"name", "n" + std::to_string(i)}, {"geometry", "thing"}, {"material", "dull"}});
    folder.write("scene.json", scene.dump());
    try {
        (void)read_scene(folder / "scene.json");
        FAIL() << "nine million triangles were taken";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("instances: expected at most 8388608 triangles in all"),
                  std::string::npos)
            << error.what();
    }
}

}
}
