// mistake: divides by w, then clips
// credit: 5..35
// hint: Behind the camera w is negative, and the division throws such corners to the other side; at w = 0 it throws
// them to infinity. Clip
//     first: compare x, y, z with w itself.

#include <umbral/pipeline/clip.hpp>

namespace umbral::pipeline {

void clip_triangle(const std::array<glm::vec4, 3>& triangle, std::vector<ClipVertex>& polygon)
{
    std::vector<ClipVertex> points;
    for (int k = 0; k < 3; ++k) {
        const glm::vec4& corner = triangle[static_cast<std::size_t>(k)];
        glm::vec3 weights(0);
        weights[k] = 1;
        points.push_back({glm::vec4(glm::vec3(corner) / corner.w, corner.w), weights});
    }
    for (int plane = 0; plane < 6; ++plane) {
        const auto inside = [&](const ClipVertex& v) {
            return 1 + (plane % 2 == 0 ? v.position[plane / 2] : -v.position[plane / 2]);
        };
        std::vector<ClipVertex> kept;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const ClipVertex& a = points[i];
            const ClipVertex& b = points[(i + 1) % points.size()];
            const float at_a = inside(a);
            const float at_b = inside(b);
            if (at_a >= 0) kept.push_back(a);
            const float t = at_a / (at_a - at_b);
            if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0))
                kept.push_back({glm::mix(a.position, b.position, t), glm::mix(a.weights, b.weights, t)});
        }
        points = kept;
    }
    if (points.size() < 3) return;
    for (const ClipVertex& point : points)
        polygon.push_back({glm::vec4(glm::vec3(point.position) * point.position.w, point.position.w), point.weights});
}

}
