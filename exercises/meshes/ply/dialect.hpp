#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <umbral/core/random.hpp>
#include <umbral/meshes/ply.hpp>
#include <umbral/meshes/ply_types.hpp>
#include <vector>

/// PLY files as other people's programs write them: the same mesh in many ways.
namespace umbral::meshes {

/// What a file may look like.
struct Dialect {
    PlyFormat format = PlyFormat::ascii;
    const char* line_end = "\n";
    PlyType coordinate_type = PlyType::float32;
    PlyType length_type = PlyType::uint8;
    PlyType corner_type = PlyType::int32;
    const char* corners_name = "vertex_indices";
    bool sized_names = false;  ///< float32 instead of float
    bool remarks = false;      ///< comments, obj_info, blank lines and more spaces
    bool faces_first = false;
    bool extra_elements = false;
    std::array<int, 3> axes{0, 1, 2};           ///< in which order x, y and z come
    std::vector<PlyType> extras_of_vertices{};  ///< before and between the coordinates, single and lists in turn
    std::vector<PlyType> extras_of_faces{};
};

/// Puts numbers one after the other, as the format has it.
class NumberWriter {
public:
    explicit NumberWriter(PlyFormat format) : format_(format) {}

    void put(PlyType type, double value)
    {
        with_ply_type(type, [&](auto zero) {
            const auto number = static_cast<decltype(zero)>(value);
            if (format_ == PlyFormat::ascii) {
                char digits[40];
                char* const end = std::to_chars(digits, digits + sizeof digits, number).ptr;
                if (!line_.empty()) line_ += ' ';
                line_.append(digits, end);
            } else {
                auto bytes = std::bit_cast<std::array<char, sizeof zero>>(number);
                if ((format_ == PlyFormat::big_endian) != (std::endian::native == std::endian::big))
                    std::reverse(bytes.begin(), bytes.end());
                data_.append(bytes.data(), bytes.size());
            }
        });
    }

    void end_element(const char* line_end)
    {
        if (format_ == PlyFormat::ascii) data_ += line_ + line_end;
        line_.clear();
    }

    [[nodiscard]] const std::string& data() const { return data_; }

private:
    PlyFormat format_;
    std::string line_;
    std::string data_;
};

inline std::string type_name(const Dialect& dialect, PlyType type)
{
    return std::string(ply_type_names[static_cast<int>(type) + (dialect.sized_names ? 8 : 0)]);
}

/// The header's line of the i-th extra property, and its numbers: every other one is a list.
inline std::string extra_property(const Dialect& dialect, PlyType type, std::size_t i)
{
    return "property " + (i % 2 == 1 ? "list uchar " : std::string()) + type_name(dialect, type) + " extra_" +
           std::to_string(i);
}
inline void put_extra(NumberWriter& writer, PlyType type, std::size_t i, Random& random)
{
    const std::uint32_t count = i % 2 == 1 ? random.below(4) : 1;
    if (i % 2 == 1) writer.put(PlyType::uint8, count);
    for (std::uint32_t k = 0; k < count; ++k) writer.put(type, random.below(100));
}

/// The mesh as a file of this dialect.
inline std::string written_in(const Dialect& dialect, const PolygonMesh& mesh, Random& random)
{
    const char* const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const std::string end = dialect.line_end;
    NumberWriter vertices(dialect.format);
    for (const glm::vec3& position : mesh.positions) {
        for (std::size_t i = 0; i < dialect.extras_of_vertices.size(); ++i)
            put_extra(vertices, dialect.extras_of_vertices[i], i, random);
        for (const int axis : dialect.axes) vertices.put(dialect.coordinate_type, static_cast<double>(position[axis]));
        vertices.end_element(dialect.line_end);
        if (dialect.remarks && dialect.format == PlyFormat::ascii && random.below(8) == 0)
            vertices.end_element(random.below(2) == 0 ? "\n" : " \t\r\n");
    }
    NumberWriter faces(dialect.format);
    for (const std::vector<std::uint32_t>& face : mesh.faces) {
        faces.put(dialect.length_type, static_cast<double>(face.size()));
        for (const std::uint32_t corner : face) faces.put(dialect.corner_type, corner);
        for (std::size_t i = 0; i < dialect.extras_of_faces.size(); ++i)
            put_extra(faces, dialect.extras_of_faces[i], i, random);
        faces.end_element(dialect.line_end);
    }
    NumberWriter others(dialect.format);
    for (int i = 0; i < 3; ++i) {
        others.put(PlyType::int16, -i);
        others.put(PlyType::uint8, 2);
        for (int k = 0; k < 2; ++k) others.put(PlyType::float64, 0.25 * k);
        others.end_element(dialect.line_end);
    }

    std::string vertex_header = "element vertex " + std::to_string(mesh.positions.size()) + end;
    for (std::size_t i = 0; i < dialect.extras_of_vertices.size(); ++i)
        vertex_header += extra_property(dialect, dialect.extras_of_vertices[i], i) + end;
    for (const int axis : dialect.axes)
        vertex_header += "property " + type_name(dialect, dialect.coordinate_type) + ' ' + "xyz"[axis] + end;
    std::string face_header = "element face " + std::to_string(mesh.faces.size()) + end + "property list " +
                              type_name(dialect, dialect.length_type) + ' ' + type_name(dialect, dialect.corner_type) +
                              ' ' + dialect.corners_name + end;
    for (std::size_t i = 0; i < dialect.extras_of_faces.size(); ++i)
        face_header += extra_property(dialect, dialect.extras_of_faces[i], i) + end;
    if (dialect.remarks) {
        face_header = "comment element face 7" + end + face_header;
        vertex_header = "obj_info num_cols 512" + end + "comment" + end + "  " + vertex_header;
    }
    std::string other_header =
        "element edge 3" + end + "property short x" + end + "property list uchar double vertex_index" + end;
    std::string other_data = others.data();
    if (!dialect.extra_elements) other_header = other_data = "";

    std::string file = "ply" + end + "format " + formats[static_cast<int>(dialect.format)] + " 1.0" +
                       (dialect.remarks ? "   " : "") + end;
    const bool first = dialect.faces_first;
    file += (first ? face_header : vertex_header) + other_header + (first ? vertex_header : face_header) +
            "end_header" + end;
    return file + (first ? faces.data() : vertices.data()) + other_data + (first ? vertices.data() : faces.data());
}

/// A dialect with a bit of everything.
inline Dialect some_dialect(PlyFormat format, Random& random)
{
    const auto some = [&](auto... options) { return std::array{options...}[random.below(sizeof...(options))]; };
    Dialect dialect;
    dialect.format = format;
    dialect.line_end = some("\n", "\r\n");
    dialect.coordinate_type = some(PlyType::float32, PlyType::float32, PlyType::float64);
    dialect.length_type = some(PlyType::uint8, PlyType::int8, PlyType::uint16, PlyType::int32);
    dialect.corner_type = some(PlyType::uint8, PlyType::int16, PlyType::uint16, PlyType::int32, PlyType::uint32);
    dialect.corners_name = some("vertex_index", "vertex_indices");
    dialect.sized_names = random.below(2) == 0;
    dialect.remarks = random.below(2) == 0;
    dialect.faces_first = random.below(3) == 0;
    dialect.extra_elements = random.below(2) == 0;
    for (std::size_t i = 3; i > 1; --i)
        std::swap(dialect.axes[i - 1], dialect.axes[random.below(static_cast<std::uint32_t>(i))]);
    for (std::vector<PlyType>* extras : {&dialect.extras_of_vertices, &dialect.extras_of_faces})
        for (std::uint32_t i = random.below(4); i > 0; --i) extras->push_back(static_cast<PlyType>(random.below(8)));
    return dialect;
}

/// Polygons of 3 to 6 corners over vertices anywhere. Places are multiples of 2^-10, so that they have short decimals.
inline PolygonMesh some_mesh(Random& random)
{
    PolygonMesh mesh;
    const std::uint32_t count = 4 + random.below(9);
    for (std::uint32_t i = 0; i < count; ++i) mesh.positions.push_back(round(4096.0F * random.in_cube()) / 1024.0F);
    for (std::uint32_t i = 2 + random.below(6); i > 0; --i) {
        std::vector<std::uint32_t> face;
        for (std::uint32_t corners = 3 + random.below(4); corners > 0; --corners) face.push_back(random.below(count));
        mesh.faces.push_back(face);
    }
    return mesh;
}

}
