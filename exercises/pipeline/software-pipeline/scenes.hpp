#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/software.hpp>
#include <umbral/record/ask.hpp>
#include <vector>

/// Draws for pipeline/software-pipeline: small pictures for the checks.
namespace umbral::pipeline {

/// One call of the unit on a picture that holds nothing yet, or what an earlier call left.
struct Call {
    PipelineState state;
    std::vector<ColoredVertex> vertices;
    std::vector<glm::uvec3> triangles;
    int width = 32, height = 24;
    float clear_depth = 1;
    std::vector<ColoredVertex> earlier;  ///< the same triangles of these vertices come first, filled, the nearest ones
};

/// No triangle has this colour: pixels that keep it were not drawn.
inline constexpr glm::vec3 untouched(-1);

inline Layer drawn(Recorder& out, const Call& call)
{
    Layer layer{Grid<glm::vec3>(call.width, call.height, untouched),
                Grid<float>(call.width, call.height, call.clear_depth)};
    if (!call.earlier.empty()) {
        PipelineState first = call.state;
        first.culling = Culling::none;
        first.mode = PolygonMode::fill;
        const bool reversed = first.viewport.near_depth > first.viewport.far_depth;
        first.depth.function = reversed ? DepthFunction::greater : DepthFunction::less;
        first.depth.enabled = first.depth.writes = true;
        ask<draw_triangles>(out, first, call.earlier, call.triangles, layer);
    }
    ask<draw_triangles>(out, call.state, call.vertices, call.triangles, layer);
    return layer;
}

/// Rows [call, x, y, red, green, blue] under "colours" and [call, x, y, depth] under "depths", of the pixels that
/// changed. A student may have changed the grids' sizes: only cells of the picture are looked at.
inline void record(Recorder& out, const std::vector<Call>& calls)
{
    for (const char* const name : {"colours.names", "depths.names"}) out.text(name, "call");
    for (std::size_t i = 0; i < calls.size(); ++i) {
        const Layer layer = drawn(out, calls[i]);
        for (int y = 0; y < std::min(calls[i].height, layer.colors.height); ++y)
            for (int x = 0; x < std::min(calls[i].width, layer.colors.width); ++x) {
                const std::array<float, 3> where = {static_cast<float>(i), static_cast<float>(x),
                                                    static_cast<float>(y)};
                const glm::vec3 color = layer.colors.at(x, y);
                if (color != untouched)
                    out.append("colours", std::span<const float>(
                                              std::array{where[0], where[1], where[2], color.r, color.g, color.b}));
                if (!layer.depths.contains(x, y) || layer.depths.at(x, y) == calls[i].clear_depth) continue;
                out.append("depths",
                           std::span<const float>(std::array{where[0], where[1], where[2], layer.depths.at(x, y)}));
            }
    }
}

/// A camera at the origin that looks along -z, from depth 0.5 to 20.
inline glm::mat4 perspective(float zoom, float aspect)
{
    constexpr float near = 0.5F;
    constexpr float far = 20;
    glm::mat4 matrix(0);
    matrix[0][0] = zoom / aspect;
    matrix[1][1] = zoom;
    matrix[2][2] = (far + near) / (near - far);
    matrix[2][3] = -1;
    matrix[3][2] = 2 * far * near / (near - far);
    return matrix;
}

inline glm::vec3 random_color(Random& random)
{
    const float red = random.uniform();
    const float green = random.uniform();
    return {red, green, random.uniform()};
}

/// `count` triangles of a camera at the origin: `place()` gives their corners.
template <class Place>
Call random_call(Random& random, int count, const Place& place)
{
    Call call;
    call.state.viewport = {0, 0, call.width, call.height, 0, 1};
    call.state.to_clip = perspective(1.3F, static_cast<float>(call.width) / static_cast<float>(call.height));
    for (int i = 0; i < 3 * count; ++i) {
        const glm::vec3 position = place();
        call.vertices.push_back({position, random_color(random)});
    }
    for (unsigned i = 0; i < static_cast<unsigned>(count); ++i)
        call.triangles.emplace_back(3 * i + 1, 3 * i, 3 * i + 2);
    return call;
}

/// In front of the camera, mostly inside the picture.
inline Call in_front(Random& random, int count)
{
    return random_call(random, count, [&] {
        const float z = random.uniform(1.5F, 9);
        const float x = random.uniform(-0.9F, 0.9F) * z;
        return glm::vec3(x, random.uniform(-0.8F, 0.8F) * z, -z);
    });
}

/// Round the camera: most triangles reach behind it.
inline Call about_the_camera(Random& random, int count)
{
    return random_call(random, count, [&] {
        const float z = random.uniform(-4, 7);
        const float x = random.uniform(-4, 4);
        return glm::vec3(x, random.uniform(-4, 4), -z);
    });
}

}
