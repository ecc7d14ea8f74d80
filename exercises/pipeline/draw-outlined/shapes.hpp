#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <kit/color.hpp>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/outlined.hpp>
#include <umbral/record/ask.hpp>

/// What the cases draw: regular polygons and wheels of triangles.
namespace umbral::pipeline {

/// One use of the unit. A drawing is made anew for each.
struct Piece {
    enum class Way { sent, polygon, triangles };
    Way way = Way::sent;
    int corners = 3;
    glm::vec2 centre{0};
    float radius = 1;
    float turn = 0;
    glm::vec3 fill{1};
    glm::vec3 edges{0};
    int unused = 0;  ///< of triangles: so many positions come first that no triangle of the wheel has
    int idle = 0;    ///< of triangles: so many come first whose corners are all one, the first position
};

inline std::vector<glm::vec2> corners_of(const Piece& piece)
{
    std::vector<glm::vec2> corners;
    for (int i = 0; i < piece.corners; ++i) {
        const float angle =
            piece.turn + 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(piece.corners);
        corners.push_back(piece.centre + piece.radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

/// The triangles' table of indices: every second triangle first, each begun at another of its corners, and every third
/// clockwise: no order to rely on. The centre comes last. Idle triangles come before all others.
inline std::vector<std::uint32_t> indices_of(const Piece& piece)
{
    std::vector<std::uint32_t> indices(3 * static_cast<std::size_t>(piece.idle), 0U);
    const auto first = static_cast<std::uint32_t>(piece.unused);
    const auto n = static_cast<std::uint32_t>(piece.corners);
    for (const std::uint32_t parity : {0U, 1U})
        for (std::uint32_t i = parity; i < n; i += 2) {
            std::array<std::uint32_t, 3> triangle = {first + i, first + (i + 1) % n, first + n};
            std::rotate(triangle.begin(), triangle.begin() + (i / 2) % 3, triangle.end());
            if (i % 3 == 1) std::swap(triangle[0], triangle[1]);
            indices.insert(indices.end(), triangle.begin(), triangle.end());
        }
    return indices;
}

struct Wheel {
    std::vector<glm::vec2> positions;
    std::vector<std::uint32_t> indices;
};

/// The tables of triangles; empty for a piece of no corners.
inline Wheel wheel_of(const Piece& piece)
{
    Wheel wheel{std::vector<glm::vec2>(static_cast<std::size_t>(piece.unused), glm::vec2(0.9F)), indices_of(piece)};
    const std::vector<glm::vec2> corners = corners_of(piece);
    wheel.positions.insert(wheel.positions.end(), corners.begin(), corners.end());
    if (piece.corners > 0) wheel.positions.push_back(piece.centre);
    return wheel;
}

/// The factory's drawing; nothing for what is sent. The tables go before the drawing is used.
inline std::unique_ptr<OutlinedDrawing> drawing_of(Recorder& out, const Piece& piece, std::string_view name = "drawing")
{
    if (piece.way == Piece::Way::polygon) return ask_new<make_outlined_polygon>(out, name, corners_of(piece));
    const Wheel wheel = wheel_of(piece);
    return ask_new<make_outlined_triangles>(out, name, wheel.positions, wheel.indices);
}

inline void draw(Recorder& out, const Piece& piece)
{
    if (piece.way == Piece::Way::sent)
        ask<send_polygon>(out, corners_of(piece), piece.fill, piece.edges);
    else if (const auto drawing = drawing_of(out, piece))
        ask<&OutlinedDrawing::draw>(out, *drawing, piece.fill, piece.edges);
}

/// Rings of pieces in all three ways: the goal picture. `turn` and `hue` turn the whole window and all hues.
inline std::vector<Piece> window(float turn = 0, float hue = 0)
{
    std::vector<Piece> pieces;
    for (int ring = 4; ring >= 0; --ring)
        for (int i = 0; i < std::max(1, 7 * ring); ++i) {
            const float angle = 2 * std::numbers::pi_v<float> *
                                    (static_cast<float>(i) + 0.5F * static_cast<float>(ring % 2)) /
                                    static_cast<float>(std::max(1, 7 * ring)) +
                                turn;
            const float out = 0.2F * static_cast<float>(ring);
            const glm::vec3 fill =
                rainbow(0.13F * static_cast<float>(ring) + 0.02F * static_cast<float>(i % 7) + hue, 0.75F, 0.75F);
            pieces.push_back({static_cast<Piece::Way>((ring + i) % 3), 4 + ring + i % 3,
                              out * glm::vec2(std::cos(angle), std::sin(angle)), ring == 0 ? 0.12F : 0.085F, angle,
                              fill, glm::mix(fill, glm::vec3(1), 0.75F)});
        }
    return pieces;
}

inline Piece random_piece(Random& random)
{
    Piece piece;
    piece.way = static_cast<Piece::Way>(random.below(3));
    piece.corners = 3 + static_cast<int>(random.below(9));
    const float x = random.uniform(-0.6F, 0.6F);
    piece.centre = {x, random.uniform(-0.6F, 0.6F)};
    piece.radius = random.uniform(0.15F, 0.38F);
    piece.turn = random.uniform(0, 6.28F);
    piece.fill = rainbow(random.uniform(), 0.8F, 0.8F);
    piece.edges = rainbow(random.uniform(), 0.25F, 1);
    if (random.below(4) == 0) piece.unused = 70'000;
    return piece;
}

}
