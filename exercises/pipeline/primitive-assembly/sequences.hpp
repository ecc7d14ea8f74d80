#pragma once

#include <algorithm>
#include <array>
#include <kit/canonical.hpp>
#include <numeric>
#include <span>
#include <string>
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

/// What the numbers of the two tables below mean: vertices count from 1 in the first, since 0 stands for none there.
inline void name_assembly(Recorder& out)
{
    std::string primitives;
    std::string provoking;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string line = std::to_string(i) + " " + names[i];
        primitives += line + ": corners, vertices from 1\n";
        provoking += line + ": provoking vertex, from 0\n";
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

/// Events: the type, how many corners, and the corners counted from 1 (nine at most); and the provoking vertices in
/// their order.
inline void record_assembly(Recorder& out, PrimitiveType type, const std::vector<std::uint32_t>& vertices)
{
    const auto code = static_cast<float>(type);
    const std::vector<Primitive> primitives = ask<assemble>(out, type, vertices);
    for (std::size_t i = 0; i < std::min(primitives.size(), 2 * vertices.size() + 4); ++i) {
        const std::vector<std::uint32_t> corners = canonical_corners(primitives[i].corners);
        std::array<float, 11> row{code, static_cast<float>(corners.size())};
        for (std::size_t c = 0; c < std::min<std::size_t>(corners.size(), 9); ++c)
            row[c + 2] = static_cast<float>(corners[c]) + 1;
        out.append("primitives", std::span<const float>(row));
        out.append("provoking", glm::vec2(code, static_cast<float>(primitives[i].provoking)));
    }
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

/// Events of one draw: points, segments and triangles, each list sorted; numbers counted from 1.
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
    for (const std::uint32_t point : list.points) row(0, {point + 1, 0, 0});
    for (const glm::uvec2& segment : list.segments) row(1, {segment + 1U, 0});
    for (const glm::uvec3& triangle : list.triangles) row(2, triangle + 1U);
}

inline std::string draw_names(int draws)
{
    std::string text;
    for (int draw = 0; draw < draws; ++draw)
        for (const auto& [kind, name] : {std::pair{0, "point"}, {1, "segment"}, {2, "triangle"}})
            text += std::to_string(4 * draw + kind) + " draw " + std::to_string(draw + 1) + ": " + name +
                    ", vertices from 1\n";
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
