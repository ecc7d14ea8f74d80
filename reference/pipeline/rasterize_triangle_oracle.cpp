#include <cmath>
#include <umbral/pipeline/rasterize.hpp>

#include "wide.hpp"

// Every pixel of the bounding box for itself: coverage with 128-bit integers, weights and depth with 113 bits, rounded
// to float once.

namespace umbral::pipeline {
namespace {

__extension__ using Whole = __int128;

// In 1/512 pixel, so that positions and centres are whole.
struct Point {
    Whole x, y;
};

// The nearest multiple of 1/256 pixel, ties to the even one, from the exact product.
Whole snapped(double position)
{
    const double scaled = position * 256;
    const double below = std::floor(scaled);
    const double rest = scaled - below;
    const bool odd = std::fmod(below, 2) != 0;
    return 2 * (static_cast<Whole>(below) + ((rest > 0.5 || (rest == 0.5 && odd)) ? 1 : 0));
}

int sign(Whole value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

Whole determinant(const Point& a, const Point& b, const Point& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// On which side of the line from a to b the point lies after an infinitely small step to the right, and a still smaller
// one down. That step takes points on left edges and on top edges inside, and those on all others outside.
int side(const Point& a, const Point& b, const Point& point)
{
    if (const int exact = sign(determinant(a, b, point)); exact != 0) return exact;
    if (const int right = sign(a.y - b.y); right != 0) return right;
    return sign(b.x - a.x);
}

bool drawable(const WindowVertex& vertex)
{
    const bool inside = std::fabs(vertex.position.x) <= 16384 && std::fabs(vertex.position.y) <= 16384;
    return inside && vertex.inverse_w > 0 && vertex.depth == vertex.depth;
}

Fragment shaded(const std::array<WindowVertex, 3>& triangle, const std::array<Point, 3>& corners, const Point& centre,
                int x, int y)
{
    Fragment fragment{{x, y}, 0, glm::vec3(0)};
    std::array<Wide, 3> share{};
    Wide sum = 0;
    Wide depth = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto affine = static_cast<Wide>(determinant(corners[(i + 1) % 3], corners[(i + 2) % 3], centre));
        depth += affine * Wide(triangle[i].depth);
        share[i] = affine * Wide(triangle[i].inverse_w);
        sum += share[i];
    }
    for (int i = 0; i < 3; ++i) fragment.weights[i] = static_cast<float>(share[static_cast<std::size_t>(i)] / sum);
    fragment.depth = static_cast<float>(depth / static_cast<Wide>(determinant(corners[0], corners[1], corners[2])));
    return fragment;
}

}

void rasterize_triangle(const std::array<WindowVertex, 3>& triangle, int width, int height,
                        std::vector<Fragment>& fragments)
{
    std::array<Point, 3> corners{};
    float left = 16384;
    float right = -16384;
    float top = 16384;
    float bottom = -16384;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!drawable(triangle[i])) return;
        const glm::vec2 position = triangle[i].position;
        corners[i] = {snapped(double{position.x}), snapped(double{position.y})};
        left = std::min(left, position.x);
        right = std::max(right, position.x);
        top = std::min(top, position.y);
        bottom = std::max(bottom, position.y);
    }
    const int orientation = sign(determinant(corners[0], corners[1], corners[2]));
    if (orientation == 0) return;

    // A box that is a pixel too large on every side: coverage alone decides.
    for (int y = std::max(0, static_cast<int>(top) - 2); y < std::min(height, static_cast<int>(bottom) + 2); ++y)
        for (int x = std::max(0, static_cast<int>(left) - 2); x < std::min(width, static_cast<int>(right) + 2); ++x) {
            const Point centre{Whole(x) * 512 + 256, Whole(y) * 512 + 256};
            bool inside = true;
            for (std::size_t i = 0; i < 3; ++i)
                inside = inside && side(corners[i], corners[(i + 1) % 3], centre) == orientation;
            if (inside) fragments.push_back(shaded(triangle, corners, centre, x, y));
        }
}

}
