// alternative: each row's run from where the three edges cut it, by whole division; weights in float from the exact
// edge functions
#include <umbral/pipeline/rasterize.hpp>

namespace umbral::pipeline {
namespace {

using Int = long long;

Int divided_up(Int a, Int b) { return a >= 0 ? (a + b - 1) / b : -(-a / b); }
Int divided_down(Int a, Int b) { return -divided_up(-a, b); }

struct Line {
    Int dx, dy, origin, least;  // value at centre (x, y): origin + dx * x + dy * y

    Int at(Int x, Int y) const { return origin + dx * x + dy * y; }
};

Line line(Int ax, Int ay, Int bx, Int by)
{
    const Int dx = 256 * (ay - by);
    const Int dy = 256 * (bx - ax);
    return {dx, dy, (128 - ay) * (bx - ax) - (128 - ax) * (by - ay), dx > 0 || (dx == 0 && dy > 0) ? 0 : 1};
}

}

void rasterize_triangle(const std::array<WindowVertex, 3>& triangle, int width, int height,
                        std::vector<Fragment>& fragments)
{
    std::array<Int, 3> px{};
    std::array<Int, 3> py{};
    for (std::size_t i = 0; i < 3; ++i) {
        const WindowVertex& v = triangle[i];
        if (!(std::abs(v.position.x) <= 16384) || !(std::abs(v.position.y) <= 16384) || !(v.inverse_w > 0) ||
            std::isnan(v.depth))
            return;
        px[i] = std::llrint(v.position.x * 256);
        py[i] = std::llrint(v.position.y * 256);
    }
    const Int area = (px[1] - px[0]) * (py[2] - py[0]) - (py[1] - py[0]) * (px[2] - px[0]);
    if (area == 0) return;
    std::array<Line, 3> lines{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t from = area > 0 ? (i + 1) % 3 : (i + 2) % 3;
        const std::size_t to = area > 0 ? (i + 2) % 3 : (i + 1) % 3;
        lines[i] = line(px[from], py[from], px[to], py[to]);
    }

    const Int top = std::max<Int>(0, divided_down(std::min({py[0], py[1], py[2]}), 256));
    const Int bottom = std::min<Int>(height - 1, divided_down(std::max({py[0], py[1], py[2]}), 256));
    for (Int y = top; y <= bottom; ++y) {
        Int first = 0;
        Int last = width - 1;
        for (const Line& l : lines) {
            const Int lacking = l.least - l.at(0, y);
            if (l.dx > 0) first = std::max(first, divided_up(lacking, l.dx));
            if (l.dx < 0) last = std::min(last, divided_down(-lacking, -l.dx));
            if (l.dx == 0 && lacking > 0) last = -1;
        }
        for (Int x = first; x <= last; ++x) {
            glm::vec3 affine(0);
            for (std::size_t i = 0; i < 3; ++i) affine[static_cast<int>(i)] = static_cast<float>(lines[i].at(x, y));
            affine /= affine[0] + affine[1] + affine[2];
            const glm::vec3 share =
                affine * glm::vec3(triangle[0].inverse_w, triangle[1].inverse_w, triangle[2].inverse_w);
            const float depth =
                affine[0] * triangle[0].depth + affine[1] * triangle[1].depth + affine[2] * triangle[2].depth;
            fragments.push_back(
                {{static_cast<int>(x), static_cast<int>(y)}, depth, share / (share[0] + share[1] + share[2])});
        }
    }
}

}
