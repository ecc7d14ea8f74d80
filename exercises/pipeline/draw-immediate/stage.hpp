#pragma once

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <kit/double_frame.hpp>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/immediate.hpp>
#include <umbral/record/ask.hpp>

#include "../varied.hpp"

/// Where the cases draw, and what: the tables of problems 1.1 and 1.2.
namespace umbral::pipeline {

/// Where the fixed functionality draws in clip coordinates.
class Stage {
public:
    explicit Stage(int size) : frame_(size, size)
    {
        glUseProgram(0);
        glLineWidth(5);
    }

    void clear() const { frame_.clear(); }
    [[nodiscard]] Image pixels() const { return frame_.large().read_pixels(); }
    [[nodiscard]] Image picture() const { return frame_.picture(); }

private:
    DoubleFrame frame_;
};

/// Problem 1.1: the corners of a regular polygon of radius 1, the first one at the angle `turn`.
inline std::vector<glm::vec2> polygon(int corners, float turn = 0)
{
    std::vector<glm::vec2> table;
    for (int i = 0; i < corners; ++i) {
        const float angle = turn + 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(corners);
        table.emplace_back(std::cos(angle), std::sin(angle));
    }
    return table;
}

/// Problem 1.2: its centre, and triangles round it.
struct Fan {
    std::vector<glm::vec2> positions;
    std::vector<std::uint32_t> indices;
};

/// Triangles come `stride` after each other round the centre, each begun at another of its corners, and every second
/// one clockwise; without a common divisor with `corners`, each comes once. Of ten and more the last two are left out,
/// so that the place between shows what is drawn beside these triangles. `unused` positions come first that no triangle
/// has, and `idle` triangles whose corners are all the first position.
inline Fan fan(int corners, int stride, int unused = 0, int idle = 0, float turn = 0)
{
    Fan result{std::vector<glm::vec2>(static_cast<std::size_t>(unused), glm::vec2(0.9F)),
               std::vector<std::uint32_t>(3 * static_cast<std::size_t>(idle), 0U)};
    const std::vector<glm::vec2> rim = polygon(corners, turn);
    result.positions.insert(result.positions.end(), rim.begin(), rim.end());
    result.positions.emplace_back(0, 0);
    for (int i = 0; i < (corners < 10 ? corners : corners - 2); ++i) {
        const int k = i * stride % corners;
        std::array<int, 3> triangle = {k, (k + 1) % corners, corners};
        if (i % 2 == 1) std::swap(triangle[0], triangle[1]);
        for (int corner = 0; corner < 3; ++corner)
            result.indices.push_back(
                static_cast<std::uint32_t>(unused + triangle[static_cast<std::size_t>((i + 1 + corner) % 3)]));
    }
    return result;
}

/// One use of the unit: a regular polygon somewhere.
struct Piece {
    int corners = 3;
    bool cut = false;  ///< into triangles
    glm::vec3 place{0};
    float radius = 1;
    float turn = 0;
    glm::vec3 fill{1};
    glm::vec3 edges{0};
    int unused = 0;  ///< of triangles: so many positions come first that no triangle has
    int idle = 0;    ///< of triangles: so many come first whose corners are all one, the first position
    float size = 1;  ///< of its table, whatever its radius
};

/// Where a point of the table goes, which is turned already. All of a piece has one depth.
inline glm::mat4 model_of(const Piece& piece)
{
    return scale(translate(glm::mat4(1), piece.place),
                 glm::vec3(piece.radius / piece.size, piece.radius / piece.size, 1));
}

inline std::vector<glm::vec2> scaled(std::vector<glm::vec2> table, float size)
{
    for (glm::vec2& place : table) place *= size;
    return table;
}

inline void draw(Recorder& out, const Piece& piece)
{
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(value_ptr(model_of(piece)));
    if (piece.cut) {
        const Fan unit = fan(piece.corners, piece.corners % 2 == 1 ? 2 : 1, piece.unused, piece.idle, piece.turn);
        ask<draw_triangles>(out, scaled(unit.positions, piece.size), unit.indices, piece.fill, piece.edges);
    } else {
        ask<draw_polygon>(out, scaled(polygon(piece.corners, piece.turn), piece.size), piece.fill, piece.edges);
    }
}

/// The piece elsewhere, turned, with a corner more or less, in other colours.
inline Piece varied(Variation& vary, Piece piece)
{
    piece.corners = vary.near(piece.corners, 1);
    for (int axis = 0; axis < 2; ++axis) piece.place[axis] = vary.near(piece.place[axis], 0.05F);
    piece.turn = vary.near(piece.turn, 0.5F);
    piece.fill = other_color(vary, piece.fill);
    piece.edges = other_color(vary, piece.edges);
    return piece;
}

/// A sunflower's head: polygons along Fermat's spiral, each turned by the golden angle against the one before. `turn`
/// and `hue` turn the whole head and all hues.
inline std::vector<Piece> sunflower(int count, float turn = 0, float hue = 0)
{
    constexpr float golden_angle = 2.3999632F;
    std::vector<Piece> pieces;
    for (int i = 0; i < count; ++i) {
        const float outwards = std::sqrt((static_cast<float>(i) + 0.5F) / static_cast<float>(count));
        const float angle = golden_angle * static_cast<float>(i) + turn;
        const float reach = 0.9F * std::pow(outwards, 1.2F);
        const glm::vec3 fill = rainbow(0.12F + hue + 0.62F * outwards, 0.85F - 0.3F * static_cast<float>(i % 2),
                                       0.62F + 0.3F * static_cast<float>(i % 2));
        pieces.push_back({3 + i % 6,
                          i % 2 == 0,
                          {reach * std::cos(angle), reach * std::sin(angle), 0},
                          0.045F + 0.042F * outwards,
                          angle,
                          fill,
                          glm::mix(fill, glm::vec3(1), 0.65F)});
    }
    return pieces;
}

inline Piece random_piece(Random& random, float depth)
{
    Piece piece;
    piece.corners = 3 + static_cast<int>(random.below(9));
    piece.cut = random.below(2) == 0;
    const float x = random.uniform(-0.6F, 0.6F);
    piece.place = {x, random.uniform(-0.6F, 0.6F), depth};
    piece.radius = random.uniform(0.2F, 0.38F);
    piece.turn = random.uniform(0, 6.28F);
    piece.fill = rainbow(random.uniform(), 0.8F, 0.8F);
    piece.edges = rainbow(random.uniform(), 0.25F, 1);
    if (random.below(4) == 0) piece.unused = 70'000;
    return piece;
}

}
