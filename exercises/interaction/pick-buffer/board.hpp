#pragma once

#include <array>
#include <kit/profiles.hpp>
#include <kit/stage.hpp>
#include <memory>
#include <umbral/interaction/pick_buffer.hpp>
#include <umbral/record/ask.hpp>

#include "../arrow.hpp"

/// The goal picture: a chess board on which some squares and pieces are picked. The name of a square is (row, column);
/// that of a piece has a third number.
namespace umbral::interaction {

inline constexpr int piece_name = 7;
inline constexpr float square_side = 0.5F;

struct Piece {
    int row;
    int column;
    bool is_dark;
};

inline constexpr std::array<Piece, 11> pieces = {{{1, 0, false},
                                                  {2, 2, false},
                                                  {1, 5, false},
                                                  {3, 4, false},
                                                  {0, 3, false},
                                                  {2, 7, false},
                                                  {6, 1, true},
                                                  {4, 3, true},
                                                  {5, 6, true},
                                                  {6, 4, true},
                                                  {4, 1, true}}};

/// The middle of a square, whose row 0 is the nearest and whose column 0 is on the left.
inline glm::vec3 middle_of(int row, int column)
{
    return {square_side * (static_cast<float>(column) - 3.5F), 0, square_side * (3.5F - static_cast<float>(row))};
}

/// A profile turned about the y axis.
inline shapes::Shape turned(const profiles::Profile& profile, int around)
{
    const int rows = static_cast<int>(profile.size()) - 1;
    return shapes::woven(around, rows, [&](float u, float v) {
        const auto i = static_cast<std::size_t>(std::lround(v * static_cast<float>(rows)));
        const glm::vec2 at = profile[i];
        const glm::vec2 before = i > 0 ? profile[i - 1] : at;
        const glm::vec2 after = i + 1 < profile.size() ? profile[i + 1] : at;
        const glm::vec2 along = normalize(after - before);
        const float sine = std::sin(shapes::turn * u);
        const float cosine = std::cos(shapes::turn * u);
        return shapes::Vertex{{at.x * sine, at.y, at.x * cosine}, {along.y * sine, -along.x, along.y * cosine}};
    });
}

inline const shapes::Shape& pawn_shape()
{
    static const shapes::Shape pawn = turned(profiles::pawn(), 48);
    return pawn;
}

inline glm::mat4 placed(const Piece& piece)
{
    return glm::scale(glm::translate(glm::mat4(1), middle_of(piece.row, piece.column)), glm::vec3(0.32F));
}

/// The depths of what a polygon has in the view volume of clip coordinates, if anything; it is cut by one plane after
/// the other.
struct DepthRange {
    double least = 2;
    double greatest = -1;
};

inline DepthRange depths_in_view(std::vector<glm::dvec4> polygon)
{
    for (int plane = 0; plane < 6; ++plane) {
        const auto inside = [&](const glm::dvec4& p) { return p.w + (plane % 2 == 0 ? p[plane / 2] : -p[plane / 2]); };
        std::vector<glm::dvec4> rest;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec4& a = polygon[i];
            const glm::dvec4& b = polygon[(i + 1) % polygon.size()];
            const double at_a = inside(a);
            const double at_b = inside(b);
            if (at_a >= 0) rest.push_back(a);
            if ((at_a >= 0) != (at_b >= 0)) rest.push_back(a + at_a / (at_a - at_b) * (b - a));
        }
        polygon = std::move(rest);
    }
    DepthRange range;
    for (const glm::dvec4& p : polygon) {
        const double depth = glm::clamp(0.5 + 0.5 * p.z / p.w, 0.0, 1.0);
        range = {std::min(range.least, depth), std::max(range.greatest, depth)};
    }
    return range;
}

class ChessBoard {
public:
    ChessBoard(Recorder& out, int width, int height)
        : out_(out),
          picture_(width, height),
          view_(glm::lookAt(glm::vec3(-1.15F, 2.75F, 4.1F), {0.02F, 0.06F, 0.28F}, {0, 1, 0})),
          projection_(glm::perspective(glm::radians(fovy_degrees),
                                       static_cast<float>(width) / static_cast<float>(height), 0.1F, 100.0F))
    {
    }

    /// The pixel in which a point of the world appears.
    [[nodiscard]] glm::ivec2 pixel_of_point(const glm::vec3& point) const
    {
        const glm::vec4 clip = projection_ * view_ * glm::vec4(point, 1);
        return glm::ivec2(glm::vec2(0.5F + 0.5F * clip.x / clip.w, 0.5F - 0.5F * clip.y / clip.w) *
                          glm::vec2(picture_));
    }

    /// The name of the nearest thing within a square of 5 x 5 pixels, as the course's program finds it.
    [[nodiscard]] std::vector<std::uint32_t> picked(const glm::ivec2& pixel) const
    {
        const glm::dmat4 to_clip =
            glm::dmat4(ask<pick_matrix>(out_, pixel, 5.0F, picture_)) * glm::dmat4(projection_ * view_);
        const std::unique_ptr<SelectionBuffer> buffer =
            ask_new<make_selection_buffer>(out_, "buffer", std::size_t{512});
        if (!buffer) return {};
        const auto push = [&](int name) {
            ask<&SelectionBuffer::push_name>(out_, *buffer, static_cast<std::uint32_t>(name));
        };
        const auto pop = [&] { ask<&SelectionBuffer::pop_name>(out_, *buffer); };
        const auto note = [&](const DepthRange& range) {
            if (range.least > range.greatest) return;
            ask<&SelectionBuffer::note_primitive>(out_, *buffer, range.least, range.greatest);
        };
        ask<&SelectionBuffer::init_names>(out_, *buffer);
        for (int row = 0; row < 8; ++row) {
            push(row);
            for (int column = 0; column < 8; ++column) {
                push(column);
                note(depths_of_square(to_clip, row, column));
                for (const Piece& piece : pieces) {
                    if (piece.row != row || piece.column != column) continue;
                    push(piece_name);
                    note(depths_of_piece(to_clip, piece));
                    pop();
                }
                pop();
            }
            pop();
        }
        const int count = ask<&SelectionBuffer::finish>(out_, *buffer);
        const auto words = ask<&SelectionBuffer::words>(out_, *buffer);
        const auto records = ask<parse_selection>(out_, words, count);
        if (!records) return {};
        const std::optional<std::size_t> nearest = ask<nearest_record>(out_, *records);
        return nearest && *nearest < records->size() ? (*records)[*nearest].names : std::vector<std::uint32_t>{};
    }

    /// The board in light; each of the names in a colour of its own, with the arrow that pointed there.
    [[nodiscard]] Image drawn(const std::vector<std::vector<std::uint32_t>>& names,
                              const std::vector<glm::ivec2>& clicks) const
    {
        const Stage stage(picture_.x, picture_.y, glm::vec3(0.13F, 0.15F, 0.22F));
        stage.look(view_, fovy_degrees, static_cast<float>(picture_.x) / static_cast<float>(picture_.y));
        const gl::Mesh box = uploaded(shapes::box());
        const gl::Mesh pawn = uploaded(pawn_shape());
        stage.draw({box,
                    glm::translate(glm::mat4(1), {0, -0.12F, 0}) * slab(12),
                    {glm::vec3(0.045F, 0.05F, 0.075F), 0, std::nullopt, 0.02F}});
        stage.draw(
            {box, glm::translate(glm::mat4(1), {0, -0.02F, 0}) * slab(2.16F), {glm::vec3(0.16F, 0.07F, 0.03F), 0.4F}});
        std::vector<Stage::Thing> things;
        for (const Piece& piece : pieces) {
            const glm::vec3 color = piece.is_dark ? glm::vec3(0.075F, 0.035F, 0.025F) : glm::vec3(0.72F, 0.60F, 0.42F);
            Finish finish{color, 0.6F};
            for (std::size_t i = 0; i < names.size(); ++i)
                if (names[i] == name_of(piece.row, piece.column, true)) finish.color = hue(i);
            things.push_back({pawn, placed(piece), finish});
        }
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 8; ++column)
                for (std::size_t i = 0; i < names.size(); ++i)
                    if (names[i] == name_of(row, column, false))
                        stage.draw({box,
                                    glm::scale(glm::translate(glm::mat4(1), middle_of(row, column) -
                                                                                glm::vec3(0.25F, 0.0095F, 0.25F)),
                                               glm::vec3(square_side, 0.011F, square_side)),
                                    {hue(i), 0.3F}});
        const Finish squares{glm::vec3(0.58F, 0.47F, 0.32F), 0.2F, glm::vec3(0.16F, 0.085F, 0.045F)};
        stage.draw_on({box, slab(2), squares}, things);
        Image picture = stage.picture();
        for (const glm::ivec2& click : clicks) paint_arrow(picture, glm::vec2(click) + 0.5F, 20);
        return picture;
    }

private:
    static constexpr float fovy_degrees = 36;

    static std::vector<std::uint32_t> name_of(int row, int column, bool is_piece)
    {
        std::vector<std::uint32_t> name = {static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column)};
        if (is_piece) name.push_back(piece_name);
        return name;
    }

    static glm::vec3 hue(std::size_t i)
    {
        constexpr std::array<float, 6> hues = {0.52F, 0.93F, 0.12F, 0.36F, 0.6F, 0.78F};
        return glm::vec3(srgb_decoded(glm::dvec3(rainbow(hues[i % hues.size()], 0.72F, 0.97F))));
    }

    static DepthRange depths_of_square(const glm::dmat4& to_clip, int row, int column)
    {
        std::vector<glm::dvec4> polygon;
        for (const glm::vec2 aside : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            polygon.push_back(to_clip * glm::dvec4(middle_of(row, column) + 0.25F * glm::vec3(aside.x, 0, aside.y), 1));
        return depths_in_view(polygon);
    }

    static DepthRange depths_of_piece(const glm::dmat4& to_clip, const Piece& piece)
    {
        const shapes::Shape& pawn = pawn_shape();
        const glm::dmat4 all = to_clip * glm::dmat4(placed(piece));
        std::vector<glm::dvec4> places;
        for (const glm::vec3& place : pawn.positions) places.push_back(all * glm::dvec4(place, 1));
        DepthRange range;
        for (std::size_t i = 0; i < pawn.indices.size(); i += 3) {
            const std::array triangle = {places[pawn.indices[i]], places[pawn.indices[i + 1]],
                                         places[pawn.indices[i + 2]]};
            const auto beside = [&](int axis, double side) {
                return std::all_of(triangle.begin(), triangle.end(),
                                   [&](const glm::dvec4& p) { return side * p[axis] > p.w; });
            };
            if (beside(0, 1) || beside(0, -1) || beside(1, 1) || beside(1, -1)) continue;
            const DepthRange one = depths_in_view({triangle.begin(), triangle.end()});
            range = {std::min(range.least, one.least), std::max(range.greatest, one.greatest)};
        }
        return range;
    }

    Recorder& out_;
    glm::ivec2 picture_;
    glm::mat4 view_;
    glm::mat4 projection_;
};

inline Image chess_board(Recorder& out, int width, int height)
{
    const ChessBoard board(out, width, height);
    const auto above = [](int row, int column, float y) { return middle_of(row, column) + glm::vec3(0, y, 0); };
    std::vector<glm::ivec2> clicks;
    for (const glm::vec3& point :
         {above(3, 4, 0.42F), above(1, 3, 0), above(4, 3, 0.5F), above(2, 5, 0.02F), above(1, 0, 0.3F), above(5, 7, 0)})
        clicks.push_back(board.pixel_of_point(point));
    std::vector<std::vector<std::uint32_t>> names;
    for (const glm::ivec2& click : clicks) names.push_back(board.picked(click));
    return board.drawn(names, clicks);
}

}
