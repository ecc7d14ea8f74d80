#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/shapes.hpp>
#include <kit/stage.hpp>
#include <span>
#include <vector>

/// A scene to walk about in: a round temple without a roof, a golden knot on a pedestal in its middle, and cypresses.
namespace umbral::interaction {

/// A point of a profile: radius and height.
using ProfilePoint = glm::vec2;

/// The profile turned about the y axis. It goes up with the outside on the right; each of its pieces is flat, with
/// edges between them. `flutes` grooves, 0 or more, run up all of it.
inline shapes::Shape turned_profile(std::span<const ProfilePoint> profile, int sides, int flutes = 0)
{
    shapes::Shape shape;
    const auto place = [&](float u, const ProfilePoint& point) {
        const float groove = std::abs(std::sin(0.5F * static_cast<float>(flutes) * shapes::turn * u));
        const float radius = point.x * (flutes > 0 ? 0.88F + 0.12F * groove : 1.0F);
        return glm::vec3(radius * std::sin(shapes::turn * u), point.y, radius * std::cos(shapes::turn * u));
    };
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const shapes::Shape piece = shapes::surface(
            sides, 1, [&](float u, float v) { return place(u, glm::mix(profile[i], profile[i + 1], v)); });
        shape.positions.insert(shape.positions.end(), piece.positions.begin(), piece.positions.end());
        shape.normals.insert(shape.normals.end(), piece.normals.begin(), piece.normals.end());
        shapes::join_grid(shape, sides, 1);
    }
    return shape;
}

/// Stands on y = 0 round the y axis, within 4.2 of it; floor at 0.36, columns to 2.9, ring to 3.4. The knot's middle is
/// `knot_middle`.
class Temple {
public:
    static constexpr glm::vec3 knot_middle{0, 1.75F, 0};

    /// A context must be current while it lives.
    Temple()
        : box_(uploaded(shapes::box())),
          steps_(uploaded(turned_profile(steps_profile, 64))),
          column_(uploaded(turned_profile(column_profile, 80, 16))),
          ends_(uploaded(turned_profile(ends_profile, 40))),
          ring_(uploaded(turned_profile(ring_profile, 72))),
          pedestal_(uploaded(turned_profile(pedestal_profile, 48))),
          knot_(uploaded(shapes::trefoil(200, 20, 0.17F))),
          cypress_(uploaded(turned_profile(cypress_profile, 24)))
    {
        const Finish marble{.color = {0.80F, 0.74F, 0.64F}, .gloss = 0.12F};
        add(steps_, glm::mat4(1), {.color = {0.62F, 0.56F, 0.47F}});
        for (int i = 0; i < columns; ++i) {
            const glm::mat4 at = around((static_cast<float>(i) + 0.5F) / columns, 2.75F, 0.36F);
            add(column_, at, marble);
            add(ends_, at, marble);
        }
        add(ring_, glm::mat4(1), marble);
        add(pedestal_, glm::translate(glm::mat4(1), {0, 0.36F, 0}), {.color = {0.34F, 0.06F, 0.05F}, .gloss = 0.25F});
        add(knot_, glm::scale(glm::translate(glm::mat4(1), knot_middle), glm::vec3(0.62F)),
            {.color = {0.86F, 0.52F, 0.10F}, .gloss = 0.7F});
        for (const auto& [turn, distance, height] : cypresses)
            add(cypress_, glm::scale(around(turn, distance, 0), {0.9F, height, 0.9F}),
                {.color = {0.05F, 0.17F, 0.06F}});
    }

    /// Draws it on ground that reaches to the horizon, where it fades into the sky (sRGB).
    void draw(const Stage& stage, const glm::vec3& sky) const
    {
        stage.program().set("sky", glm::vec3(srgb_decoded(glm::dvec3(sky))));
        const Finish ground{.color = {0.33F, 0.36F, 0.14F}, .odd = glm::vec3(0.30F, 0.33F, 0.12F), .fade = 0.003F};
        stage.draw_on({box_, slab(45), ground}, things_);
    }

private:
    static constexpr int columns = 12;
    /// A radius that is nearly none: at none a surface has no tangent round the axis, and no normal.
    static constexpr float axis = 0.01F;
    static constexpr std::array<ProfilePoint, 7> steps_profile{
        {{3.8F, 0}, {3.8F, 0.12F}, {3.55F, 0.12F}, {3.55F, 0.24F}, {3.3F, 0.24F}, {3.3F, 0.36F}, {axis, 0.36F}}};
    static constexpr std::array<ProfilePoint, 4> column_profile{
        {{0.21F, 0.16F}, {0.215F, 0.9F}, {0.195F, 1.6F}, {0.17F, 2.3F}}};
    static constexpr std::array<ProfilePoint, 11> ends_profile{{{0.29F, 0},
                                                                {0.29F, 0.08F},
                                                                {0.24F, 0.1F},
                                                                {0.24F, 0.16F},
                                                                {0.1F, 0.16F},
                                                                {0.1F, 2.3F},
                                                                {0.2F, 2.3F},
                                                                {0.2F, 2.34F},
                                                                {0.31F, 2.46F},
                                                                {0.31F, 2.54F},
                                                                {axis, 2.54F}}};
    static constexpr std::array<ProfilePoint, 9> ring_profile{{{2.45F, 2.9F},
                                                               {3.05F, 2.9F},
                                                               {3.05F, 3.12F},
                                                               {3.12F, 3.14F},
                                                               {3.12F, 3.22F},
                                                               {3.25F, 3.32F},
                                                               {3.25F, 3.4F},
                                                               {2.45F, 3.4F},
                                                               {2.45F, 2.9F}}};
    static constexpr std::array<ProfilePoint, 8> pedestal_profile{{{0.62F, 0},
                                                                   {0.62F, 0.1F},
                                                                   {0.46F, 0.16F},
                                                                   {0.4F, 0.55F},
                                                                   {0.5F, 0.62F},
                                                                   {0.58F, 0.66F},
                                                                   {0.58F, 0.74F},
                                                                   {axis, 0.74F}}};
    static constexpr std::array<ProfilePoint, 7> cypress_profile{
        {{axis, 0}, {0.3F, 0.1F}, {0.42F, 0.28F}, {0.38F, 0.5F}, {0.26F, 0.74F}, {0.1F, 0.94F}, {axis, 1}}};
    /// Where they stand: turns round the y axis from +z, distance from it; and how high they are.
    struct Cypress {
        float turn;
        float distance;
        float height;
    };
    static constexpr std::array<Cypress, 12> cypresses{{{0.02F, 9.0F, 3.4F},
                                                        {0.17F, 5.6F, 3.0F},
                                                        {0.24F, 8.2F, 4.2F},
                                                        {0.33F, 6.0F, 3.6F},
                                                        {0.42F, 7.5F, 4.4F},
                                                        {0.48F, 5.8F, 3.3F},
                                                        {0.57F, 8.4F, 4.6F},
                                                        {0.64F, 6.2F, 3.7F},
                                                        {0.71F, 7.8F, 4.0F},
                                                        {0.79F, 5.7F, 3.1F},
                                                        {0.88F, 8.0F, 3.9F},
                                                        {0.95F, 9.5F, 3.6F}}};

    static glm::mat4 around(float turn, float distance, float height)
    {
        const float angle = shapes::turn * turn;
        return glm::translate(glm::mat4(1), {distance * std::sin(angle), height, distance * std::cos(angle)});
    }

    void add(const gl::Mesh& mesh, const glm::mat4& model, const Finish& finish)
    {
        things_.push_back({mesh, model, finish});
    }

    gl::Mesh box_;
    gl::Mesh steps_;
    gl::Mesh column_;
    gl::Mesh ends_;
    gl::Mesh ring_;
    gl::Mesh pedestal_;
    gl::Mesh knot_;
    gl::Mesh cypress_;
    std::vector<Stage::Thing> things_;
};

/// One of the pictures in a picture: where it lies, from the lower left corner, in pixels of the whole.
struct Panel {
    glm::ivec2 corner;
    glm::ivec2 extent;
};

/// The temple in a panel, under its own sky, through a view matrix; the field of view is `fovy_degrees` high.
inline void draw_temple(const Stage& stage, const Temple& temple, const Panel& panel, const glm::mat4& view,
                        float fovy_degrees)
{
    constexpr glm::vec3 sky(0.66F, 0.80F, 0.92F);
    // The framebuffer is twice as large as the picture.
    const glm::ivec2 corner = 2 * panel.corner;
    const glm::ivec2 extent = 2 * panel.extent;
    glEnable(GL_SCISSOR_TEST);
    glScissor(corner.x, corner.y, extent.x, extent.y);
    glViewport(corner.x, corner.y, extent.x, extent.y);
    glClearColor(sky.r, sky.g, sky.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    stage.look(view, fovy_degrees, static_cast<float>(extent.x) / static_cast<float>(extent.y));
    temple.draw(stage, sky);
    glDisable(GL_SCISSOR_TEST);
}

}
