#pragma once

#include <array>
#include <cmath>
#include <kit/picture.hpp>
#include <umbral/lighting/blinn_phong.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// The goal picture: a harbour at night. Lamps stand along the far shore, and the water draws each of them out into a
/// streak, as Blinn's highlights do on a surface that is seen at a low angle (Phong's stay round).
namespace umbral::lighting {

struct Lantern {
    glm::vec3 place;
    glm::vec3 color;
};

/// Varied, they stand elsewhere, with other colours.
inline std::vector<Lantern> lanterns(Variation vary = {})
{
    const float first_x = vary.near(-13.2F, 1.5F);
    const std::size_t first_color = vary.one_of(0, std::array{1, 2, 3});
    constexpr std::array<glm::vec3, 4> colors = {
        {{1.0F, 0.62F, 0.22F}, {1.0F, 0.78F, 0.45F}, {0.35F, 0.85F, 0.70F}, {1.0F, 0.34F, 0.22F}}};
    constexpr std::array<std::size_t, 9> choice = {0, 1, 0, 2, 1, 0, 3, 1, 0};
    std::vector<Lantern> all;
    for (std::size_t i = 0; i < choice.size(); ++i) {
        const float x = first_x + 3.3F * static_cast<float>(i);
        const float height = 2.35F + 0.5F * std::sin(2.3F * static_cast<float>(i));
        all.push_back({{x, height, -26}, colors[(first_color + choice[i]) % colors.size()]});
    }
    return all;
}

/// The water's normal: a few trains of small waves, longer to the eye than across.
inline glm::vec3 water_normal(const glm::vec3& place)
{
    glm::vec2 slope(0);
    constexpr std::array<glm::vec4, 5> waves = {{{0.6F, 2.9F, 0.020F, 0.0F},
                                                 {-0.9F, 4.3F, 0.018F, 1.7F},
                                                 {1.7F, 6.1F, 0.014F, 4.1F},
                                                 {-2.6F, 8.9F, 0.010F, 2.2F},
                                                 {4.1F, 11.3F, 0.006F, 5.3F}}};
    for (const glm::vec4& wave : waves) {
        const glm::vec2 along(wave);
        const float phase = along.x * place.x + along.y * place.z + wave.w;
        slope += wave.z * std::cos(phase) * glm::normalize(along);
    }
    return normalize(glm::vec3(-slope.x, 1, -slope.y));
}

/// What is seen above the horizon in a direction: a sky that is brighter below, the town's silhouette, and the lanterns
/// with their glow.
inline glm::vec3 night(const std::vector<Lantern>& lanterns, const glm::vec3& eye, const glm::vec3& direction)
{
    const float height = direction.y / -direction.z;
    const float x = direction.x / -direction.z;
    glm::vec3 light = glm::mix(glm::vec3(0.055F, 0.050F, 0.085F), glm::vec3(0.006F, 0.010F, 0.030F),
                               glm::smoothstep(0.0F, 0.32F, height));
    const float house = std::floor(x * 26);
    const float roof = 0.030F + 0.020F * glm::fract(std::sin(house * 12.9898F) * 43758.547F);
    if (height < roof) light = glm::vec3(0.004F, 0.004F, 0.008F);
    for (const Lantern& lantern : lanterns) {
        const glm::vec3 to = lantern.place - eye;
        const glm::vec2 away = glm::vec2(x, height) - glm::vec2(to.x, to.y) / -to.z;
        const float square = dot(away, away) * 1e4F;
        light += lantern.color * (0.05F / (0.35F + square) + (square < 0.5F ? 1.2F : 0.0F));
    }
    return light;
}

inline Image harbour(int width, int height, const Variation& vary = {})
{
    constexpr glm::vec3 eye(0, 1.35F, 0);
    const Material water{{}, {}, glm::vec3(0.004F, 0.006F, 0.010F), glm::vec3(0.75F), 420};
    constexpr Light moon{{0.1F, 1, -0.6F, 0}, {0.25F, 0.30F, 0.50F}};
    const std::vector<Lantern> all = lanterns(vary);
    Grid<glm::vec3> picture(2 * width, 2 * height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5F - glm::vec2(width, height)) / static_cast<float>(width);
            const glm::vec3 direction(0.56F * at.x, -0.56F * (at.y + 0.20F), -1);
            if (direction.y >= -1e-3F) {
                picture.at(x, y) = night(all, eye, direction);
                continue;
            }
            const glm::vec3 place = eye - eye.y / direction.y * direction;
            // Far waves are smaller than a pixel: they flatten out.
            const float flat = 1 / (1 + 0.0016F * dot(place, place));
            const glm::vec3 n = normalize(glm::mix(glm::vec3(0, 1, 0), water_normal(place), flat));
            const glm::vec3 sky = glm::mix(glm::vec3(0.010F, 0.013F, 0.028F), glm::vec3(0.003F, 0.005F, 0.014F),
                                           glm::clamp(-3 * direction.y, 0.0F, 1.0F));
            // The streaks of lanterns further aside do not reach this place.
            std::vector<Light> lights = {moon};
            for (const Lantern& lantern : all)
                if (std::abs(lantern.place.x / lantern.place.z - place.x / place.z) < 0.15F)
                    lights.push_back({glm::vec4(lantern.place, 1), lantern.color});
            picture.at(x, y) = blinn_phong_reflection(
                {place, n}, {sky, {}, water.diffuse, water.specular, water.shininess}, lights, glm::vec3(0), eye);
        }
    return halved(encoded(picture));
}

}
