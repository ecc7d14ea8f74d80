// alternative: every pixel of the box for itself, edge functions in double (exact for positions in 1/256 pixel)
#include <umbral/pipeline/rasterize.hpp>

namespace umbral::pipeline {
namespace {

glm::dvec2 rounded(glm::vec2 position)
{
    return {std::nearbyint(position.x * 256.0) / 256, std::nearbyint(position.y * 256.0) / 256};
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

bool inside(glm::dvec2 from, glm::dvec2 to, double value)
{
    const glm::dvec2 side = to - from;
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
        const float reach = std::max(std::abs(vertex.position.x), std::abs(vertex.position.y));
        if (!(reach <= 16384) || std::isnan(vertex.position.x) || std::isnan(vertex.position.y)) return;
        if (!(vertex.inverse_w > 0) || std::isnan(vertex.depth)) return;
    }
    if (cross(rounded(v[1].position) - rounded(v[0].position), rounded(v[2].position) - rounded(v[0].position)) < 0) {
        std::swap(v[1], v[2]);
        std::swap(order[1], order[2]);
    }
    const glm::dvec2 a = rounded(v[0].position);
    const glm::dvec2 b = rounded(v[1].position);
    const glm::dvec2 c = rounded(v[2].position);
    const double area = cross(b - a, c - a);
    if (area == 0) return;

    const int first_x = std::max(0, static_cast<int>(std::floor(std::min({a.x, b.x, c.x}))));
    const int first_y = std::max(0, static_cast<int>(std::floor(std::min({a.y, b.y, c.y}))));
    const int last_x = std::min(width - 1, static_cast<int>(std::floor(std::max({a.x, b.x, c.x}))));
    const int last_y = std::min(height - 1, static_cast<int>(std::floor(std::max({a.y, b.y, c.y}))));
    for (int y = first_y; y <= last_y; ++y)
        for (int x = first_x; x <= last_x; ++x) {
            const glm::dvec2 p(x + 0.5, y + 0.5);
            const double ea = cross(c - b, p - b);
            const double eb = cross(a - c, p - c);
            const double ec = cross(b - a, p - a);
            if (!inside(b, c, ea) || !inside(c, a, eb) || !inside(a, b, ec)) continue;
            const double depth = (ea * v[0].depth + eb * v[1].depth + ec * v[2].depth) / area;
            const glm::dvec3 share(ea * v[0].inverse_w, eb * v[1].inverse_w, ec * v[2].inverse_w);
            const double sum = share[0] + share[1] + share[2];
            glm::vec3 weights(0);
            for (int i = 0; i < 3; ++i) weights[order[i]] = static_cast<float>(share[i] / sum);
            fragments.push_back({{x, y}, static_cast<float>(depth), weights});
        }
}

}
