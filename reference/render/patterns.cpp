#include "render/patterns.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace umbral::render {
namespace {

constexpr float full_turn = 6.2831853F;

/// 32 well mixed bits of a place and a number (Wellons, "prospecting for hash functions", 2018).
std::uint32_t hash(int x, int y, std::uint32_t which)
{
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343U + static_cast<std::uint32_t>(y) * 0xd8163841U + which;
    h = (h ^ (h >> 16U)) * 0x7feb352dU;
    h = (h ^ (h >> 15U)) * 0x846ca68bU;
    return h ^ (h >> 16U);
}

/// In [0, 1).
float random_at(int x, int y, std::uint32_t which) { return static_cast<float>(hash(x, y, which) >> 8U) * 0x1p-24F; }

int wrapped(int i, int period) { return ((i % period) + period) % period; }

/// Octaves of noise, each twice as fine and half as strong as the one before.
float fractal_noise(const glm::vec2& place, const glm::ivec2& period, int octaves)
{
    float sum = 0;
    float weight = 1;
    glm::ivec2 repeats = period;
    float fineness = 1;
    for (int i = 0; i < octaves; ++i) {
        sum += weight * periodic_noise(fineness * place, repeats);
        weight *= 0.5F;
        fineness *= 2;
        repeats *= 2;
    }
    return sum;
}

}

float periodic_noise(const glm::vec2& place, const glm::ivec2& period)
{
    const glm::vec2 corner = glm::floor(place);
    const glm::vec2 inside = place - corner;
    const auto slope = [&](int dx, int dy) {
        const int x = wrapped(static_cast<int>(corner.x) + dx, period.x);
        const int y = wrapped(static_cast<int>(corner.y) + dy, period.y);
        const float angle = full_turn * random_at(x, y, 1);
        const glm::vec2 away = inside - glm::vec2(dx, dy);
        return std::cos(angle) * away.x + std::sin(angle) * away.y;
    };
    const glm::vec2 fade = inside * inside * inside * (inside * (inside * 6.0F - 15.0F) + 10.0F);
    const float below = glm::mix(slope(0, 0), slope(1, 0), fade.x);
    const float above = glm::mix(slope(0, 1), slope(1, 1), fade.x);
    // The largest that two dimensions give is the root of a half.
    return glm::clamp(1.41421356F * glm::mix(below, above, fade.y), -1.0F, 1.0F);
}

glm::vec3 wood(const scene::Texture& texture, const glm::vec2& uv)
{
    const int boards = texture.cells;
    const float across = uv.x * static_cast<float>(boards);
    const int board = std::min(static_cast<int>(across), boards - 1);
    const float in_board = across - static_cast<float>(board);
    const float own = 17.0F * random_at(board, 0, 2);
    // Each board is cut from its own place of the trunk: its rings are hyperbolas, stretched along the grain.
    const float waver = periodic_noise({3.0F * in_board + own, 2.0F * uv.y}, {64, 2});
    const float side = in_board - 0.5F + 0.7F * (random_at(board, 1, 2) - 0.5F);
    const float ring =
        7.0F * std::sqrt(side * side + 0.02F + 0.06F * (1 + std::cos(full_turn * uv.y + own))) + 0.9F * waver;
    const float late = glm::fract(ring);
    const float dark = late * late * (late < 0.93F ? 1.0F : (1 - late) / 0.07F);
    const float fibre = periodic_noise({70.0F * in_board + own, 6.0F * uv.y}, {256, 6});
    const float shade = (0.9F + 0.2F * random_at(board, 2, 2)) * (1 + 0.08F * fibre);
    const float joint = std::min(in_board, 1 - in_board) < 0.008F && boards > 1 ? 0.45F : 1.0F;
    return glm::clamp(joint * shade * glm::mix(texture.first, texture.second, 0.75F * dark), 0.0F, 1.0F);
}

glm::vec3 marble(const scene::Texture& texture, const glm::vec2& uv)
{
    const int cells = texture.cells;
    const glm::vec2 place = uv * static_cast<float>(cells);
    const float bent = fractal_noise(place, glm::ivec2(cells), 5);
    const float bands = std::sin(
        full_turn * (uv.x + uv.y) * std::max(1.0F, std::round(0.25F * static_cast<float>(cells))) + 5.5F * bent);
    const float vein = std::pow(1 - std::abs(bands), 3.0F);
    const float cloud = 0.5F + 0.5F * fractal_noise(place + 0.37F, glm::ivec2(cells), 4);
    return glm::clamp(glm::mix(texture.first, texture.second, 0.75F * vein + 0.18F * cloud * cloud), 0.0F, 1.0F);
}

glm::vec3 bricks(const scene::Texture& texture, const glm::vec2& uv)
{
    const int layers = texture.cells;
    const int columns = std::max(1, layers / 3);
    const float up = uv.y * static_cast<float>(layers);
    const int layer = std::min(static_cast<int>(up), layers - 1);
    const float along = uv.x * static_cast<float>(columns) + (layer % 2 == 0 ? 0.0F : 0.5F);
    const int brick = wrapped(static_cast<int>(std::floor(along)), columns);
    const glm::vec2 inside(glm::fract(along), up - static_cast<float>(layer));
    const float length = static_cast<float>(layers) / static_cast<float>(columns);
    const glm::vec2 from_edge = glm::min(inside, 1.0F - inside) * glm::vec2(length, 1);
    const float rough = fractal_noise(uv * static_cast<float>(8 * layers), glm::ivec2(8 * layers), 3);
    const float edge = std::min(from_edge.x, from_edge.y) + 0.02F * rough;
    const float tint = 0.72F + 0.5F * random_at(brick, layer, 3);
    const glm::vec3 burnt = texture.first * glm::vec3(tint, tint * (0.92F + 0.16F * random_at(brick, layer, 4)), tint);
    const glm::vec3 mortar = texture.second * (1 + 0.12F * rough);
    return glm::clamp(glm::mix(mortar, burnt * (1 + 0.16F * rough), glm::smoothstep(0.05F, 0.1F, edge)), 0.0F, 1.0F);
}

glm::vec3 pores(const scene::Texture& texture, const glm::vec2& uv)
{
    const glm::vec2 place = uv * static_cast<float>(texture.cells);
    const glm::ivec2 cell(glm::floor(place));
    float depth = 0;
    // A dimple reaches no farther than a cell beyond its own.
    for (int y = cell.y - 1; y <= cell.y + 1; ++y)
        for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
            const int column = wrapped(x, texture.cells);
            const int row = wrapped(y, texture.cells);
            const auto random = [&](std::uint32_t which) { return random_at(column, row, which); };
            const glm::vec2 centre = glm::vec2(x, y) + 0.2F + 0.6F * glm::vec2(random(5), random(6));
            const float radius = 0.45F + 0.3F * random(7);
            const float from_edge = std::max(0.0F, 1 - dot(place - centre, place - centre) / (radius * radius));
            depth = std::max(depth, (0.6F + 0.4F * random(8)) * from_edge * from_edge);
        }
    return glm::mix(texture.first, texture.second, depth);
}

}
