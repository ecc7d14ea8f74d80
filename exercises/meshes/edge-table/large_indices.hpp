#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <umbral/core/random.hpp>
#include <umbral/meshes/mesh.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// Meshes some of whose edges have the same key, where two vertices are made one number that cannot hold both.
namespace umbral::meshes {

/// So many vertices, no two in one place.
inline IndexedMesh scattered(std::uint32_t count)
{
    IndexedMesh mesh;
    mesh.positions.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) mesh.positions.emplace_back(i % 256, i / 256 % 256, i / 65'536);
    return mesh;
}

/// Tetrahedra, the four vertices of each 65,536 apart: cut to 16 bits they are one.
inline IndexedMesh tetrahedra_in_16_bits(std::uint32_t count, Random& random)
{
    constexpr std::uint32_t step = 65'536;
    IndexedMesh mesh = scattered(4 * step);
    const std::uint32_t first = random.below(step - count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t turn = random.below(4);
        for (const glm::uvec3& t : {glm::uvec3(0, 1, 2), {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})
            mesh.triangles.push_back((t + turn) % 4U * step + (first + i));
    }
    return mesh;
}

/// Sixteen triangles round a vertex; it is the smaller one of its spokes.
inline void add_disc(IndexedMesh& mesh, std::uint32_t middle, std::uint32_t rim)
{
    constexpr std::uint32_t slices = 16;
    for (std::uint32_t slice = 0; slice < slices; ++slice)
        mesh.triangles.emplace_back(middle, rim + slice, rim + (slice + 1) % slices);
}

/// Two pairs of discs. The spokes of a pair's have the same numbers if a key is one vertex times a factor plus the
/// other, and `up` times that factor is `down`: the smaller vertex times the factor in the first pair, the larger one
/// in the second.
inline void add_discs(IndexedMesh& mesh, std::uint32_t few, std::uint32_t many, std::uint32_t up, std::uint32_t down)
{
    add_disc(mesh, few, many);
    add_disc(mesh, few + up, many - down);
    add_disc(mesh, down + few + 2, many);
    add_disc(mesh, few + 2, many + up);
}

/// Discs with equal keys, whatever the number of bits. If the factor is a power of two they are equal as well where the
/// vertices are put together by "or": the smaller vertex of the first disc is even.
inline IndexedMesh discs_with_equal_keys(std::uint32_t factor, Variation& vary)
{
    IndexedMesh mesh = scattered(factor + vary.near(1000U, 300U));
    add_discs(mesh, 2 * vary.near(100U, 50U), factor + vary.near(450U, 100U), 1, factor);
    return mesh;
}

/// Ways to make two numbers one by a sum and a square, for which no factor is chosen.
enum class Pairing {
    cantor_larger,   ///< of the sum s: s (s + 1) / 2 + the larger
    cantor_smaller,  ///< and the smaller
    triangle,        ///< of the larger n: n (n - 1) / 2 + the smaller, as in a table that is half a square
    square,          ///< n n + the smaller
};

inline std::uint32_t square_part(Pairing pairing, std::uint32_t n)
{
    if (pairing == Pairing::square) return n * n;
    return (pairing == Pairing::triangle ? n - 1 : n + 1) * n / 2;
}

/// What is paired so that the part of n comes, and `rest` is added: smaller and larger vertex, if they are.
inline glm::uvec2 unpaired(Pairing pairing, std::uint32_t n, std::uint32_t rest)
{
    if (pairing == Pairing::cantor_larger) return {n - rest, rest};
    return {rest, pairing == Pairing::cantor_smaller ? n - rest : n};
}

/// Pairs of triangles that have an edge each with the same number in 32 bits.
inline void add_equal_pairings(IndexedMesh& mesh, Pairing pairing, Random& random)
{
    constexpr int pairs = 16;
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    const bool is_sum = pairing == Pairing::cantor_larger || pairing == Pairing::cantor_smaller;
    const std::uint32_t numbers = is_sum ? 2 * count : count;
    for (int pair = 0; pair < pairs; ++pair) {
        const std::uint32_t larger = count / 2 + random.below(count / 2 - 1);
        const std::uint32_t smaller = random.below(larger);
        const std::uint32_t n = is_sum ? smaller + larger : larger;
        const std::uint32_t key = square_part(pairing, n) + (pairing == Pairing::cantor_larger ? larger : smaller);
        for (std::uint32_t step = 1; step < numbers; ++step) {
            const std::uint32_t other = (n + step) % numbers;
            const glm::uvec2 edge = unpaired(pairing, other, key - square_part(pairing, other));
            if (edge.x >= edge.y || edge.y + 1 >= count) continue;
            mesh.triangles.emplace_back(smaller, larger, larger + 1);
            mesh.triangles.emplace_back(edge.x, edge.y, edge.y + 1);
            break;
        }
    }
}

/// Discs and triangles with equal keys in 32 bits, and others in 64: the number of vertices is one of the factors.
inline IndexedMesh equal_keys_in_32_bits(Variation& vary, Random& random)
{
    // So many vertices, 153,000 to 196,000, that `up` times as many are 2 to the power of 32 and less than `up` more.
    const std::uint32_t up = vary.near(25'000U, 3'000U);
    const auto count = static_cast<std::uint32_t>((std::uint64_t{1} << 32U) / up + 1);
    const std::uint32_t many = vary.near(120'000U, 5'000U);
    std::uint32_t few = vary.near(300U, 200U);
    IndexedMesh mesh = scattered(count);
    add_discs(mesh, few, many, up, up * count);
    for (const std::uint32_t factor : {262'144U, 1'000'000U, 1'048'576U}) {
        constexpr std::uint32_t most_down = 80'000;
        std::uint32_t times = 1;
        while (times * factor > most_down) ++times;  // modulo 2 to the power of 32
        add_discs(mesh, few += 1000, many, times, times * factor);
    }
    for (const Pairing pairing : {Pairing::cantor_larger, Pairing::cantor_smaller, Pairing::triangle, Pairing::square})
        add_equal_pairings(mesh, pairing, random);
    return mesh;
}

}
