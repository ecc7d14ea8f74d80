#pragma once

#include <algorithm>
#include <array>
#include <kit/canonical.hpp>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <umbral/pipeline/assembly.hpp>
#include <umbral/record/ask.hpp>

#include "../support.hpp"

/// Sequences of vertices, and how the driver writes down what becomes of them.
namespace umbral::pipeline {

inline constexpr std::array names = {"point",
                                     "segment",
                                     "segment of a strip",
                                     "segment of a loop",
                                     "triangle",
                                     "triangle of a strip",
                                     "triangle of a fan",
                                     "quadrilateral",
                                     "quadrilateral of a strip",
                                     "polygon"};

/// How many corners each has; a polygon any number.
inline constexpr std::array<std::size_t, 10> usual_corners{1, 2, 2, 2, 3, 3, 3, 4, 4, 0};

/// Where the indices of a question begin: those that a float or 24 bits do not hold are recorded by how far they are
/// behind it.
inline constexpr std::array<std::uint32_t, 4> bases = {0, 1'000'000, (1U << 24U) - 3, 0xffffffffU - 19};

/// What kind of event a primitive is: its type, which of the bases its indices are counted from, and how many corners.
inline float kind_of(std::size_t type, std::size_t base, std::size_t corners)
{
    return static_cast<float>(type + 10 * base + 40 * corners);
}

/// What the numbers of the two tables below mean.
inline void name_assembly(Recorder& out)
{
    std::string primitives;
    std::string provoking;
    for (std::size_t type = 0; type < names.size(); ++type)
        for (std::size_t base = 0; base < bases.size(); ++base) {
            const auto line = [&](std::size_t corners, const std::string& of) {
                return std::to_string(static_cast<int>(kind_of(type, base, corners))) + " " + names[type] + of +
                       (base == 0 ? "" : ", vertices counted from " + std::to_string(bases[base])) + ": ";
            };
            provoking += line(0, "") + "provoking vertex\n";
            for (std::size_t corners = 1; corners < 10; ++corners) {
                const std::string count = std::to_string(corners);
                primitives += line(corners, corners == usual_corners[type] ? "" : " of " + count + " corners") +
                              (corners == 1 ? "vertex" : "vertices/" + count) +
                              (corners < 9 ? ", -/" + std::to_string(9 - corners) : "") + "\n";
            }
        }
    out.text("primitives.names", primitives);
    out.text("provoking.names", provoking);
}

inline std::vector<std::uint32_t> counted(std::uint32_t count)
{
    std::vector<std::uint32_t> vertices(count);
    std::iota(vertices.begin(), vertices.end(), 0U);
    return vertices;
}

inline std::vector<std::uint32_t> random_sequence(Random& random, std::uint32_t count, std::uint32_t vertices)
{
    std::vector<std::uint32_t> sequence(count);
    for (std::uint32_t& vertex : sequence) vertex = random.below(vertices);
    return sequence;
}

/// The same face begun where that gives the smallest sequence; a segment from its smaller end.
inline std::vector<std::uint32_t> canonical_corners(std::vector<std::uint32_t> corners)
{
    if (corners.size() == 2) std::sort(corners.begin(), corners.end());
    std::vector<std::uint32_t> best = corners;
    for (std::size_t i = 1; i < std::min<std::size_t>(corners.size(), 16); ++i) {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        best = std::min(best, corners);
    }
    return best;
}

/// Events: the kind of a primitive and its corners (nine at most); and the provoking vertex.
inline void record_primitive(Recorder& out, PrimitiveType type, const Primitive& primitive, std::size_t base)
{
    const auto number = static_cast<std::size_t>(type);
    const std::vector<std::uint32_t> corners = canonical_corners(primitive.corners);
    std::array<float, 10> row{kind_of(number, base, corners.size())};
    for (std::size_t c = 0; c < std::min<std::size_t>(corners.size(), 9); ++c)
        row[c + 1] = static_cast<float>(corners[c] - bases[base]);
    out.append("primitives", std::span<const float>(row));
    out.append("provoking", glm::vec2(kind_of(number, base, 0), static_cast<float>(primitive.provoking - bases[base])));
}

/// All primitives of a sequence, whose indices begin behind one of the bases.
inline void record_assembly(Recorder& out, PrimitiveType type, std::vector<std::uint32_t> vertices,
                            std::size_t base = 0)
{
    for (std::uint32_t& vertex : vertices) vertex += bases[base];
    const std::vector<Primitive> primitives = ask<assemble>(out, type, vertices);
    for (std::size_t i = 0; i < std::min(primitives.size(), 2 * vertices.size() + 4); ++i)
        record_primitive(out, type, primitives[i], base);
}

/// A few primitives of a long sequence: some from its beginning to its end, and the last ones.
inline void record_long_assembly(Recorder& out, PrimitiveType type, const std::vector<std::uint32_t>& vertices)
{
    const std::vector<Primitive> primitives = ask<assemble>(out, type, vertices);
    for (std::size_t i = 0; i < std::min(primitives.size(), vertices.size() + 4); ++i)
        if (i % 9973 == 0 || i + 4 > primitives.size()) record_primitive(out, type, primitives[i], 0);
}

/// The same lists in one order, each item in its canonical form: what the interface leaves free.
inline DrawList sorted(DrawList list)
{
    for (glm::uvec2& segment : list.segments) segment = canonical(segment);
    for (glm::uvec3& triangle : list.triangles) triangle = canonical(triangle);
    std::sort(list.points.begin(), list.points.end());
    std::sort(list.segments.begin(), list.segments.end(), [](glm::uvec2 a, glm::uvec2 b) {
        return std::array{a.x, a.y} < std::array{b.x, b.y};
    });
    std::sort(list.triangles.begin(), list.triangles.end(), [](glm::uvec3 a, glm::uvec3 b) {
        return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    });
    return list;
}

/// Events of one draw: points, segments and triangles, each list sorted.
inline void record_draw(Recorder& out, int draw, DrawList list, std::size_t expected)
{
    const auto row = [&](int kind, glm::uvec3 vertices) {
        const std::array<float, 4> numbers{static_cast<float>(4 * draw + kind), static_cast<float>(vertices.x),
                                           static_cast<float>(vertices.y), static_cast<float>(vertices.z)};
        out.append("list", std::span<const float>(numbers));
    };
    const std::size_t most = 2 * expected + 16;
    list.points.resize(std::min(list.points.size(), most));
    list.segments.resize(std::min(list.segments.size(), most));
    list.triangles.resize(std::min(list.triangles.size(), most));
    list = sorted(std::move(list));
    for (const std::uint32_t point : list.points) row(0, {point, 0, 0});
    for (const glm::uvec2& segment : list.segments) row(1, {segment, 0});
    for (const glm::uvec3& triangle : list.triangles) row(2, triangle);
}

inline std::string draw_names(int draws)
{
    std::string text;
    for (int draw = 0; draw < draws; ++draw)
        for (const auto& [kind, name, numbers] :
             {std::tuple{0, "point", "vertex, -/2"}, {1, "segment", "vertices/2, -"}, {2, "triangle", "vertices/3"}})
            text += std::to_string(4 * draw + kind) + " " + name + " of draw " + std::to_string(draw + 1) + ": " +
                    numbers + "\n";
    return text;
}

inline std::vector<glm::vec2> random_places(Random& random, std::size_t count)
{
    std::vector<glm::vec2> places(count);
    for (glm::vec2& place : places) {
        place.x = on_grid(random, 0, 640, 16);
        place.y = on_grid(random, 0, 480, 16);
    }
    return places;
}

}
