#pragma once

#include <array>
#include <limits>
#include <string>
#include <umbral/meshes/ply_types.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// Files that must be read: one that is as usual as can be, and others that are right all the same.
namespace umbral::meshes {

inline const std::string good_ascii =
    "ply\nformat ascii 1.0\ncomment four corners\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0.5\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n";

/// What stands in it.
inline const PolygonMesh four_corners{{{0, 0, 0.5F}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}};

/// The text with a piece of it replaced; the first such piece after `after`.
inline std::string changed(const std::string& text, const std::string& piece, const std::string& by,
                           const std::string& after = "")
{
    const std::size_t from = text.find(piece, text.find(after));
    if (from == std::string::npos) throw std::logic_error("changed: there is no '" + piece + "'");
    return std::string(text).replace(from, piece.size(), by);
}

/// The lowest and the highest number of an integer type, moved outwards by so many.
inline std::string limit_of(PlyType type, bool highest, int outwards = 0)
{
    return with_ply_type(type, [&](auto zero) {
        using Number = decltype(zero);
        if constexpr (std::is_floating_point_v<Number>) throw std::logic_error("limit_of: expected an integer type");
        return std::to_string(highest ? static_cast<long long>(std::numeric_limits<Number>::max()) + outwards
                                      : static_cast<long long>(std::numeric_limits<Number>::lowest()) - outwards);
    });
}

/// The good file with one number more, of that type, before its vertices.
inline std::string with_number(PlyType type, const std::string& number)
{
    const std::string name(ply_type_names[static_cast<int>(type)]);
    return changed(changed(good_ascii, "element vertex", "element limit 1\nproperty " + name + " is\nelement vertex"),
                   "end_header\n", "end_header\n" + number + "\n");
}

/// The corners elsewhere, at whole numbers; as they are unless inputs are to vary.
inline PolygonMesh varied_corners(Variation& vary)
{
    PolygonMesh mesh = four_corners;
    if (vary)
        for (glm::vec3& corner : mesh.positions) corner = glm::vec3(vary.near(glm::ivec3(0), 90));
    return mesh;
}

/// A file that holds `four_corners`, with those of `mesh` instead.
inline std::string with_corners(const std::string& file, const PolygonMesh& mesh)
{
    if (mesh.positions == four_corners.positions) return file;
    std::string lines;
    for (const glm::vec3& corner : mesh.positions)
        for (int axis = 0; axis < 3; ++axis)
            lines += std::to_string(static_cast<int>(corner[axis])) + (axis < 2 ? " " : "\n");
    return changed(file, "0 0 0.5\n1 0 0\n0 1 0\n0 0 1\n", lines);
}

/// The file with some lines of comments behind its first line, so that what follows stands further down. As written
/// unless inputs are to vary.
inline std::string commented(Variation& vary, std::string file)
{
    const int lines = vary.one_of(0, std::array{1, 2, 3, 5, 8});
    const std::size_t first_end = file.find('\n');
    for (int line = 0; line < lines && first_end != std::string::npos; ++line)
        file.insert(first_end + 1,
                    "comment line " + std::to_string(lines - line) + " of " + std::to_string(lines) + "\n");
    return file;
}

/// They all hold `four_corners`.
inline std::vector<std::string> odd_files()
{
    const auto with = [](const char* piece, const char* by) { return changed(good_ascii, piece, by); };
    const auto with_faces = [](const char* properties, const char* first, const char* second) {
        return changed(changed(changed(good_ascii, "property list uchar int vertex_indices", properties), "3 0 1 2",
                               first, "end_header"),
                       "3 0 2 3", second, "end_header");
    };
    std::vector<std::string> files = {
        good_ascii.substr(0, good_ascii.size() - 1),
        changed(with("format ascii 1.0\n", ""), "end_header", "format ascii 1.0\nend_header"),
        with("format", "comment before the format\nformat"), with("element vertex 4", "\telement\t vertex  4\t"),
        changed(good_ascii, "3 0 2 3", "\t3\t0  2 3 \t", "end_header"),
        changed(good_ascii, "3 0 2 3", "\n  \n+3 +0 2 3", "end_header"),
        with("element face", "obj_info\nelement nothing 0\nproperty float comment\nelement face"),
        // A number of that name is no list, and of two lists the first counts.
        with_faces("property int vertex_index\nproperty list uchar int vertex_indices", "9 3 0 1 2", "9 3 0 2 3"),
        with_faces("property list uchar int vertex_indices\nproperty list uchar int vertex_index", "3 0 1 2 2 9 9",
                   "3 0 2 3 1 -9"),
        with_faces("property list uchar int vertex_index\nproperty list uchar int vertex_indices", "3 0 1 2 2 9 9",
                   "3 0 2 3 1 -9"),
        with_faces("property list int double vertex_index", "3 0 1.0 2", "3 0.0 20e-1 3"),
        // Types without negative numbers have a -0 all the same.
        with_faces("property list uchar uint vertex_indices", "3 -0 1 2", "3 -0 +2 3"),
        with_number(PlyType::uint16, "-00")};
    for (int type = 0; type < 6; ++type)
        for (const bool highest : {false, true})
            files.push_back(with_number(static_cast<PlyType>(type), limit_of(static_cast<PlyType>(type), highest)));
    return files;
}

/// Files without anything in them.
inline std::vector<std::string> empty_files()
{
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\nproperty int y\nproperty int z\nend_header";
    return {header, header + "\n", header + "\n\n \t\n"};
}

}
