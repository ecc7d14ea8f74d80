#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <umbral/meshes/ply.hpp>
#include <vector>

#include "dialect.hpp"

/// Files that must be refused, each made from a good one by one change.
namespace umbral::meshes {

inline const std::string good_ascii =
    "ply\nformat ascii 1.0\ncomment four corners\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0.5\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n";

/// A file, and whether the place of its fault is defined.
struct Malformed {
    std::string file;
    bool has_place = true;
};

/// The text with a piece of it replaced; the first such piece after `after`.
inline std::string changed(const std::string& text, const std::string& piece, const std::string& by,
                           const std::string& after = "")
{
    const std::size_t from = text.find(piece, text.find(after));
    if (from == std::string::npos) throw std::logic_error("changed: there is no '" + piece + "'");
    return std::string(text).replace(from, piece.size(), by);
}

inline std::vector<Malformed> bad_headers()
{
    const auto with = [](const char* piece, const char* by) { return Malformed{changed(good_ascii, piece, by)}; };
    const auto without = [](const char* piece) { return Malformed{changed(good_ascii, piece, ""), false}; };
    return {{"", false},
            {"\n" + good_ascii},
            with("ply\n", "PLY\n"),
            with("ply\n", "plyx\n"),
            with("format ascii 1.0", "format text 1.0"),
            with("format ascii 1.0", "format ascii 2.0"),
            with("element vertex", "format ascii 1.0\nelement vertex"),
            without("format ascii 1.0\n"),
            without(good_ascii.c_str() + good_ascii.find("end_header")),
            with("vertex 4", "vertex"),
            with("vertex 4", "vertex -4"),
            with("vertex 4", "vertex 4.0"),
            with("vertex 4", "vertex 99999999999999999999"),
            with("element face", "element vertex"),
            with("element face", "elephant face"),
            with("comment four", "property float x\ncomment four"),
            with("float y", "real y"),
            with("float y", "float"),
            with("float y", "float x"),
            with("float y", "float y z"),
            with("list uchar int", "list uchar"),
            with("list uchar int", "list float int"),
            without("property float z\n"),
            without("property list uchar int vertex_indices\n"),
            {changed(good_ascii, "vertex_indices", "corners"), false},
            // The list belongs to another element than the faces.
            {changed(good_ascii, "property list", "property int material\nelement strip 1\nproperty list"), false},
            {changed(good_ascii, "float z", "list uchar float z"), false},
            {changed(good_ascii, "element vertex", "element point"), false}};
}

inline std::vector<Malformed> bad_data()
{
    const auto with = [](const char* piece, const char* by) {
        return Malformed{changed(good_ascii, piece, by, "end_header")};
    };
    return {{changed(good_ascii, "3 0 1 2\n3 0 2 3\n", ""), false},
            {changed(good_ascii, "3 0 2 3\n", ""), false},
            {changed(good_ascii, "face 2", "face 1")},
            {good_ascii + "\n\n7\n"},
            with("1 0 0", "1 0 zero"),
            with("1 0 0", "1 0,5 0"),
            with("1 0 0", "1 0.5.5 0"),
            with("1 0 0", "1 0x1 0"),
            with("1 0 0", "1 1e50 0"),
            with("1 0 0", "1 0"),
            with("1 0 0", "1 0 0 0"),
            with("3 0 2 3", "4 0 2 3"),
            with("3 0 2 3", "2 0 2 3"),
            with("3 0 2 3", "3 0 2.0 3"),
            with("3 0 2 3", "300 0 2 3"),
            with("3 0 2 3", "-3 0 2 3"),
            with("3 0 2 3", "3 0 2 4"),
            with("3 0 2 3", "3 0 -1 3"),
            {changed(changed(good_ascii, "uchar int", "uchar float"), "3 0 2 3", "3 0 1.5 3")},
            {changed(changed(good_ascii, "uchar int", "char int"), "3 0 2 3", "-1")},
            {changed(good_ascii, "vertex 4", "vertex 3")},
            {changed(good_ascii, "vertex 4", "vertex 5")}};
}

/// The good mesh in binary, with one value of its data changed: `offset` is counted from the end of the header.
inline Malformed poked(PlyFormat format, PlyType length_type, PlyType corner_type, std::size_t offset,
                       const std::string& bytes)
{
    Dialect dialect;
    dialect.format = format;
    dialect.length_type = length_type;
    dialect.corner_type = corner_type;
    Random unused(1);
    std::string file =
        written_in(dialect, {{{0, 0, 0.5F}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}}, unused);
    return {file.replace(file.find("end_header\n") + 11 + offset, bytes.size(), bytes)};
}

inline std::vector<Malformed> bad_binaries()
{
    using enum PlyFormat;
    using enum PlyType;
    using namespace std::string_literals;
    std::vector<Malformed> files;
    // Four vertices of twelve bytes, then faces of 1 + 3 x 4 bytes.
    const std::string good = poked(little_endian, uint8, int32, 0, "").file;
    for (const std::size_t lost : {1U, 4U, 13U, 14U, 27U, 74U})
        files.push_back({good.substr(0, good.size() - lost), false});
    files.push_back({good + "\n"});
    files.push_back(poked(little_endian, uint8, int32, 48 + 13 + 5, "\4\0\0\0"s));
    files.push_back(poked(little_endian, uint8, int32, 48 + 13 + 5, "\377\377\377\377"s));
    files.push_back(poked(big_endian, uint8, int32, 48 + 9, "\0\0\1\2"s));
    files.push_back(poked(big_endian, uint8, uint32, 48 + 9, "\200\0\0\2"s));
    files.push_back(poked(little_endian, int8, int32, 48 + 13, "\375"s));
    files.push_back(poked(big_endian, int32, uint8, 48, "\377\377\377\375"s));
    files.push_back(poked(little_endian, uint8, float32, 48 + 5, "\0\0\300\77"s));
    files.push_back(poked(little_endian, uint8, float32, 48 + 5, "\0\0\300\177"s));
    return files;
}

/// Counts that are larger than any file; the last two are good files all the same.
inline std::vector<Malformed> lying_counts()
{
    using enum PlyFormat;
    using enum PlyType;
    using namespace std::string_literals;
    const std::string good = poked(little_endian, uint8, int32, 0, "").file;
    return {{changed(changed(good_ascii, "vertex 4", "vertex 4000000000000000000"), "3 0 1 2\n3 0 2 3\n", ""), false},
            {changed(good_ascii, "face 2", "face 1000000000000"), false},
            {changed(changed(good_ascii, "uchar int", "uint int"), "3 0 1 2", "4000000000 0 1 2")},
            {changed(good, "vertex 4", "vertex 9223372036854775807"), false},
            {changed(good, "face 2", "face 6000000000000000000"), false},
            {poked(little_endian, uint32, int32, 48, "\377\377\377\377"s).file, false},
            {poked(big_endian, int32, int32, 48, "\177\377\377\377"s).file, false},
            {changed(good, "list uchar int vertex_indices\n",
                     "list uchar int vertex_indices\nproperty list uint char rest\n"),
             false},
            {changed(good_ascii, "element face", "element nothing 9000000000000000000\nelement face")},
            {changed(good, "element face", "element nothing 9000000000000000000\nelement face")}};
}

}
