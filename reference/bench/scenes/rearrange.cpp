#include "rearrange.hpp"

#include <algorithm>
#include <umbral/core/random.hpp>

namespace umbral::bench::scenes {
namespace {

/// Only where depth decides who is seen.
void reorder(Batch& batch)
{
    if (batch.blend != Blend::none || !batch.depth_test) return;
    const std::size_t count = batch.lines ? 2 : 3;
    Random random(20'26);
    for (std::size_t left = batch.corners.size() / count; left > 1; --left) {
        const std::size_t other = random.below(static_cast<std::uint32_t>(left));
        for (std::size_t k = 0; k < count; ++k)
            std::swap(batch.corners[(left - 1) * count + k], batch.corners[other * count + k]);
    }
}

void rotate_corners(Batch& batch)
{
    if (batch.lines) return;
    for (std::size_t i = 0; i + 2 < batch.corners.size(); i += 3) {
        const auto first = batch.corners.begin() + static_cast<std::ptrdiff_t>(i);
        std::rotate(first, first + 1 + static_cast<std::ptrdiff_t>(i / 3 % 2), first + 3);
    }
}

void swap_ends(Batch& batch)
{
    if (!batch.lines) return;
    for (std::size_t i = 0; i + 1 < batch.corners.size(); i += 2) std::swap(batch.corners[i], batch.corners[i + 1]);
}

Vertex centre(const Vertex& a, const Vertex& b, const Vertex& c)
{
    const auto mean = [](const auto& x, const auto& y, const auto& z) { return (x + y + z) / 3.0F; };
    return {mean(a.position, b.position, c.position), mean(a.normal, b.normal, c.normal), mean(a.uv, b.uv, c.uv),
            mean(a.color, b.color, c.color)};
}

void split(Batch& batch)
{
    if (batch.lines) return;
    Triangles pieces;
    for (std::size_t i = 0; i + 2 < batch.corners.size(); i += 3) {
        const Vertex& a = batch.corners[i];
        const Vertex& b = batch.corners[i + 1];
        const Vertex& c = batch.corners[i + 2];
        const Vertex m = centre(a, b, c);
        pieces.insert(pieces.end(), {a, b, m, b, c, m, c, a, m});
    }
    batch.corners = pieces;
}

}

void rearrange(Model& model, Way way)
{
    for (Batch& batch : model.batches) {
        if (way == Way::triangles_reordered) reorder(batch);
        if (way == Way::corners_rotated) rotate_corners(batch);
        if (way == Way::ends_swapped) swap_ends(batch);
        if (way == Way::triangles_split) split(batch);
    }
}

}
