// Based on: K. Akeley, P. Haeberli, D. Burns. tomesh.c, Silicon Graphics, 1990 (greedy strips); F. Evans, S. Skiena, A.
// Varshney. Optimizing Triangle Strips for Fast Rendering. Visualization 1996. Parity and degenerate triangles as the
// OpenGL 4.6 specification has them, section 10.1.

#include <umbral/meshes/strips.hpp>
#include <unordered_map>
#include <utility>

namespace umbral::meshes {
namespace {

std::uint64_t key_of(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32U | to; }
bool is_triangle(const glm::uvec3& t) { return t.x != t.y && t.y != t.z && t.z != t.x; }

/// A strip that is growing, and the triangles it has.
struct Trail {
    Strip strip;
    std::vector<std::size_t> triangles;
};

class StripMaker {
public:
    explicit StripMaker(const IndexedMesh& mesh)
        : mesh_(mesh), is_taken_(mesh.triangles.size(), false), seen_by_(mesh.triangles.size(), 0)
    {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
            for (int corner = 0; corner < 3; ++corner)
                corner_at_.try_emplace(key_of(mesh.triangles[i][corner], mesh.triangles[i][(corner + 1) % 3]),
                                       3 * i + static_cast<std::size_t>(corner));
    }

    std::vector<Strip> all()
    {
        std::vector<Strip> strips;
        for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
            if (is_taken_[i] || !is_triangle(mesh_.triangles[i])) continue;
            Trail best;
            for (int first = 0; first < 3; ++first) {
                Trail trail = trail_from(i, first);
                if (trail.strip.size() > best.strip.size()) best = std::move(trail);
            }
            for (const std::size_t taken : best.triangles) is_taken_[taken] = true;
            strips.push_back(std::move(best.strip));
        }
        return strips;
    }

private:
    // Goes on over the edge that the next triangle of the strip must have: from the last but one index to the last one
    // before an even triangle, the other way before an odd one.
    Trail trail_from(std::size_t start, int first)
    {
        ++trail_count_;
        const glm::uvec3& t = mesh_.triangles[start];
        Trail trail{{t[first], t[(first + 1) % 3], t[(first + 2) % 3]}, {start}};
        seen_by_[start] = trail_count_;
        for (;;) {
            auto [from, to] = std::pair{trail.strip.end()[-2], trail.strip.back()};
            if (trail.triangles.size() % 2 == 1) std::swap(from, to);
            const auto found = corner_at_.find(key_of(from, to));
            if (found == corner_at_.end()) return trail;
            const std::size_t next = found->second / 3;
            if (is_taken_[next] || seen_by_[next] == trail_count_ || !is_triangle(mesh_.triangles[next])) return trail;
            seen_by_[next] = trail_count_;
            trail.triangles.push_back(next);
            trail.strip.push_back(mesh_.triangles[next][static_cast<int>((found->second + 2) % 3)]);
        }
    }

    const IndexedMesh& mesh_;
    // Of a directed edge: the corner (3 times the triangle's place + 0, 1, 2) from which a triangle runs along it.
    std::unordered_map<std::uint64_t, std::size_t> corner_at_;
    std::vector<bool> is_taken_;
    std::vector<std::size_t> seen_by_;  // the trail that passed last
    std::size_t trail_count_ = 0;
};

}

std::vector<Strip> grid_strips(std::uint32_t columns, std::uint32_t rows)
{
    std::vector<Strip> strips;
    for (std::uint32_t row = 0; row < rows && columns > 0; ++row) {
        Strip strip;
        for (std::uint32_t column = 0; column <= columns; ++column) {
            strip.push_back((row + 1) * (columns + 1) + column);
            strip.push_back(row * (columns + 1) + column);
        }
        strips.push_back(std::move(strip));
    }
    return strips;
}

std::vector<glm::uvec3> triangles_of_strip(const Strip& indices)
{
    std::vector<glm::uvec3> triangles;
    std::size_t start = 0;  // where the strip began
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] == restart_index) start = i + 1;
        if (i < start + 2) continue;
        glm::uvec3 triangle(indices[i - 2], indices[i - 1], indices[i]);
        if ((i - start) % 2 == 1) std::swap(triangle.x, triangle.y);
        if (is_triangle(triangle)) triangles.push_back(triangle);
    }
    return triangles;
}

Strip join_strips(const std::vector<Strip>& strips)
{
    Strip joined;
    for (const Strip& strip : strips) {
        if (strip.size() < 3) continue;
        if (!joined.empty()) {
            joined.push_back(joined.back());
            joined.push_back(strip.front());
            if (joined.size() % 2 == 1) joined.push_back(strip.front());
        }
        joined.insert(joined.end(), strip.begin(), strip.end());
    }
    return joined;
}

std::vector<Strip> make_strips(const IndexedMesh& mesh) { return StripMaker(mesh).all(); }

std::vector<std::vector<glm::vec3>> strips_of_coordinates(const std::vector<glm::vec3>& positions,
                                                          const std::vector<Strip>& strips)
{
    std::vector<std::vector<glm::vec3>> result;
    for (const Strip& strip : strips) {
        std::vector<glm::vec3>& coordinates = result.emplace_back();
        for (const std::uint32_t index : strip) coordinates.push_back(positions[index]);
    }
    return result;
}

StripBytes strip_bytes(std::uint64_t vertices, const std::vector<Strip>& strips)
{
    const std::uint64_t table = 4 + 8 * strips.size();
    std::uint64_t indices = 0;
    for (const Strip& strip : strips) indices += strip.size();
    return {table + 12 * indices, table + 12 * vertices + 4 * indices};
}

}
