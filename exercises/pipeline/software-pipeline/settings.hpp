#pragma once

#include <limits>

#include "scenes.hpp"

/// What a check is not about, at random: so each stage is asked in settings that others have.
namespace umbral::pipeline {

template <class Make>
std::vector<Call> several(int count, const Make& make)
{
    std::vector<Call> calls;
    for (int i = 0; i < count; ++i) calls.push_back(make(i));
    return calls;
}

inline constexpr std::array modes = {PolygonMode::fill, PolygonMode::line, PolygonMode::point};

/// On a picture of another size, odd ones among them, and as large a viewport.
inline Call resized(Random& random, Call call)
{
    call.width = 25 + static_cast<int>(random.below(17));
    call.height = 17 + static_cast<int>(random.below(17));
    call.state.viewport.width = call.width;
    call.state.viewport.height = call.height;
    return call;
}

/// A depth range that may be reversed, with a test that keeps what is nearer, or what comes, on a layer that hides some
/// of the triangles: in any format, with and without writing.
inline Call with_depths(Random& random, Call call)
{
    const bool reversed = random.below(2) == 0;
    const float low = random.uniform(0, 0.4F);
    const float high = random.uniform(0.6F, 1);
    call.state.viewport.near_depth = reversed ? high : low;
    call.state.viewport.far_depth = reversed ? low : high;
    using enum DepthFunction;
    const std::array functions = {reversed ? greater : less, reversed ? greater_equal : less_equal, not_equal, always};
    DepthState& depth = call.state.depth;
    depth.function = functions[random.below(4)];
    depth.format = static_cast<DepthFormat>(random.below(3));
    depth.writes = random.below(4) != 0;
    depth.enabled = random.below(6) != 0;
    // Most of what is seen lies in the last third of the range.
    const float hiding = high - random.uniform(0, 0.1F) * (high - low);
    call.clear_depth = stored_depth(depth.format, reversed ? low + high - hiding : hiding);
    return call;
}

/// Corners of any of the vertices, so that triangles share them, and begin with any.
inline Call shared(Random& random, Call call)
{
    const auto count = static_cast<std::uint32_t>(call.vertices.size());
    for (glm::uvec3& triangle : call.triangles) {
        triangle.x = random.below(count);
        triangle.y = (triangle.x + 1 + random.below(count / 2)) % count;
        triangle.z = (triangle.y + 1 + random.below(count / 2 - 1)) % count;
    }
    return call;
}

/// Some corners are nowhere: their triangles draw nothing.
inline Call with_holes(Random& random, Call call)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const std::array nowhere = {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity};
    const std::uint32_t which = random.below(static_cast<std::uint32_t>(call.vertices.size()));
    call.vertices[which].position[static_cast<int>(random.below(3))] = nowhere[random.below(3)];
    return call;
}

/// Over other colours of the same triangles, or over other triangles.
inline Call over_others(Random& random, Call call, bool same)
{
    call.earlier = same ? call.vertices : in_front(random, static_cast<int>(call.triangles.size())).vertices;
    for (ColoredVertex& vertex : call.earlier) vertex.color = random_color(random);
    return call;
}

}
