#pragma once

#include <cmath>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/meshes/ply.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/recorder.hpp>

#include "decode.hpp"

/// Files that the unit writes.
namespace umbral::meshes {

inline constexpr std::uint32_t missing = 4294967295U;
inline constexpr PlyFormat formats[] = {PlyFormat::ascii, PlyFormat::little_endian, PlyFormat::big_endian};

/// So many rows, whatever came: files after this one must not suffer from it.
template <class Values>
void append_rows(Recorder& out, const char* name, const Values& values, std::size_t count, auto convert)
{
    for (std::size_t i = 0; i < count; ++i) out.append(name, i < values.size() ? convert(values[i]) : missing);
}

inline void record_faces(Recorder& out, const std::vector<std::vector<std::uint32_t>>& faces,
                         const PolygonMesh& expected)
{
    const auto same = [](std::uint32_t corner) { return corner; };
    out.append("faces", static_cast<std::uint32_t>(std::min<std::size_t>(faces.size(), missing)));
    for (std::size_t i = 0; i < expected.faces.size(); ++i) {
        const std::vector<std::uint32_t> face = i < faces.size() ? faces[i] : std::vector<std::uint32_t>{};
        out.append("faces", i < faces.size() ? static_cast<std::uint32_t>(face.size()) : missing);
        append_rows(out, "faces", face, expected.faces[i].size(), same);
    }
}

/// Files that the unit writes, and what stands in them.
inline void record_written(Recorder& out, const PolygonMesh& mesh, PlyFormat format)
{
    const Decoded file = decoded(ask<write_ply>(out, mesh, format), format);
    const auto same = [](std::uint32_t row) { return row; };
    append_rows(out, "bits", file.position_bits, 3 * mesh.positions.size(), same);
    for (std::size_t i = 0; format == PlyFormat::ascii && i < 3 * mesh.positions.size(); ++i) {
        // Large whole numbers have two right ways: as few digits as a float needs, or their own.
        const float value = std::abs(mesh.positions[i / 3][static_cast<int>(i % 3)]);
        if (value < 0x1p24F || (value > 1e15F && std::isfinite(value)))
            out.append("digits", i < file.digits.size() ? file.digits[i] : missing);
    }
    record_faces(out, file.faces, mesh);
}

/// Any finite float: sign, exponent and digits at random.
inline float some_float(Random& random)
{
    const std::uint32_t bits = random.bits();
    return std::bit_cast<float>((bits & 0x7F800000U) == 0x7F800000U ? bits & 0x807FFFFFU : bits);
}

/// The three powers of two whose shortest decimal that reads back is not the nearest one of so many digits: floats
/// below them lie half as far away as those above.
inline float lopsided_float(Random& random)
{
    const int exponents[] = {-96, 87, 90};
    const float power = std::ldexp(1.0F, exponents[random.below(3)]);
    return random.below(2) == 0 ? power : -power;
}

inline void record_writing(Random& random, Recorder& out)
{
    PolygonMesh large{{}, {{}, {7}}};
    for (int i = 0; i < 300; ++i) {
        const float any = some_float(random);
        const float x = i % 8 == 3 ? lopsided_float(random) : any;
        const float y = random.uniform(-1, 1);
        large.positions.emplace_back(x, y, static_cast<float>(random.below(2000)) / 100.0F);
    }
    const float infinity = std::numeric_limits<float>::infinity();
    const PolygonMesh small{{{0, -0.0F, 1e-45F},
                             {0.1F, 1e10F, 3.4028235e38F},
                             {16777216, 1.0F / 3, -1e-10F},
                             {infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}},
                            {{0, 1, 2}, {2, 1, 0, 1}}};
    for (const PlyFormat format : formats) {
        record_written(out, {}, format);
        record_written(out, small, format);
        record_written(out, large, format);
        // Vertices without faces, and one vertex, of which faces may be made all the same.
        record_written(out, {{small.positions[1], large.positions[0], small.positions[0]}, {}}, format);
        record_written(out, {{large.positions[1]}, {{}, {0}, {0, 0, 0}, {0, 0, 0}}}, format);
    }
    // A face of 256 corners does not fit a list whose length is one byte.
    for (const std::uint32_t corners : {255U, 256U, 300U}) {
        large.faces = {{7, 8, 9}, {}};
        for (std::uint32_t i = 0; i < corners; ++i) large.faces.back().push_back(299 - i);
        for (const PlyFormat format : formats) record_written(out, large, format);
    }
    // Nor does a vertex fit 16 bits that stands behind so many others.
    PolygonMesh many{std::vector<glm::vec3>(70'000), {{0, 65535, 65536}}};
    for (std::uint32_t i = 0; i < 60; ++i) many.faces.push_back({69'999 - i, 65'537 + i, i});
    for (const PlyFormat format : formats)
        record_faces(out, decoded(ask<write_ply>(out, many, format), format).faces, many);
}

/// Faces whose length hardly fits 16 bits, or does not: of each only what stands at some places of it.
inline void record_long_faces(Random& random, Recorder& out)
{
    for (const std::uint32_t corners : {65'535U, 65'536U, 65'537U + random.below(9000)}) {
        PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {}, {3, 2, 1}}};
        for (std::uint32_t i = 0; i < corners; ++i) mesh.faces[1].push_back(random.below(4));
        for (const PlyFormat format : formats) {
            const std::vector<std::vector<std::uint32_t>> faces =
                decoded(ask<write_ply>(out, mesh, format), format).faces;
            append_rows(out, "long faces", faces, 3,
                        [](const auto& f) { return static_cast<std::uint32_t>(f.size()); });
            const auto& face = faces.size() > 1 ? faces[1] : std::vector<std::uint32_t>{};
            for (const std::uint32_t place : {0U, 255U, 256U, 32'768U, 65'534U, corners - 1})
                out.append("long faces", place < face.size() ? face[place] : missing);
        }
    }
}

}
