#pragma once

#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <umbral/meshes/ply.hpp>
#include <vector>

#include "dialect.hpp"
#include "well_formed.hpp"

/// Files that must be refused, each made from a good one by one change.
namespace umbral::meshes {

/// A file, whether the place of its fault is defined, and the word that cannot be used, if there is one.
struct Malformed {
    std::string file;
    bool has_place = true;
    std::string word{};
};

inline std::vector<Malformed> bad_headers()
{
    const auto with = [](const char* piece, const char* by) { return Malformed{changed(good_ascii, piece, by)}; };
    const auto without = [](const char* piece) { return Malformed{changed(good_ascii, piece, ""), false}; };
    return {{"", false},
            {"\n" + good_ascii},
            with("ply\n", "PLY\n"),
            with("ply\n", "plyx\n"),
            with("ply\n", "ply 1\n"),
            with("format ascii 1.0", "format text 1.0"),
            with("format ascii 1.0", "format ascii 2.0"),
            with("element vertex", "format ascii 1.0\nelement vertex"),
            without("format ascii 1.0\n"),
            without(good_ascii.c_str() + good_ascii.find("end_header")),
            with("vertex 4", "vertex"),
            with("vertex 4", "vertex -4"),
            with("vertex 4", "vertex 4.0"),
            with("vertex 4", "vertex 99999999999999999999"),
            with("vertex 4", "vertex 9223372036854775808"),
            with("vertex 4", "vertex 4 4"),
            with("element face", "element vertex"),
            // The same name, with others between.
            with("end_header", "element vertex 0\nend_header"),
            with("end_header", "property int face\nelement face 0\nend_header"),
            with("element face", "element edge 0\nelement strip 0\nelement edge 0\nelement face"),
            with("element face", "elephant face"),
            with("element face", "faces\nelement face"),
            with("comment four", "property float x\ncomment four"),
            // No keywords, though they begin like one.
            with("comment four", "commentary four"),
            with("comment four", "Comment four"),
            with("comment four", "obj_information four"),
            with("comment four", "comment: four"),
            with("end_header", "end_header_of_four"),
            with("float y", "real y"),
            with("float y", "float"),
            with("float y", "float x"),
            with("float z", "float z\nproperty double y"),
            with("float z", "float z\nproperty list uchar float y"),
            with("end_header", "property int vertex_indices\nend_header"),
            with("float x", "list uchar float z\nproperty float x"),
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

/// Numbers of a file that are no vertex: not whole, by a little or much.
inline std::vector<Malformed> corners_not_whole(Variation& vary)
{
    const auto corner = [&](const char* type, const char* number) {
        return Malformed{changed(changed(good_ascii, "uchar int", std::string("uchar ") + type), "3 0 2 3",
                                 std::string("3 0 ") + number + " 3", "end_header"),
                         true, number};
    };
    const auto one_of = [&](const char* written, const auto& others) { return vary.one_of(written, others); };
    return {corner("float", one_of("1.5", std::array{"0.5", "2.5", "1.25", "0.75"})),
            corner("float", one_of("1.0000001", std::array{"2.0000002", "0.99999994", "1.9999999", "1.0000002"})),
            corner("float", one_of("1e-30", std::array{"3e-20", "1e-38", "7.5e-12", "4e-9"})),
            corner("double", one_of("2.0000000001", std::array{"1.00000000001", "0.9999999999", "1.999999999"})),
            corner("double", one_of("1.000000000000001", std::array{"2.000000000000001", "0.999999999999999"})),
            corner("double", one_of("-1e-12", std::array{"-1e-9", "-1e-15", "-2e-200"}))};
}

/// Lines with two faults, or with one that only looks like the other: the first one counts.
inline std::vector<Malformed> lines_of_two_faults(Variation& vary)
{
    const std::string word =
        vary.one_of(std::string("zero"), std::array<std::string, 5>{"none", "1,5", "--2", "0x1", "1.5f"});
    const auto with = [&](const char* piece, const std::string& by, const std::string& told) {
        return Malformed{changed(good_ascii, piece, by, "end_header"), true, told};
    };
    return {with("1 0 0", "1 " + word, word),
            with("0 1 0", word, word),
            with("0 0 1", "0 " + word + " 1 7", word),
            with("3 0 1 2", "3 0 " + word, word),
            with("3 0 2 3", "3 0 " + word + " 3 1", word),
            with("3 0 2 3", "3 0 47", "47"),
            with("3 0 1 2", "3 0 47 2 1 " + word, "47"),
            with("1 0 0", "1 0 0 " + word, "")};  // a number too many, whatever it is
}

inline std::vector<Malformed> bad_data(Variation vary = {})
{
    const auto with = [](const char* piece, const char* by) {
        return Malformed{changed(good_ascii, piece, by, "end_header")};
    };
    const auto with_word = [&](const char* piece, const char* before, const char* number, const char* behind = "") {
        return Malformed{with(piece, (std::string(before) + number + behind).c_str()).file, true, number};
    };
    const auto of_type = [](const char* type, const char* number) {
        return Malformed{changed(changed(good_ascii, "float y", std::string(type) + " y"), "1 0 0",
                                 std::string("1 ") + number + " 0", "end_header")};
    };
    std::vector<Malformed> files = {
        {changed(good_ascii, "3 0 1 2\n3 0 2 3\n", ""), false},
        {changed(good_ascii, "3 0 2 3\n", ""), false},
        {changed(good_ascii, "face 2", "face 1")},
        {good_ascii + "\n\n7\n"},
        with_word("1 0 0", "1 0 ", "zero"),
        with_word("0 0 1", "", "0,5", " 0 1"),
        with_word("0 1 0", "0 ", "0.5.5", " 0"),
        with_word("0 0 0.5", "", "0x1", " 0 0.5"),
        with_word("0 0 0.5", "0 0 ", "1e50"),
        with("1 0 0", "1 -1e50 0"),
        with("1 0 0", "1 100000000000000000000000000000000000000000000000000e-1 0"),
        with("1 0 0", "1 + 0"),
        with("1 0 0", "1 +-1 0"),
        with("1 0 0", "1 0"),
        with("1 0 0", "1 0 0 0"),
        // Blank lines are no elements, but lines.
        with_word("1 0 0", "\n1 ", "zero", " 0"),
        with_word("0 1 0", "\n \t\n\n0 ", "none", " 0"),
        with("3 0 1 2", "\n\n3 0 1"),
        with_word("3 0 2 3", " \n3 0 2 ", "47"),
        // Too large for a float, and told in full.
        with_word("0 1 0", "0 ", "7000000000000000000000000000000000000000000000000000", " 0"),
        of_type("uchar", "-01"),
        of_type("double", "1e400"),
        of_type("double", "1e5000"),
        of_type("int", "99999999999999999999"),
        of_type("int", "-99999999999999999999"),
        with("3 0 2 3", "4 0 2 3"),
        with("3 0 2 3", "2 0 2 3"),
        with_word("3 0 2 3", "3 0 ", "2.0", " 3"),
        with_word("3 0 1 2", "", "300", " 0 2 3"),
        with("3 0 2 3", "-3 0 2 3"),
        with_word("3 0 2 3", "3 0 2 ", "47"),
        with("3 0 2 3", "3 0 2 4"),
        with("3 0 2 3", "3 0 -1 3"),
        {changed(changed(good_ascii, "uchar int", "char int"), "3 0 2 3", "-1")},
        {changed(good_ascii, "vertex 4", "vertex 3")},
        {changed(good_ascii, "vertex 4", "vertex 5")}};
    for (int type = 0; type < 6; ++type)
        for (const bool highest : {false, true})
            files.push_back(
                {with_number(static_cast<PlyType>(type), limit_of(static_cast<PlyType>(type), highest, 1))});
    for (const auto& more : {corners_not_whole(vary), lines_of_two_faults(vary)})
        files.insert(files.end(), more.begin(), more.end());
    // Faces first: whether their corners are vertices is told by the count alone, of which no digit may be lost.
    for (const char* const type : {"int", "uint", "double"}) {
        const std::string claims = std::string("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar ") + type +
                                   " vertex_index\nelement vertex 16777217\nproperty float x\nproperty float "
                                   "y\nproperty float z\nend_header\n3 0 1 16777217\n";
        files.push_back({claims});
        files.push_back({changed(claims, "vertex 16777217", "vertex 16777218"), false});
    }
    return files;
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
    std::string file = written_in(dialect, four_corners, unused);
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
    files.push_back(poked(little_endian, uint8, float32, 48 + 5, "\1\0\200\77"s));                   // 1.0000001
    files.push_back(poked(big_endian, uint8, float64, 48 + 9, "\77\357\377\377\377\377\377\377"s));  // below 1
    // A corner that is no vertex comes before the end of data that are not all there.
    Malformed two_faults = poked(big_endian, uint8, uint32, 48 + 13 + 5, "\200\0\0\2"s);
    two_faults.file.resize(two_faults.file.size() - 2);
    files.push_back(two_faults);
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
