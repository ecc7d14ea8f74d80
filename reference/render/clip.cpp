#include "render/clip.hpp"

namespace umbral::render {

void clip_positions(const std::array<glm::vec4, 3>& triangle, const glm::vec2& guard,
                    std::vector<pipeline::ClipVertex>& polygon)
{
    // By powers of two: exact both ways.
    const glm::vec4 shrink(1 / guard.x, 1 / guard.y, 1, 1);
    const glm::vec4 grow(guard.x, guard.y, 1, 1);
    polygon.clear();
    pipeline::clip_triangle({shrink * triangle[0], shrink * triangle[1], shrink * triangle[2]}, polygon);
    for (pipeline::ClipVertex& vertex : polygon) vertex.position = grow * vertex.position;
}

void clip_triangle(const std::array<ClipVertex, 3>& triangle, const glm::vec2& guard,
                   std::vector<pipeline::ClipVertex>& corners, std::vector<ClipVertex>& polygon)
{
    const auto& [a, b, c] = triangle;
    clip_positions({a.clip, b.clip, c.clip}, guard, corners);
    for (const auto& [position, w] : corners)
        polygon.push_back({position, w[0] * a.eye + w[1] * b.eye + w[2] * c.eye,
                           w[0] * a.normal + w[1] * b.normal + w[2] * c.normal,
                           w[0] * a.uv + w[1] * b.uv + w[2] * c.uv});
}

}
