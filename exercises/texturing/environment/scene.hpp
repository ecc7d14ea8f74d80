#pragma once

#include <array>
#include <kit/picture.hpp>
#include <string>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/texturing/environment.hpp>

#include "../support.hpp"

/// The goal picture of texturing/environment: three mirroring balls in a court at dusk. The left one shows a box map,
/// the middle one a panorama, the right one a spherical map, all three made of the same court.
namespace umbral::texturing {

/// The light that comes from a direction: floor, arcade and sky.
inline glm::vec3 court(const Grid<glm::vec4>& tiles, glm::vec3 direction)
{
    direction = normalize(direction);
    const float flat = std::max(length(glm::vec2(direction.x, direction.z)), 1e-4F);
    const float rise = direction.y / flat;  // height over distance
    const glm::vec3 sun = normalize(glm::vec3(-0.75F, 0.34F, -0.8F));
    const float towards_sun = std::max(0.0F, dot(direction, sun));
    glm::vec3 sky = mix(glm::vec3(1.0F, 0.50F, 0.22F), glm::vec3(0.05F, 0.13F, 0.36F),
                        glm::smoothstep(0.0F, 1.1F, std::max(rise, 0.0F)));
    sky += glm::vec3(1.0F, 0.6F, 0.25F) *
           (0.55F * std::pow(towards_sun, 14.0F) + 2.5F * glm::smoothstep(0.9975F, 0.9985F, towards_sun));

    constexpr float foot = -0.22F;  // where the arcade stands on the floor
    if (rise < foot) {
        const glm::vec2 at = glm::vec2(direction.x, -direction.z) / (-rise * flat) * 0.9F;
        const glm::vec3 tile(lookup(tiles, {Filter::bilinear, Wrap::repeat, Wrap::repeat}, at));
        const float shade = 0.55F + 0.35F * std::pow(towards_sun, 1.0F);
        return tile * shade *
               mix(glm::vec3(1.0F, 0.75F, 0.55F), glm::vec3(0.6F, 0.7F, 1.0F), glm::smoothstep(-0.2F, -2.0F, rise));
    }
    constexpr float top = 0.52F;
    if (rise > top) return sky;
    // Sixteen horseshoe arches.
    const float turn = std::atan2(direction.x, -direction.z) * 16 / 6.2831853F;
    const float across = (turn - std::floor(turn) - 0.5F) * 0.39F;
    const float up = rise - 0.14F;
    const float radius = length(glm::vec2(across, up));
    const bool open = radius < 0.152F || (up < 0 && std::abs(across) < 0.118F);
    if (open) return rise > -0.12F ? sky * 0.95F : mix(glm::vec3(0.10F, 0.13F, 0.05F), sky, 0.25F);
    glm::vec3 stone(0.60F, 0.44F, 0.31F);
    if (up > -0.03F && radius < 0.185F) {
        // Wedge stones, red and white in turn.
        const bool red = std::fmod(std::floor((std::atan2(up, across) + 6.2831853F) * 4.2F), 2.0F) == 0;
        stone = red ? glm::vec3(0.48F, 0.10F, 0.05F) : glm::vec3(0.74F, 0.64F, 0.50F);
    }
    if (up < -0.05F && std::abs(across) > 0.13F)
        stone = glm::vec3(0.70F, 0.62F, 0.54F) * (1.25F - 3.0F * (0.195F - std::abs(across)));
    if (rise > 0.40F)
        stone = rise > 0.475F ? glm::vec3(0.30F, 0.15F, 0.08F)
                              : glm::vec3(0.03F, 0.12F, 0.30F) +
                                    0.35F * (std::fmod(std::floor((turn + 99) * 8), 2.0F) == 0 ? 1.0F : 0.0F);
    const float facing =
        0.5F - 0.5F * dot(normalize(glm::vec2(direction.x, direction.z)), normalize(glm::vec2(sun.x, sun.z)));
    return stone * mix(glm::vec3(0.20F, 0.22F, 0.34F), glm::vec3(1.15F, 0.78F, 0.50F), facing);
}

/// The court in all three kinds of map. A map's pixels are asked for by their centres, v upwards.
struct CourtMaps {
    std::array<Grid<glm::vec4>, 6> box;
    Grid<glm::vec4> panorama, sphere;
};

inline CourtMaps court_maps(const Grid<glm::vec4>& tiles, const glm::mat3& turned)
{
    const auto made = [&](int width, int height, const auto& direction) {
        Grid<glm::vec4> map(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const glm::vec2 uv = (glm::vec2(x, height - 1 - y) + 0.5F) / glm::vec2(width, height);
                map.at(x, y) = glm::vec4(court(tiles, turned * direction(uv)), 1);
            }
        return map;
    };
    CourtMaps maps;
    for (std::size_t face = 0; face < 6; ++face)
        maps.box[face] = made(128, 128, [&](glm::vec2 uv) { return box_direction({static_cast<BoxFace>(face), uv}); });
    maps.panorama = made(512, 256, [](glm::vec2 uv) { return panorama_direction(uv); });
    maps.sphere = made(256, 256, [](glm::vec2 uv) { return sphere_direction(uv); });
    return maps;
}

inline glm::vec3 seen_in(const CourtMaps& maps, int kind, const glm::vec3& direction)
{
    constexpr Sampler clamped{Filter::bilinear, Wrap::clamp_to_edge, Wrap::clamp_to_edge};
    if (kind == 0) {
        const BoxPlace place = box_place(direction);
        const auto face = static_cast<std::size_t>(place.face);
        return face < 6 ? glm::vec3(lookup(maps.box[face], clamped, place.uv)) : glm::vec3(0);
    }
    if (kind == 1)
        return lookup(maps.panorama, {Filter::bilinear, Wrap::repeat, Wrap::clamp_to_edge}, panorama_place(direction));
    return lookup(maps.sphere, clamped, sphere_place(direction));
}

/// One question, told in words, for all pixels. Varied, the court is turned.
inline Image picture(Recorder& out, int width, int height, Variation vary = {})
{
    ask_in_words(out, [&] {
        return "// three balls, " + std::to_string(width) + " x " + std::to_string(height) +
               " pixels: maps made by the three ..._direction, and seen by mirrored_direction and the three ..._place";
    });
    const Grid<glm::vec4> tiles = star_tile(64);
    const glm::mat3 turned = vary.turn({0, 1, 0}, 3);
    const CourtMaps maps = court_maps(tiles, turned);
    struct Ball {
        glm::vec3 centre;
        float radius;
        glm::vec3 tint;
    };
    const Ball balls[] = {{{-1.45F, -0.05F, -0.2F}, 0.72F, {0.96F, 0.97F, 1.0F}},
                          {{0, 0.12F, -0.9F}, 0.98F, {1.0F, 0.80F, 0.42F}},
                          {{1.5F, -0.1F, -0.1F}, 0.7F, {0.98F, 0.72F, 0.62F}}};
    const glm::vec3 eye(0, 0.1F, 5);
    Image image(2 * width, 2 * height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5F - glm::vec2(width, height)) / static_cast<float>(2 * height);
            const glm::vec3 direction = normalize(glm::vec3(0.78F * at.x, -0.78F * at.y, -1));
            float nearest = 1e9F;
            glm::vec3 color(0);
            for (int kind = 0; kind < 3; ++kind) {
                const Ball& ball = balls[kind];
                const glm::vec3 to_eye = eye - ball.centre;
                const float half = dot(to_eye, direction);
                const float discriminant = half * half - dot(to_eye, to_eye) + ball.radius * ball.radius;
                const float t = discriminant > 0 ? -half - std::sqrt(discriminant) : 1e9F;
                if (t >= nearest) continue;
                nearest = t;
                const glm::vec3 n = (to_eye + t * direction) / ball.radius;
                const glm::vec3 mirrored = mirrored_direction(-direction, n);
                const float grazing = std::pow(1 - std::max(0.0F, -dot(n, direction)), 4.0F);
                color = seen_in(maps, kind, mirrored) * mix(ball.tint, glm::vec3(1), grazing) * 0.94F;
            }
            image.at(x, y) = pixel_of(nearest < 1e9F ? color : court(tiles, turned * direction));
        }
    return halved(image);
}

}
