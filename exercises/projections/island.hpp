#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/shapes.hpp>
#include <kit/stage.hpp>
#include <string_view>
#include <vector>

/// A scene for pictures of projections: an island of 8 x 8 blocks in the sea, with trees and a lighthouse.
namespace umbral::projections {

/// Sets the camera of a stage by both of its matrices.
inline void look_through(const Stage& stage, const glm::mat4& view, const glm::mat4& projection)
{
    stage.program().set("camera", projection * view);
    stage.program().set("eye", glm::vec3(glm::inverse(view)[3]));
}

/// Begins a panel of a picture: what is drawn from now on goes into this rectangle, which is filled with `sky` (sRGB)
/// and the largest depth first. In pixels of the framebuffer, which has twice the picture's size.
inline void begin_panel(const glm::ivec2& corner, const glm::ivec2& extent, const glm::vec3& sky)
{
    glViewport(corner.x, corner.y, extent.x, extent.y);
    glScissor(corner.x, corner.y, extent.x, extent.y);
    glEnable(GL_SCISSOR_TEST);
    glClearColor(sky.r, sky.g, sky.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

/// Round, along y from 0 to 1, with radius 1 below and `top` above, closed above.
inline shapes::Shape round_column(float top)
{
    constexpr int sides = 32;
    const auto around = [](float u, float radius, float height) {
        return glm::vec3(radius * std::sin(shapes::turn * u), height, radius * std::cos(shapes::turn * u));
    };
    shapes::Shape column = shapes::woven(sides, 1, [&](float u, float v) {
        const float radius = glm::mix(1.0F, top, v);
        return shapes::Vertex{around(u, radius, v), normalize(around(u, 1, 1 - top))};
    });
    const shapes::Shape lid = shapes::woven(sides, 1, [&](float u, float v) {
        return shapes::Vertex{around(u, (1 - v) * top, 1), glm::vec3(0, 1, 0)};
    });
    column.positions.insert(column.positions.end(), lid.positions.begin(), lid.positions.end());
    column.normals.insert(column.normals.end(), lid.normals.begin(), lid.normals.end());
    shapes::join_grid(column, sides, 1);
    return column;
}

/// The island stands on y = 0 within 4 of the y axis in x and z, and is up to 2.6 high.
class Island {
public:
    /// A context must be current while it lives.
    Island()
        : box_(uploaded(shapes::box())),
          column_(uploaded(round_column(0.78F))),
          cone_(uploaded(round_column(0.02F))),
          ball_(uploaded(shapes::icosphere(3)))
    {
        build_land();
        plant_trees();
        build_lighthouse({-2.5F, 0.38F, 2.5F});
    }

    /// Draws it on a square piece of sea, with the shadows there.
    void draw(const Stage& stage) const { draw(stage, 4.6F, 0); }

    /// Draws it in a sea that reaches to the horizon, where it fades into the sky (sRGB).
    void draw_at_sea(const Stage& stage, const glm::vec3& sky) const
    {
        stage.program().set("sky", glm::vec3(srgb_decoded(glm::dvec3(sky))));
        draw(stage, 40, 0.006F);
    }

private:
    void draw(const Stage& stage, float reach, float fade) const
    {
        const Finish sea{
            .color = {0.015F, 0.13F, 0.24F}, .gloss = 0.25F, .odd = glm::vec3(0.02F, 0.16F, 0.28F), .fade = fade};
        stage.draw_on({box_, slab(reach), sea}, things_);
    }

    /// The height of each block: 0 is sea, 1 sand, then meadow, wood, rock and snow. The farthest row first.
    static constexpr std::array<std::string_view, 8> heights = {"12332210", "23454321", "23565331", "12444322",
                                                                "01233221", "01122211", "11011110", "10000110"};

    static float height_of(char level) { return level == '0' ? 0.0F : 0.38F * static_cast<float>(level - '0'); }

    /// The middle of a block's upper side.
    static glm::vec3 middle_of(const glm::ivec2& cell)
    {
        const glm::vec2 corner(cell - 4);
        return {corner.x + 0.5F, height_of(heights[cell.y][cell.x]), corner.y + 0.5F};
    }

    void add(const gl::Mesh& mesh, const glm::vec3& place, const glm::vec3& size, const Finish& finish)
    {
        things_.push_back({mesh, glm::scale(glm::translate(glm::mat4(1), place), size), finish});
    }

    void build_land()
    {
        const glm::vec3 colors[] = {{0.78F, 0.60F, 0.30F}, {0.26F, 0.46F, 0.07F}, {0.11F, 0.30F, 0.08F},
                                    {0.30F, 0.26F, 0.24F}, {0.42F, 0.38F, 0.37F}, {0.88F, 0.92F, 0.97F}};
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 8; ++column) {
                const char level = heights[row][column];
                if (level == '0') continue;
                const glm::vec3 corner(column - 4, 0, row - 4);
                add(box_, corner, {1, height_of(level), 1}, {.color = colors[level - '1']});
            }
    }

    void plant_trees()
    {
        const glm::ivec2 firs[] = {{1, 0}, {0, 1}, {1, 2}, {5, 1}, {6, 2}, {7, 3}, {2, 4}, {4, 4}, {5, 4}, {3, 5}};
        for (const glm::ivec2& cell : firs) {
            const glm::vec3 place = middle_of(cell);
            add(column_, place, {0.07F, 0.2F, 0.07F}, {.color = {0.20F, 0.10F, 0.04F}});
            add(cone_, place + glm::vec3(0, 0.16F, 0), {0.34F, 0.55F, 0.34F}, {.color = {0.04F, 0.19F, 0.08F}});
            add(cone_, place + glm::vec3(0, 0.46F, 0), {0.25F, 0.48F, 0.25F}, {.color = {0.05F, 0.24F, 0.09F}});
        }
        const glm::ivec2 oaks[] = {{5, 5}, {6, 4}, {1, 3}, {0, 3}};
        for (const glm::ivec2& cell : oaks) {
            const glm::vec3 place = middle_of(cell);
            add(column_, place, {0.08F, 0.4F, 0.08F}, {.color = {0.22F, 0.11F, 0.05F}});
            add(ball_, place + glm::vec3(0, 0.62F, 0), glm::vec3(0.36F), {.color = {0.58F, 0.20F, 0.03F}});
        }
    }

    void build_lighthouse(glm::vec3 place)
    {
        const glm::vec3 red(0.62F, 0.04F, 0.03F);
        const glm::vec3 white(0.86F, 0.84F, 0.80F);
        float radius = 0.34F;
        for (int ring = 0; ring < 5; ++ring) {
            add(column_, place, {radius, 0.34F, radius}, {.color = ring % 2 == 0 ? white : red});
            place.y += 0.34F;
            radius *= 0.88F;
        }
        add(column_, place, {0.26F, 0.05F, 0.26F}, {.color = glm::vec3(0.08F)});
        add(column_, place + glm::vec3(0, 0.05F, 0), {0.13F, 0.24F, 0.13F}, {.color = {1.0F, 0.72F, 0.16F}});
        add(cone_, place + glm::vec3(0, 0.29F, 0), {0.22F, 0.2F, 0.22F}, {.color = red});
    }

    gl::Mesh box_;
    gl::Mesh column_;
    gl::Mesh cone_;
    gl::Mesh ball_;
    std::vector<Stage::Thing> things_;
};

}
