#pragma once

#include <algorithm>
#include <cmath>
#include <kit/color.hpp>
#include <numbers>
#include <optional>
#include <umbral/core/grid.hpp>
#include <umbral/core/random.hpp>
#include <vector>

/// Regular polygons and wheels round the origin, filled and with edges: where to look at them, and in which colours
/// they come. `Piece` has corners, radius, turn, fill and edges.
namespace umbral::pipeline {

/// The pixel at a place in clip coordinates.
inline void append_pixel(std::vector<float>& row, const Image& picture, glm::vec2 place)
{
    const glm::ivec2 pixel(0.5F * (place + 1.0F) * glm::vec2(picture.width, picture.height));
    const glm::u8vec4& found = picture.at(pixel.x, picture.height - 1 - pixel.y);
    row.insert(row.end(), {static_cast<float>(found.r), static_cast<float>(found.g), static_cast<float>(found.b)});
}

/// At two edges: in the middle of the fill there, on the outer half of the edge, and half way to the corner, where
/// wheels have an edge too. With at most eight corners, or many, and lines so wide that these pixels have one colour
/// each.
template <class Piece>
void append_seen(std::vector<float>& row, const Image& picture, const Piece& piece, int edge)
{
    const int corners = std::max(piece.corners, 3);
    const float half = std::numbers::pi_v<float> / static_cast<float>(corners);
    const float reach = piece.radius * std::cos(half);
    const auto at = [&](float radius, float angle) {
        append_pixel(row, picture, radius * glm::vec2(std::cos(angle), std::sin(angle)));
    };
    for (const int k : {edge, edge + corners / 2}) {
        const float corner = piece.turn + 2 * half * static_cast<float>(k);
        at(0.6F * reach, corner + half);
        at(reach + 0.03F, corner + half);
        at(0.5F * piece.radius, corner);
    }
}

/// What append_seen's numbers are called, for Recorder::columns.
inline constexpr const char* seen_columns =
    "pixel of the fill/3, pixel on an edge/3, pixel towards a corner/3, "
    "pixel of the fill elsewhere/3, pixel on another edge/3, pixel towards another corner/3";

/// One of a piece's edges.
template <class Piece>
int any_edge(Random& random, const Piece& piece)
{
    return static_cast<int>(random.below(static_cast<std::uint32_t>(std::max(piece.corners, 3))));
}

/// Colours by turns: any; a fill of black; fill and edges alike; edges of black. In a second draw fills have the colour
/// of the edges before.
template <class Piece>
void choose_colors(Piece& piece, Random& random, int turn, const std::optional<glm::vec3>& edges_before)
{
    piece.fill = edges_before.value_or(rainbow(random.uniform(), 0.8F, 0.8F));
    piece.edges = rainbow(random.uniform(), 0.25F, 1);
    if (turn == 1) piece.fill = glm::vec3(0);
    if (turn == 2) piece.edges = piece.fill;
    if (turn == 3) piece.edges = glm::vec3(0);
}

}
