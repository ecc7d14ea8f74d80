#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <vector>

/// The scene of projections/curved: a hall of columns with a floor in tiles, beams, tall windows and a lamp.
namespace umbral::projections {

/// Triangles of one colour, or of two in tiles, in linear light. World coordinates, y up, anticlockwise from outside.
struct HallPart {
    glm::vec3 color;
    glm::vec3 odd;   ///< the other colour of tiles
    float tile;      ///< size of a tile; 0 for none
    float glow = 0;  ///< how much light it sends by itself
    std::vector<glm::vec3> corners = {};
};

/// A parallelogram in so many parts along both of its sides.
inline void add_panel(HallPart& part, const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up,
                      const glm::ivec2& parts)
{
    const glm::vec3 u = along / static_cast<float>(parts.x);
    const glm::vec3 v = up / static_cast<float>(parts.y);
    for (int j = 0; j < parts.y; ++j)
        for (int i = 0; i < parts.x; ++i) {
            const glm::vec3 a = corner + static_cast<float>(i) * u + static_cast<float>(j) * v;
            for (const glm::vec3& point : {a, a + u, a + u + v, a, a + u + v, a + v}) part.corners.push_back(point);
        }
}

/// A box from `low` to `high`, its long sides in so many parts.
inline void add_box(HallPart& part, const glm::vec3& low, const glm::vec3& high, const glm::ivec3& parts)
{
    const glm::vec3 x(high.x - low.x, 0, 0);
    const glm::vec3 y(0, high.y - low.y, 0);
    const glm::vec3 z(0, 0, high.z - low.z);
    add_panel(part, low + z, x, y, {parts.x, parts.y});
    add_panel(part, low + x, -x, y, {parts.x, parts.y});
    add_panel(part, low + x + z, -z, y, {parts.z, parts.y});
    add_panel(part, low, z, y, {parts.z, parts.y});
    add_panel(part, low + y + z, x, -z, {parts.x, parts.z});
    add_panel(part, low, x, z, {parts.x, parts.z});
}

/// A column with twelve sides between a plinth and a capital, round a place of the floor.
inline void add_column(HallPart& part, const glm::vec3& place, float height)
{
    constexpr int sides = 12;
    constexpr float turn = 6.2831853F;
    const glm::vec3 wide(0.42F, 0.16F, 0.42F);
    const glm::vec3 half(wide.x, 0, wide.z);
    add_box(part, place - half, place + wide, {1, 1, 1});
    const glm::vec3 top = place + glm::vec3(0, height - wide.y, 0);
    add_box(part, top - half, top + wide, {1, 1, 1});
    for (int side = 0; side < sides; ++side) {
        const auto rim = [&](int at) {
            const float angle = turn * static_cast<float>(at) / sides;
            return place + 0.28F * glm::vec3(std::sin(angle), 0, std::cos(angle));
        };
        add_panel(part, rim(side) + glm::vec3(0, wide.y, 0), rim(side + 1) - rim(side), {0, height - 2 * wide.y, 0},
                  {1, 8});
    }
}

/// A hall of 12 x 12, 5 high, its middle at the origin of the floor.
inline std::vector<HallPart> built_hall()
{
    constexpr float height = 5;
    HallPart floor{{0.60F, 0.50F, 0.36F}, {0.07F, 0.20F, 0.22F}, 1};
    add_panel(floor, {-6, 0, 6}, {12, 0, 0}, {0, 0, -12}, {4, 4});
    HallPart ceiling{{0.34F, 0.42F, 0.46F}, {0.34F, 0.42F, 0.46F}, 0};
    add_panel(ceiling, {-6, height, -6}, {12, 0, 0}, {0, 0, 12}, {4, 4});
    HallPart walls{{0.50F, 0.20F, 0.11F}, {0.56F, 0.26F, 0.15F}, 0.5F};
    HallPart frames{{0.75F, 0.68F, 0.55F}, {0.75F, 0.68F, 0.55F}, 0};
    HallPart panes{{0.30F, 0.55F, 0.85F}, {0.52F, 0.76F, 0.94F}, 0.5F, 1};
    const glm::vec3 corners[] = {{-6, 0, -6}, {6, 0, -6}, {6, 0, 6}, {-6, 0, 6}};
    for (int wall = 0; wall < 4; ++wall) {
        const glm::vec3 from = corners[wall];
        const glm::vec3 along = (corners[(wall + 1) % 4] - from) / 12.0F;
        const glm::vec3 inwards(-along.z, 0, along.x);
        add_panel(walls, from, 12.0F * along, {0, height, 0}, {4, 2});
        for (int window = 0; window < 3; ++window) {
            const glm::vec3 place = from + (2.0F + 4.0F * static_cast<float>(window) - 0.9F) * along;
            const glm::vec3 high(0, 2.6F, 0);
            add_panel(frames, place + glm::vec3(0, 1, 0) + 0.02F * inwards, 1.8F * along, high, {2, 3});
            add_panel(panes, place + 0.15F * along + glm::vec3(0, 1.15F, 0) + 0.04F * inwards, 1.5F * along,
                      high - glm::vec3(0, 0.3F, 0), {2, 3});
        }
    }
    HallPart beams{{0.20F, 0.10F, 0.05F}, {0.20F, 0.10F, 0.05F}, 0};
    for (const float at : {-4.0F, -2.0F, 0.0F, 2.0F, 4.0F}) {
        add_box(beams, {at - 0.12F, height - 0.35F, -6}, {at + 0.12F, height, 6}, {1, 1, 12});
        add_box(beams, {-6, height - 0.25F, at - 0.09F}, {6, height, at + 0.09F}, {12, 1, 1});
    }
    HallPart columns{{0.78F, 0.72F, 0.62F}, {0.78F, 0.72F, 0.62F}, 0};
    for (const float x : {-3.0F, 3.0F})
        for (const float z : {-4.0F, 0.0F, 4.0F}) add_column(columns, {x, 0, z}, height - 0.25F);
    HallPart lamp{{1.0F, 0.78F, 0.36F}, {1.0F, 0.78F, 0.36F}, 0, 1};
    add_box(lamp, {-0.3F, 3.3F, -1.3F}, {0.3F, 3.9F, -0.7F}, {1, 1, 1});
    HallPart crate{{0.55F, 0.08F, 0.06F}, {0.62F, 0.48F, 0.10F}, 0.25F};
    add_box(crate, {1.0F, 0, -2.5F}, {2.0F, 1, -1.5F}, {2, 2, 2});
    add_box(crate, {-1.9F, 0, 1.2F}, {-1.1F, 0.8F, 2}, {2, 2, 2});
    return {floor, ceiling, walls, frames, panes, beams, columns, lamp, crate};
}

}
