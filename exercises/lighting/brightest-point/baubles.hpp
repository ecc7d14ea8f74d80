#pragma once

#include <array>
#include <kit/picture.hpp>
#include <limits>
#include <umbral/lighting/brightest_point.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// The goal picture: glass baubles in the light of three lamps. Stars are highlights; gold leaf is painted round the
/// brightest place that is seen of each bauble, filled if no place of it is brighter, a ring if a brighter one is on
/// the other side.
namespace umbral::lighting {

struct Bauble {
    Sphere sphere;
    glm::vec3 color{1};
};

inline std::vector<Bauble> hung_baubles()
{
    constexpr glm::vec3 red(0.55F, 0.02F, 0.03F);
    constexpr glm::vec3 blue(0.02F, 0.10F, 0.42F);
    constexpr glm::vec3 green(0.01F, 0.24F, 0.12F);
    constexpr glm::vec3 plum(0.26F, 0.02F, 0.25F);
    constexpr glm::vec3 silver(0.36F, 0.38F, 0.42F);
    return {{{{-3.05F, 0.55F, 0.0F}, 0.80F}, red},     {{{-1.05F, -0.55F, 0.6F}, 1.00F}, blue},
            {{{1.15F, 0.65F, 0.2F}, 0.86F}, green},    {{{3.05F, -0.35F, 0.4F}, 0.92F}, red},
            {{{-2.55F, -1.55F, -0.6F}, 0.58F}, plum},  {{{0.75F, -1.70F, -0.2F}, 0.60F}, silver},
            {{{-0.75F, 1.50F, -1.0F}, 0.52F}, silver}, {{{2.60F, 1.62F, -1.2F}, 0.50F}, plum},
            {{{-4.35F, -0.85F, -1.4F}, 0.55F}, green}, {{{4.45F, 1.05F, -1.5F}, 0.56F}, blue}};
}

/// Adds a star with four rays to a picture of light; `size` in pixels.
inline void add_star(Grid<glm::vec3>& picture, const glm::vec2& place, const glm::vec3& color, float size)
{
    const auto reach = static_cast<int>(6 * size);
    const glm::ivec2 middle(place);
    for (int y = std::max(0, middle.y - reach); y < std::min(picture.height, middle.y + reach); ++y)
        for (int x = std::max(0, middle.x - reach); x < std::min(picture.width, middle.x + reach); ++x) {
            const glm::vec2 d = glm::abs(glm::vec2(x, y) + 0.5F - place) / size;
            const float core = 3 * std::exp(-1.5F * dot(d, d));
            const float rays = std::exp(-1.1F * d.x - 14 * d.y) + std::exp(-1.1F * d.y - 14 * d.x);
            picture.at(x, y) += color * (core + 1.6F * rays + 0.10F * std::exp(-0.8F * length(d)));
        }
}

/// A light of the tree, out of focus: a disc.
struct BlurredLight {
    glm::vec2 place;
    float radius;
    glm::vec3 color;
};

inline std::vector<BlurredLight> blurred_lights()
{
    constexpr std::array<glm::vec3, 3> colors = {
        {{0.10F, 0.045F, 0.012F}, {0.016F, 0.030F, 0.075F}, {0.075F, 0.014F, 0.020F}}};
    std::vector<BlurredLight> all;
    for (std::size_t i = 0; i < 46; ++i) {
        const auto k = static_cast<float>(i);
        const auto hashed = [&](float seed) { return glm::fract(43758.547F * std::sin(seed + 12.9898F * k)); };
        const glm::vec2 place(10.8F * hashed(1) - 5.4F, 7.0F * hashed(2) - 3.5F);
        all.push_back({place, 0.10F + 0.26F * hashed(3), colors[i % 3]});
    }
    return all;
}

/// The night behind the baubles, with those lights.
inline glm::vec3 night(const std::vector<BlurredLight>& lights, const glm::vec2& at)
{
    glm::vec3 sum = glm::mix(glm::vec3(0.010F, 0.014F, 0.030F), glm::vec3(0.030F, 0.012F, 0.020F),
                             glm::clamp(0.5F + 0.25F * at.y, 0.0F, 1.0F));
    for (const BlurredLight& light : lights) {
        const glm::vec2 to = at - light.place;
        if (dot(to, to) < light.radius * light.radius)
            sum += light.color * (1 - glm::smoothstep(0.86F * light.radius, light.radius, length(to)));
    }
    return sum;
}

/// Varied, the lamps are turned about the tree.
inline Image baubles(int width, int height, Variation vary = {})
{
    constexpr glm::vec3 eye(0, 0, 12);
    constexpr float half_width = 0.44F;  // of the picture, at a distance of 1
    std::array<Light, 3> lamps = {{{{-5.0F, 5.0F, 5.5F, 1}, {1.00F, 0.82F, 0.55F}},
                                   {{6.5F, 2.0F, 4.0F, 1}, {0.22F, 0.32F, 0.62F}},
                                   {{1.0F, -6.0F, 2.0F, 1}, {0.30F, 0.10F, 0.09F}}}};
    const glm::mat4 turned(vary.turn({0, 0, 1}, 1));
    for (Light& lamp : lamps) lamp.position = turned * lamp.position;
    const std::vector<Bauble> all = hung_baubles();
    const std::vector<BlurredLight> blurred = blurred_lights();
    struct Leaf {
        glm::vec3 normal{0};
        float inside = 2;  // of cosines: gold from here
    };
    std::vector<Leaf> leaves(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Sphere& sphere = all[i].sphere;
        // Gold leaf for the lamp behind the tree, which lights the far side of most.
        const Light lamp{{-3.0F, 3.4F, -4.5F, 1}};
        const std::optional<glm::vec3> best = brightest_seen(sphere, i % 2 == 0 ? lamps[0] : lamp, eye);
        if (!best) continue;
        const bool is_best = is_seen(sphere, brightest_diffuse(sphere, i % 2 == 0 ? lamps[0] : lamp), eye);
        leaves[i] = {normalize(*best - sphere.centre), is_best ? 2.0F : 0.955F};
    }

    Grid<glm::vec3> picture(2 * width, 2 * height);
    Grid<int> owner(2 * width, 2 * height);
    const float pixels = static_cast<float>(width) / half_width;  // at a distance of 1
    const glm::vec2 centre(width, height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5F - centre) / pixels;
            const glm::vec3 ray = normalize(glm::vec3(at.x, -at.y, -1));
            glm::vec3 light = night(blurred, 12.0F * glm::vec2(at.x, -at.y));
            float nearest = std::numeric_limits<float>::infinity();
            owner.at(x, y) = -1;
            for (std::size_t i = 0; i < all.size(); ++i) {
                const Sphere& sphere = all[i].sphere;
                const glm::vec3 to = sphere.centre - eye;
                const float along = dot(to, ray);
                const float square = sphere.radius * sphere.radius - dot(to, to) + along * along;
                if (square <= 0 || along - std::sqrt(square) >= nearest) {
                    // A thread from the top.
                    const glm::vec3 place = eye + ray * (sphere.centre.z - eye.z) / ray.z;
                    if (sphere.centre.z - eye.z > -nearest && owner.at(x, y) < 0 && place.y > sphere.centre.y &&
                        std::abs(place.x - sphere.centre.x) < 0.012F)
                        light += glm::vec3(0.05F, 0.04F, 0.03F);
                    continue;
                }
                nearest = along - std::sqrt(square);
                owner.at(x, y) = static_cast<int>(i);
                const glm::vec3 place = eye + nearest * ray;
                const glm::vec3 n = (place - sphere.centre) / sphere.radius;
                const float facing = -dot(n, ray);
                const float cosine = dot(n, leaves[i].normal);
                const bool is_gold = cosine > 0.90F && cosine < leaves[i].inside;
                const glm::vec3 color = is_gold ? glm::vec3(0.80F, 0.48F, 0.10F) : all[i].color;
                light = 0.03F * color;
                for (const Light& lamp : lamps)
                    light += lamp.color * color * std::max(0.0F, dot(n, normalize(glm::vec3(lamp.position) - place)));
                const glm::vec3 mirrored = ray + 2 * facing * n;
                const float fresnel = 0.06F + 0.94F * std::pow(1 - std::max(0.0F, facing), 5.0F);
                light += fresnel * 4.0F * night(blurred, 5.0F * glm::vec2(mirrored.x, mirrored.y));
            }
            picture.at(x, y) = light;
        }
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const Light& lamp : lamps) {
            const std::optional<glm::vec3> glint = brightest_specular(all[i].sphere, lamp, eye);
            if (!glint) continue;
            const glm::vec3 from_eye = *glint - eye;
            const glm::vec2 place = centre + pixels / -from_eye.z * glm::vec2(from_eye.x, -from_eye.y);
            // Not a number is not inside either.
            const bool is_inside =
                glm::all(greaterThanEqual(place, glm::vec2(0))) && glm::all(lessThan(place, 2.0F * centre));
            if (is_inside &&
                static_cast<std::size_t>(owner.at(static_cast<int>(place.x), static_cast<int>(place.y))) == i)
                add_star(picture, place, 1.3F * lamp.color, 3.0F + 4.5F * all[i].sphere.radius);
        }
    return halved(encoded(picture));
}

}
