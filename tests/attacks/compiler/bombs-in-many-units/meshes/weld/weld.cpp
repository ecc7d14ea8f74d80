// Based on: hashing of positions, as in M. Teschner, B. Heidelberger, M. Müller, D. Pomeranets, M. Gross. Optimized
// Spatial Hashing for Collision Detection of Deformable Objects. Vision, Modeling, Visualization 2003; the mixing by
// Fibonacci's constant: D. Knuth. The Art of Computer Programming 3, 6.4.

#include <array>
#include <bit>
#include <cmath>
#include <umbral/meshes/weld.hpp>
#include <unordered_map>

namespace umbral::meshes {
namespace {

using Place = std::array<std::uint32_t, 3>;

// Adding +0 makes -0 a +0, and changes no other number: equal numbers have equal bits.
Place place_of(const glm::vec3& p)
{
    return {std::bit_cast<std::uint32_t>(p.x + 0.0F), std::bit_cast<std::uint32_t>(p.y + 0.0F),
            std::bit_cast<std::uint32_t>(p.z + 0.0F)};
}

// Each word is mixed before the next one comes, so that x, y and z cannot cancel each other.
struct PlaceHash {
    std::size_t operator()(const Place& place) const
    {
        std::uint64_t hash = 0;
        for (const std::uint32_t word : place) {
            hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
            hash ^= hash >> 32U;
        }
        return hash;
    }
};

}

IndexedMesh weld(const std::vector<glm::vec3>& corners)
{
    IndexedMesh mesh;
    std::unordered_map<Place, std::uint32_t, PlaceHash> vertex_at;
    const auto vertex_of = [&](const glm::vec3& corner) {
        const auto next = static_cast<std::uint32_t>(mesh.positions.size());
        const bool is_place = !std::isnan(corner.x) && !std::isnan(corner.y) && !std::isnan(corner.z);
        const std::uint32_t vertex = is_place ? vertex_at.try_emplace(place_of(corner), next).first->second : next;
        if (vertex == next) mesh.positions.push_back(corner);
        return vertex;
    };
    mesh.triangles.reserve(corners.size() / 3);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const std::uint32_t a = vertex_of(corners[i]);
        const std::uint32_t b = vertex_of(corners[i + 1]);
        mesh.triangles.emplace_back(a, b, vertex_of(corners[i + 2]));
    }
    return mesh;
}

std::vector<glm::vec3> isolated_triangles(const IndexedMesh& mesh)
{
    std::vector<glm::vec3> corners;
    corners.reserve(3 * mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles)
        corners.insert(corners.end(), {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
    return corners;
}

}
namespace n2 {
template <int D, int I> struct B : B<D - 1, 2 * I>, B<D - 1, 2 * I + 1> {};
template <int I> struct B<0, I> {};
B<24, 0> all;
}
