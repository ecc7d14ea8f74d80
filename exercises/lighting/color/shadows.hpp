#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <umbral/core/grid.hpp>
#include <umbral/lighting/color.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

#include "../soft_shadow.hpp"

/// The goal picture: balls before a wall in the light of a red, a green and a blue lamp. Where one lamp is hidden, the
/// other two mix: the shadows are cyan, magenta and yellow.
namespace umbral::lighting {

/// A ball of light of one color.
struct Source {
    glm::vec3 place;
    glm::vec3 color;
};

/// What stands before the wall, and lights it.
struct Stage {
    std::vector<Ball> balls = {{{0, 0.02F, 1.25F}, 0.52F}};
    std::array<Source, 3> sources = {{{{-2.1F, -1.3F, 5.2F}, {1, 0.03F, 0.02F}},
                                      {{0.0F, 2.5F, 5.2F}, {0.02F, 1, 0.03F}},
                                      {{2.1F, -1.3F, 5.2F}, {0.03F, 0.04F, 1}}}};
};

/// Varied, the lamps are turned about the middle, and so are the balls.
inline Stage stage(Variation vary = {})
{
    Stage all;
    const float first = vary.near(0.2F, 0.35F);
    for (int i = 0; i < 9; ++i) {
        const float angle = 0.698132F * static_cast<float>(i) + first;
        all.balls.push_back({{0.98F * std::cos(angle), 0.02F + 0.98F * std::sin(angle), 0.95F}, 0.13F});
    }
    const glm::mat3 turned = vary.turn({0, 0, 1}, 3);
    for (Source& source : all.sources) source.place = turned * source.place;
    return all;
}

inline constexpr float source_radius = 0.17F;

/// What arrives at a point with the normal `n`: one lamp for each source, and a little of the room's own light.
/// `itself` is the ball that the point lies on, or null.
inline std::vector<Lamp> lamps_at(const Stage& stage, const glm::vec3& place, const glm::vec3& n, float albedo,
                                  const Ball* itself)
{
    std::vector<Lamp> lamps = {{{0.5F, 0.45F, 0.55F}, 0.03F * albedo}};
    for (const Source& source : stage.sources) {
        const glm::vec3 to_source = source.place - place;
        const float distance = length(to_source);
        float amount = std::max(0.0F, dot(n, to_source) / distance) * 21 / (distance * distance);
        for (const Ball& ball : stage.balls)
            if (&ball != itself) amount *= share_seen(place, source.place, source_radius, ball);
        lamps.push_back({source.color, albedo * amount});
    }
    return lamps;
}

/// What the ray from the eye through a place of the wall sees there.
inline std::vector<Lamp> lamps_along(const Stage& stage, const glm::vec3& eye, const glm::vec3& wall)
{
    const glm::vec3 direction = normalize(wall - eye);
    float nearest = std::numeric_limits<float>::infinity();
    const Ball* hit = nullptr;
    for (const Ball& ball : stage.balls) {
        const glm::vec3 to_eye = eye - ball.centre;
        const float b = dot(to_eye, direction);
        const float discriminant = b * b - dot(to_eye, to_eye) + ball.radius * ball.radius;
        if (discriminant <= 0 || -b - std::sqrt(discriminant) >= nearest) continue;
        nearest = -b - std::sqrt(discriminant);
        hit = &ball;
    }
    if (hit == nullptr) return lamps_at(stage, wall, {0, 0, 1}, 1, nullptr);
    const glm::vec3 place = eye + nearest * direction;
    return lamps_at(stage, place, (place - hit->centre) / hit->radius, 0.85F, hit);
}

inline Image colored_shadows(int width, int height, const Variation& vary = {})
{
    const Stage all = stage(vary);
    constexpr glm::vec3 eye(0, 0, 6.5F);
    Image picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::vec3 light(0);
            for (int sample = 0; sample < 4; ++sample) {
                const glm::vec2 at = glm::vec2(x, y) + glm::vec2(sample % 2, sample / 2) * 0.5F + 0.25F;
                const glm::vec2 wall = (at - 0.5F * glm::vec2(width, height)) * (3.6F / static_cast<float>(height));
                light += 0.25F * add_lights(lamps_along(all, eye, {wall.x, -wall.y, 0}));
            }
            picture.at(x, y) = glm::u8vec4(to_pixel(light), 255);
        }
    return picture;
}

}
