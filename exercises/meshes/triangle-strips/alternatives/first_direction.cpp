// alternative: grows each strip at once from the triangle's first edge; neighbours from a sorted list of edges
#include <umbral/meshes/strips.hpp>

namespace umbral::meshes {
namespace {

struct Side {
    std::uint32_t from, to, apex;
    std::size_t triangle;

    bool before(std::uint32_t a, std::uint32_t b) const { return from != a ? from < a : to < b; }
};

}

std::vector<Strip> grid_strips(std::uint32_t columns, std::uint32_t rows)
{
    if (columns == 0) return {};
    std::vector<Strip> strips(rows, Strip(2 * columns + 2));
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t i = 0; i < strips[row].size(); ++i)
            strips[row][i] = (row + 1 - i % 2) * (columns + 1) + i / 2;
    return strips;
}

std::vector<glm::uvec3> triangles_of_strip(const Strip& indices)
{
    std::vector<glm::uvec3> triangles;
    Strip window;
    bool odd = false;
    for (const std::uint32_t index : indices) {
        if (index == restart_index) {
            window.clear();
            odd = false;
            continue;
        }
        window.push_back(index);
        if (window.size() < 3) continue;
        const glm::uvec3 t =
            odd ? glm::uvec3(window[1], window[0], window[2]) : glm::uvec3(window[0], window[1], window[2]);
        if (t.x != t.y && t.y != t.z && t.z != t.x) triangles.push_back(t);
        window.erase(window.begin());
        odd = !odd;
    }
    return triangles;
}

Strip join_strips(const std::vector<Strip>& strips)
{
    Strip joined;
    for (const Strip& strip : strips) {
        if (strip.size() < 3) continue;
        const std::size_t repeats = joined.empty() ? 0 : 1 + joined.size() % 2;
        if (!joined.empty()) joined.push_back(joined.back());
        joined.insert(joined.end(), repeats, strip[0]);
        joined.insert(joined.end(), strip.begin(), strip.end());
    }
    return joined;
}

std::vector<Strip> make_strips(const IndexedMesh& mesh)
{
    std::vector<Side> sides;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        if (t.x == t.y || t.y == t.z || t.z == t.x) continue;
        for (int k = 0; k < 3; ++k) sides.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3], i});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.before(b.from, b.to); });

    std::vector<bool> done(mesh.triangles.size(), false);
    std::vector<Strip> strips;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        if (done[i] || t.x == t.y || t.y == t.z || t.z == t.x) continue;
        Strip strip{t.x, t.y, t.z};
        done[i] = true;
        for (bool odd = true;; odd = !odd) {
            const std::uint32_t a = strip[strip.size() - (odd ? 1 : 2)];
            const std::uint32_t b = strip[strip.size() - (odd ? 2 : 1)];
            auto side =
                std::lower_bound(sides.begin(), sides.end(), 0, [&](const Side& s, int) { return s.before(a, b); });
            while (side != sides.end() && side->from == a && side->to == b && done[side->triangle]) ++side;
            if (side == sides.end() || side->from != a || side->to != b) break;
            done[side->triangle] = true;
            strip.push_back(side->apex);
        }
        strips.push_back(strip);
    }
    return strips;
}

std::vector<std::vector<glm::vec3>> strips_of_coordinates(const std::vector<glm::vec3>& positions,
                                                          const std::vector<Strip>& strips)
{
    std::vector<std::vector<glm::vec3>> result(strips.size());
    for (std::size_t i = 0; i < strips.size(); ++i) {
        result[i].resize(strips[i].size());
        for (std::size_t k = 0; k < strips[i].size(); ++k) result[i][k] = positions[strips[i][k]];
    }
    return result;
}

StripBytes strip_bytes(std::uint64_t vertices, const std::vector<Strip>& strips)
{
    StripBytes bytes{4, 4 + sizeof(glm::vec3) * vertices};
    for (const Strip& strip : strips) {
        bytes.coordinates += 8 + sizeof(glm::vec3) * strip.size();
        bytes.indexed += 8 + sizeof(std::uint32_t) * strip.size();
    }
    return bytes;
}

}
