// alternative: the viewport as a matrix, in double; lines in whole numbers; depth test and colours pixel by pixel
#include <umbral/pipeline/software.hpp>

namespace umbral::pipeline {
namespace {

using Whole = std::int64_t;

glm::dmat4 viewport_matrix(const Viewport& v)
{
    glm::dmat4 d(1);
    d[0][0] = v.width / 2.0;
    d[1][1] = -v.height / 2.0;
    d[2][2] = (double(v.far_depth) - double(v.near_depth)) / 2;
    d[3] = {v.width / 2.0, v.height / 2.0, (double(v.far_depth) + double(v.near_depth)) / 2, 1};
    return d;
}

struct Painter {
    const PipelineState& state;
    glm::mat3 colors;
    Layer& target;

    void paint(int x, int y, float depth, const glm::vec3& weights) const
    {
        if (x < 0 || y < 0 || x >= state.viewport.width || y >= state.viewport.height) return;
        x += state.viewport.left;
        y += state.viewport.top;
        if (!target.depths.contains(x, y)) return;
        if (state.depth.enabled) {
            const float incoming = stored_depth(state.depth.format, depth);
            if (!depth_passes(state.depth.function, incoming, target.depths.at(x, y))) return;
            if (state.depth.writes) target.depths.at(x, y) = incoming;
        }
        target.colors.at(x, y) = state.shading == ShadeModel::flat ? colors[2] : colors * weights;
    }
};

Whole in_256ths(float position) { return static_cast<Whole>(std::nearbyint(position * 256.0)); }

Whole floor_of(Whole n, Whole d) { return (n >= 0 ? n : n - d + 1) / d; }

bool is_new(const glm::vec3& a, const glm::vec3& b)
{
    for (int i = 0; i < 3; ++i)
        if (a[i] == 0 && b[i] == 0) return false;
    return true;
}

void draw_side(const Painter& painter, const WindowVertex& a, const glm::vec3& wa, const WindowVertex& b,
               const glm::vec3& wb)
{
    const Whole from[2] = {in_256ths(a.position.x), in_256ths(a.position.y)};
    const Whole to[2] = {in_256ths(b.position.x), in_256ths(b.position.y)};
    const int m = std::abs(to[0] - from[0]) >= std::abs(to[1] - from[1]) ? 0 : 1;
    const Whole low = std::min(from[m], to[m]);
    const Whole high = std::max(from[m], to[m]);
    const Whole length = to[m] - from[m];
    for (Whole i = floor_of(low + 127, 256); 256 * i + 128 < high; ++i) {
        const Whole done = 256 * i + 128 - from[m];
        const Whole sign = length > 0 ? 1 : -1;
        const Whole other =
            floor_of(sign * (from[1 - m] * length + done * (to[1 - m] - from[1 - m])), sign * length * 256);
        const double t = double(done) / double(length);
        const double sa = (1 - t) * a.inverse_w;
        const double sb = t * b.inverse_w;
        const auto depth = static_cast<float>((1 - t) * a.depth + t * b.depth);
        const glm::vec3 weights((sa * glm::dvec3(wa) + sb * glm::dvec3(wb)) / (sa + sb));
        painter.paint(static_cast<int>(m == 0 ? i : other), static_cast<int>(m == 0 ? other : i), depth, weights);
    }
}

}

void draw_triangles(const PipelineState& state, std::span<const ColoredVertex> vertices,
                    std::span<const glm::uvec3> triangles, Layer& target)
{
    const glm::dmat4 to_window = viewport_matrix(state.viewport);
    for (const glm::uvec3& t : triangles) {
        const Painter painter{state, glm::mat3(vertices[t.x].color, vertices[t.y].color, vertices[t.z].color), target};
        std::array<glm::vec4, 3> corners{};
        for (int i = 0; i < 3; ++i)
            corners[static_cast<std::size_t>(i)] = state.to_clip * glm::vec4(vertices[t[i]].position, 1);
        std::vector<ClipVertex> polygon;
        clip_triangle(corners, polygon);
        std::vector<WindowVertex> window;
        for (const ClipVertex& corner : polygon) {
            const glm::dvec4 place = to_window * (glm::dvec4(corner.position) / double(corner.position.w));
            window.push_back(
                {glm::vec2(place), static_cast<float>(place.z), static_cast<float>(1 / double(corner.position.w))});
        }
        const std::size_t n = window.size();
        double twice_area = 0;
        for (std::size_t i = 2; i < n; ++i) {
            const glm::dvec2 p(window[i - 1].position - window[0].position);
            const glm::dvec2 q(window[i].position - window[0].position);
            twice_area += p.x * q.y - p.y * q.x;
        }
        const bool front = twice_area < 0;
        if ((front && state.culling == Culling::front) || (!front && state.culling == Culling::back)) continue;
        for (std::size_t i = 0; i < n; ++i) {
            const bool old = !is_new(polygon[i].weights, polygon[(i + 1) % n].weights);
            if (old && state.mode == PolygonMode::point)
                painter.paint(static_cast<int>(floor_of(in_256ths(window[i].position.x), 256)),
                              static_cast<int>(floor_of(in_256ths(window[i].position.y), 256)), window[i].depth,
                              polygon[i].weights);
            if (old && state.mode == PolygonMode::line)
                draw_side(painter, window[i], polygon[i].weights, window[(i + 1) % n], polygon[(i + 1) % n].weights);
            if (state.mode != PolygonMode::fill || i < 2) continue;
            std::vector<Fragment> fragments;
            rasterize_triangle({window[0], window[i - 1], window[i]}, state.viewport.width, state.viewport.height,
                               fragments);
            for (const Fragment& f : fragments)
                painter.paint(f.pixel.x, f.pixel.y, f.depth,
                              f.weights[0] * polygon[0].weights + f.weights[1] * polygon[i - 1].weights +
                                  f.weights[2] * polygon[i].weights);
        }
    }
}

}
