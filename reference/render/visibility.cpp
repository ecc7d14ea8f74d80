#include "render/visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace umbral::render {

glm::vec2 guard_band(int width, int height)
{
    // rasterize_triangle takes positions in [-16384, 16384]; a pixel less, for the rounding of the viewport transform.
    constexpr double reach = 16383;
    const auto factor = [](int side) { return std::exp2(std::max(0.0, std::floor(std::log2(2 * reach / side - 1)))); };
    return {factor(width), factor(height)};
}

Visibility visibility(const VertexMesh& mesh, const glm::mat4& to_clip, const glm::vec2& guard)
{
    if (mesh.triangles.empty()) return Visibility::outside;
    glm::vec3 low = mesh.vertices.front().position;
    glm::vec3 high = low;
    for (const Vertex& vertex : mesh.vertices) {
        low = min(low, vertex.position);
        high = max(high, vertex.position);
    }

    bool all_inside = true;
    // Corners beyond: left, right, below, above, near, far.
    std::array<int, 6> beyond{};
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::dvec3 place((corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                               (corner & 4U) != 0 ? high.z : low.z);
        const glm::dvec4 clip = glm::dmat4(to_clip) * glm::dvec4(place, 1);
        // Float loses a few units of the last place of the largest term, which is the largest entry's share.
        const double margin = 1e-5 * (std::abs(clip.x) + std::abs(clip.y) + std::abs(clip.z) + std::abs(clip.w) +
                                      glm::length(place) + 1e-3);
        const std::array<double, 6> into = {clip.x + clip.w, clip.w - clip.x, clip.y + clip.w,
                                            clip.w - clip.y, clip.z + clip.w, clip.w - clip.z};
        for (std::size_t plane = 0; plane < 6; ++plane) beyond[plane] += into[plane] < -margin ? 1 : 0;
        const bool depth_inside = into[4] > margin && into[5] > margin;
        all_inside = all_inside && depth_inside && std::abs(clip.x) < double{guard.x} * clip.w - margin &&
                     std::abs(clip.y) < double{guard.y} * clip.w - margin;
    }
    if (std::any_of(beyond.begin(), beyond.end(), [](int corners) { return corners == 8; })) return Visibility::outside;
    return all_inside ? Visibility::inside : Visibility::crosses;
}

}
