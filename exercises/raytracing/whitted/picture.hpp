#pragma once

#include "../cast.hpp"
#include "built_world.hpp"

/// The goal picture: what Whitted showed in 1979, a ball of glass and a mirror ball above a chessboard, and some more.
namespace umbral::raytracing::whitted {

inline glm::vec3 evening_sky(const glm::vec3& direction)
{
    const float height = direction == glm::vec3(0) ? 0 : normalize(direction).y;
    const glm::vec3 horizon(1.05F, 0.52F, 0.28F);
    const glm::vec3 zenith(0.05F, 0.12F, 0.36F);
    const glm::vec3 ground(0.10F, 0.07F, 0.11F);
    if (height < 0) return glm::mix(horizon, ground, std::min(1.0F, -6 * height));
    const glm::vec3 sky = glm::mix(horizon, zenith, std::pow(std::min(1.0F, 2.4F * height), 0.55F));
    const glm::vec3 sun = normalize(glm::vec3(-0.75F, 0.42F, -0.55F));
    return sky + glm::vec3(1.3F, 0.8F, 0.4F) * std::pow(std::max(0.0F, dot(normalize(direction), sun)), 40.0F);
}

/// A chessboard, the stripes of a beach ball, and marble.
inline glm::vec3 board_and_balls(std::uint32_t texture, const glm::vec2& uv)
{
    if (texture == 1) {
        const bool odd = (static_cast<int>(14 * uv.x) + static_cast<int>(14 * uv.y)) % 2 != 0;
        return odd ? glm::vec3(0.85F, 0.80F, 0.70F) : glm::vec3(0.16F, 0.03F, 0.04F);
    }
    if (texture == 2) {
        const int stripe = static_cast<int>(12 * uv.x) % 3;
        const glm::vec3 colors[] = {{0.90F, 0.88F, 0.82F}, {0.02F, 0.32F, 0.36F}, {0.95F, 0.42F, 0.05F}};
        return uv.y < 0.09F || uv.y > 0.91F ? colors[0] : colors[stripe];
    }
    const float wave = std::sin(30 * uv.y + 5 * std::sin(12.566371F * uv.x + 4 * uv.y));
    return glm::mix(glm::vec3(0.12F, 0.25F, 0.55F), glm::vec3(0.75F, 0.85F, 0.95F), 0.5F + 0.5F * wave);
}

inline Material painted(const glm::vec3& color, float shine, std::uint32_t texture)
{
    Material material;
    material.local = {{}, 0.06F * color, color, glm::vec3(shine), 60};
    material.texture = texture;
    return material;
}

inline Material mirrored(Material material, float share, const glm::vec3& color)
{
    material.mirrored = share;
    material.mirrored_color = color;
    return material;
}

inline Material clear(float share, float index, const glm::vec3& color)
{
    Material glass = mirrored(painted({0.01F, 0.01F, 0.01F}, 0.9F, 0), 0.10F, glm::vec3(1));
    glass.local.shininess = 100;
    glass.refracted = share;
    glass.refracted_color = color;
    glass.index = index;
    return glass;
}

inline BuiltWorld still_world()
{
    BuiltWorld world;
    world.sky = evening_sky;
    world.texture = board_and_balls;
    world.levels = 6;
    world.global = glm::vec3(0.004F, 0.004F, 0.008F);
    world.sources = {{{-4, 6, 4, 1}, {0.86F, 0.73F, 0.58F}}, {{5, 4, 3, 0}, {0.20F, 0.26F, 0.42F}}};
    world.panels.push_back(
        {{-7, 0, -10}, {0, 0, 14}, {14, 0, 0}, mirrored(painted(glm::vec3(1), 0.1F, 1), 0.12F, glm::vec3(1))});
    world.balls = {
        {{-0.75F, 1.35F, 1.1F}, 0.95F, clear(0.86F, 1.5F, {0.97F, 1, 0.98F})},
        {{1.25F, 1.2F, -0.9F}, 1.2F, mirrored(painted(glm::vec3(0.04F), 1, 0), 0.85F, {1, 0.96F, 0.90F})},
        {{-2.7F, 0.9F, -1.8F}, 0.9F, painted(glm::vec3(1), 0.5F, 2)},
        {{2.35F, 0.45F, 1.35F}, 0.45F, painted(glm::vec3(1), 0.7F, 3)},
        {{0.55F, 0.36F, 2.1F}, 0.36F, mirrored(painted({0.75F, 0.33F, 0.05F}, 1, 0), 0.25F, {1, 0.7F, 0.35F}), 0.28F},
        {{-2.15F, 0.3F, 1.9F}, 0.3F, clear(0.9F, 1.33F, {0.35F, 0.75F, 1})}};
    return world;
}

inline Image glass_and_mirrors(Variation& vary)
{
    const BuiltWorld world = still_world();
    const Camera camera = varied(vary, {{0.2F, 2.3F, 7.2F}, {0, 0.95F, 0}, 0.37F});
    return ray_traced(264, 208, camera, [&](const Ray& ray) {
        (void)world.take_rays();
        return light_along(world, ray, 1);
    });
}

}
