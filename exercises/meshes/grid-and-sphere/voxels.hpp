#pragma once

#include <algorithm>
#include <cmath>
#include <umbral/core/random.hpp>
#include <umbral/meshes/builders.hpp>
#include <utility>

/// Voxels for the cases and for the picture.
namespace umbral::meshes {

/// The bit of a voxel; 0 for voxels outside the cube, and where bytes are missing.
inline bool is_set(const std::vector<std::uint8_t>& bytes, int k, const glm::ivec3& cell)
{
    for (int axis = 0; axis < 3; ++axis)
        if (cell[axis] < 0 || cell[axis] >= k) return false;
    const auto number = static_cast<std::size_t>(cell.x + k * (cell.y + k * cell.z));
    return number / 8 < bytes.size() && (bytes[number / 8] >> number % 8 & 1) != 0;
}

/// The faces between filled voxels and empty ones, in the cube from -1/2 to 1/2.
inline IndexedMesh surface(const std::vector<std::uint8_t>& bytes, int k)
{
    IndexedMesh mesh;
    for (int number = 0; number < k * k * k; ++number) {
        const glm::ivec3 cell(number % k, number / k % k, number / k / k);
        if (!is_set(bytes, k, cell)) continue;
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
                glm::ivec3 neighbour = cell;
                neighbour[axis] += 2 * side - 1;
                if (is_set(bytes, k, neighbour)) continue;
                const auto first = static_cast<std::uint32_t>(mesh.positions.size());
                for (int corner = 0; corner < 4; ++corner) {
                    glm::ivec3 place = cell;
                    place[axis] += side;
                    place[(axis + 1) % 3] += (corner == 1 || corner == 2) ? 1 : 0;
                    place[(axis + 2) % 3] += corner / 2;
                    mesh.positions.push_back(glm::vec3(place) / static_cast<float>(k) - 0.5F);
                }
                for (const glm::uvec3 t : {glm::uvec3(0, 1, 2), {0, 2, 3}})
                    mesh.triangles.push_back(first + (side == 1 ? t : glm::uvec3(t.x, t.z, t.y)));
            }
    }
    return mesh;
}

/// How many bits of the k³ are 1; bytes that are missing count as 0.
inline float filled(const std::vector<std::uint8_t>& bytes, std::uint32_t k)
{
    const std::size_t all = (std::size_t{k} * k * k + 7) / 8;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < std::min(all, bytes.size()); ++i)
        for (unsigned bits = bytes[i]; bits != 0; bits &= bits - 1) ++count;
    return static_cast<float>(count);
}

/// A voxel inside the ball and the next one, outside, in the outermost layer of the cube, where one coordinate is 0 or
/// k - 1: the ball touches it in the middle.
inline std::pair<glm::uvec3, glm::uvec3> layer_voxels(Random& random, std::uint32_t k)
{
    const auto side = static_cast<std::int64_t>(k);
    // Twice the centre: the layer is k - 1 away, and x² + y² may be at most k² - (k - 1)².
    const std::int64_t rest = 2 * side - 1;
    const std::int64_t parity = (side + 1) % 2;
    const auto most = static_cast<std::int64_t>(0.7 * std::sqrt(static_cast<double>(rest))) / 2;
    const std::int64_t y = parity + 2 * (most > 0 ? random.below(static_cast<std::uint32_t>(most)) : 0);
    std::int64_t x = parity;
    while ((x + 2) * (x + 2) + y * y <= rest) x += 2;
    const std::uint32_t turn = random.below(3);
    const std::uint32_t mirrored = random.below(8);
    const auto voxel = [&](std::int64_t across) {
        const std::int64_t centre[] = {side - 1, y, across};
        glm::uvec3 cell(0);
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const std::int64_t half = (mirrored >> axis & 1U) != 0 ? -centre[axis] : centre[axis];
            cell[static_cast<int>((axis + turn) % 3)] = static_cast<std::uint32_t>((half + side - 1) / 2);
        }
        return cell;
    };
    return {voxel(x), voxel(x + 2)};
}

/// A voxel inside the ball of k voxels across and the next one along an axis, which is outside: of 2000 tries, the two
/// that hang on the least. The centres' coordinates are counted in half voxels. If `level`, the surface runs almost
/// along that axis there, so that it can hang on very little.
inline std::pair<glm::uvec3, glm::uvec3> border_voxels(Random& random, std::uint32_t k, bool level)
{
    const auto side = static_cast<std::int64_t>(k);
    std::int64_t least = side * side;
    glm::i64vec3 best(0);
    const auto root = [](std::int64_t value) {
        auto guess = static_cast<std::int64_t>(std::sqrt(static_cast<double>(value)));
        while (guess * guess > value) --guess;
        while ((guess + 1) * (guess + 1) <= value) ++guess;
        return guess;
    };
    const auto of_parity = [&](std::int64_t value) { return (value + side) % 2 == 0 ? value - 1 : value; };
    for (int i = 0; i < 2000; ++i) {
        const auto part = [&] {
            return of_parity(side * 35 / 100 +
                             static_cast<std::int64_t>(random.uniform_double() * static_cast<double>(side) * 0.3));
        };
        const std::int64_t x = part();
        const std::int64_t drawn = part();
        const std::int64_t y = level ? of_parity(root(side * side - x * x) - 2) : drawn;
        const std::int64_t rest = side * side - x * x - y * y;
        const std::int64_t z = of_parity(root(rest));
        const std::int64_t gap = std::min(rest - z * z, (z + 2) * (z + 2) - rest);
        if (z >= 0 && gap < least) least = gap, best = {x, y, z};
    }
    // To another octant and another order of axes: mirrors keep what is inside.
    const std::uint32_t turn = random.below(3);
    const std::uint32_t mirrored = random.below(8);
    const auto voxel = [&](const glm::i64vec3& centre) {
        glm::uvec3 cell(0);
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t half =
                (mirrored >> static_cast<unsigned>(axis) & 1U) != 0 ? -centre[axis] : centre[axis];
            cell[(axis + static_cast<int>(turn)) % 3] = static_cast<std::uint32_t>((half + side - 1) / 2);
        }
        return cell;
    };
    return {voxel(best), voxel(best + glm::i64vec3(0, 0, 2))};
}

}
