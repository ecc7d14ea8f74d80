// mistake: computes edge functions in float
// credit: 75..95
// hint: Far outside the picture a float has no bits left for what lies between two pixels: numbers of millions are
// subtracted. Use whole numbers of 64 bits.
#include <umbral/pipeline/rasterize.hpp>

namespace umbral::pipeline {
namespace {

glm::vec2 rounded(glm::vec2 position)
{
    return {std::nearbyint(position.x * 256) / 256, std::nearbyint(position.y * 256) / 256};
}

float cross(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

bool inside(glm::vec2 from, glm::vec2 to, float value)
{
    const glm::vec2 side = to - from;
    const bool top = side.y == 0 && side.x > 0;
    const bool left = side.y < 0;
    return value > 0 || (value == 0 && (top || left));
}

}

void rasterize_triangle(const std::array<WindowVertex, 3>& triangle, int width, int height,
                        std::vector<Fragment>& fragments)
{
    std::array<WindowVertex, 3> v = triangle;
    std::array<int, 3> order = {0, 1, 2};
    for (const WindowVertex& vertex : v) {
        if (!(std::abs(vertex.position.x) <= 16384) || !(std::abs(vertex.position.y) <= 16384)) return;
        if (!(vertex.inverse_w > 0) || std::isnan(vertex.depth)) return;
    }
    if (cross(rounded(v[1].position) - rounded(v[0].position), rounded(v[2].position) - rounded(v[0].position)) < 0) {
        std::swap(v[1], v[2]);
        std::swap(order[1], order[2]);
    }
    const glm::vec2 a = rounded(v[0].position);
    const glm::vec2 b = rounded(v[1].position);
    const glm::vec2 c = rounded(v[2].position);
    const float area = cross(b - a, c - a);
    if (area == 0) return;

    const int first_x = std::max(0, static_cast<int>(std::floor(std::min({a.x, b.x, c.x}))));
    const int first_y = std::max(0, static_cast<int>(std::floor(std::min({a.y, b.y, c.y}))));
    const int last_x = std::min(width - 1, static_cast<int>(std::floor(std::max({a.x, b.x, c.x}))));
    const int last_y = std::min(height - 1, static_cast<int>(std::floor(std::max({a.y, b.y, c.y}))));
    for (int y = first_y; y <= last_y; ++y)
        for (int x = first_x; x <= last_x; ++x) {
            const glm::vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const float ea = cross(c - b, p - b);
            const float eb = cross(a - c, p - c);
            const float ec = cross(b - a, p - a);
            if (!inside(b, c, ea) || !inside(c, a, eb) || !inside(a, b, ec)) continue;
            const float depth = (ea * v[0].depth + eb * v[1].depth + ec * v[2].depth) / area;
            const glm::vec3 share(ea * v[0].inverse_w, eb * v[1].inverse_w, ec * v[2].inverse_w);
            glm::vec3 weights(0);
            for (int i = 0; i < 3; ++i)
                weights[order[static_cast<std::size_t>(i)]] = share[i] / (share[0] + share[1] + share[2]);
            fragments.push_back({{x, y}, depth, weights});
        }
}

}
