#include "textures.hpp"

#include <cmath>
#include <functional>
#include <umbral/core/random.hpp>
#include <vector>

namespace umbral::bench::scenes {
namespace {

Image textured(int size, const std::function<glm::vec4(glm::vec2)>& color)
{
    Image image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const glm::vec2 uv = (glm::vec2(x, y) + 0.5F) / static_cast<float>(size);
            image.at(x, y) = glm::u8vec4(glm::clamp(color(uv), 0.0F, 1.0F) * 255.0F + 0.5F);
        }
    return image;
}

glm::vec3 hue(float t) { return 0.5F + 0.5F * glm::cos(6.2831853F * (t + glm::vec3(0, 0.33F, 0.67F))); }

}

Image tiles(int size, int cells, const glm::vec3& first, const glm::vec3& second)
{
    return textured(size, [&](glm::vec2 uv) {
        const glm::vec2 cell = uv * static_cast<float>(cells);
        const glm::vec2 in_cell = glm::fract(cell);
        const bool odd = (static_cast<int>(cell.x) + static_cast<int>(cell.y)) % 2 != 0;
        if (in_cell.x + in_cell.y < 0.3F) return glm::vec4(0.75F, 0.25F, 0.15F, 1);
        return glm::vec4(odd ? first : second, 1);
    });
}

Image weave(int size)
{
    Random random(5);
    std::vector<glm::vec3> warp;
    std::vector<glm::vec3> weft;
    for (int i = 0; i < size; ++i) {
        warp.push_back(hue(random.uniform()) * random.uniform(0.5F, 1));
        weft.push_back(hue(random.uniform(0, 0.4F)) * random.uniform(0.3F, 1));
    }
    return textured(size, [&](glm::vec2 uv) {
        const int x = static_cast<int>(uv.x * static_cast<float>(size));
        const int y = static_cast<int>(uv.y * static_cast<float>(size));
        const bool above = (x / 2 + 2 * (y / 2)) % 5 < 2;
        const glm::vec3 thread = above ? warp[static_cast<std::size_t>(x)] : weft[static_cast<std::size_t>(y)];
        return glm::vec4(thread * (x % 2 == y % 2 ? 1.0F : 0.72F), 1);
    });
}

Image painting(int size)
{
    Random random(11);
    struct Disc {
        glm::vec2 at;
        float radius;
        glm::vec3 color;
    };
    std::vector<Disc> discs;
    for (int i = 0; i < 40; ++i) {
        const float x = random.uniform();
        const float y = random.uniform();
        const float radius = random.uniform(0.03F, 0.12F);
        discs.push_back({{x, y}, radius, hue(random.uniform()) * random.uniform(0.6F, 1)});
    }
    return textured(size, [&](glm::vec2 uv) {
        glm::vec3 color = glm::mix(glm::vec3(0.15F, 0.35F, 0.55F), glm::vec3(0.95F, 0.75F, 0.45F), uv.y);
        if (std::abs(glm::fract(7 * uv.x + 2 * uv.y) - 0.5F) < 0.08F) color = glm::vec3(0.9F, 0.9F, 0.95F);
        for (const Disc& disc : discs)
            if (const float d = glm::length(uv - disc.at); d < disc.radius)
                color = disc.color * (1 - 0.5F * d / disc.radius);
        return glm::vec4(color, 1);
    });
}

Image leaves(int size)
{
    Random random(3);
    struct Leaf {
        glm::vec2 at;
        glm::vec2 along;
        glm::vec3 color;
    };
    std::vector<Leaf> all;
    for (int i = 0; i < 70; ++i) {
        const float x = random.uniform(0.1F, 0.9F);
        const float y = random.uniform(0.1F, 0.9F);
        const float angle = random.uniform(0, 6.28F);
        all.push_back({{x, y},
                       {std::cos(angle), std::sin(angle)},
                       glm::mix(glm::vec3(0.15F, 0.40F, 0.08F), glm::vec3(0.65F, 0.72F, 0.2F), random.uniform())});
    }
    return textured(size, [&](glm::vec2 uv) {
        glm::vec4 color(0.25F, 0.4F, 0.1F, 0);
        for (const Leaf& leaf : all) {
            const glm::vec2 d = uv - leaf.at;
            if (glm::dot(d, d) > 0.012F) continue;
            const glm::vec2 p(glm::dot(d, leaf.along), d.y * leaf.along.x - d.x * leaf.along.y);
            const float inside = 1 - glm::length(p / glm::vec2(0.085F, 0.035F));
            if (inside > -0.25F) {
                const float alpha = glm::clamp(0.5F + 4 * inside, 0.0F, 1.0F);
                if (alpha >= color.a) color = glm::vec4(leaf.color * (std::abs(p.y) < 0.004F ? 0.7F : 1.0F), alpha);
            }
        }
        return color;
    });
}

Image bumps(int size)
{
    return textured(size, [](glm::vec2 uv) {
        const glm::vec2 cell = glm::fract(uv * glm::vec2(5, 4)) - 0.5F;
        const float d = glm::length(cell);
        glm::vec2 slope = d < 0.38F ? cell * 2.6F * std::cos(d / 0.38F * 1.5708F) : glm::vec2(0);
        slope.x += 0.12F * std::sin(70 * uv.x);
        return glm::vec4(0.5F + 0.5F * glm::normalize(glm::vec3(slope, 1)), 1);
    });
}

Image glow(int size)
{
    return textured(size, [](glm::vec2 uv) {
        const float d = 2 * glm::length(uv - 0.5F);
        return glm::vec4(glm::vec3(1), d < 1 ? (1 - d * d) * (1 - d * d) : 0);
    });
}

Image bricks(int size)
{
    Random random(8);
    std::vector<float> shades;
    for (int i = 0; i < 64; ++i) shades.push_back(random.uniform(0.7F, 1));
    return textured(size, [&](glm::vec2 uv) {
        const float row = std::floor(uv.y * 8);
        const glm::vec2 at = glm::fract(glm::vec2(uv.x * 4 + (static_cast<int>(row) % 2 == 0 ? 0.0F : 0.5F), uv.y * 8));
        const auto column = static_cast<int>(uv.x * 4 + (static_cast<int>(row) % 2 == 0 ? 0.0F : 0.5F)) % 4;
        if (at.x < 0.05F || at.y < 0.1F) return glm::vec4(0.78F, 0.75F, 0.70F, 1);
        return glm::vec4(
            glm::vec3(0.70F, 0.30F, 0.22F) * shades[static_cast<std::size_t>(static_cast<int>(row) * 4 + column)], 1);
    });
}

}
