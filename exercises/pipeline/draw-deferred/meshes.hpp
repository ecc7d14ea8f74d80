#pragma once

#include <cmath>
#include <kit/color.hpp>
#include <numbers>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/draw.hpp>

/// The meshes of the cases.
namespace umbral::pipeline {

/// Problem 1.2 grown into a rose window: a centre, and rings of vertices round it that swell and shrink into petals.
/// Each ring is turned against the one before by half a step, and its colours alternate between light and dark, so that
/// every triangle shows. `hue` turns all hues.
inline ColoredMesh rosette(int petals, int rings, float hue = 0)
{
    ColoredMesh mesh;
    const int around = 6 * petals;
    mesh.positions.emplace_back(0, 0, 0);
    mesh.colors.emplace_back(1, 0.95F, 0.8F);
    for (int ring = 1; ring <= rings; ++ring)
        for (int i = 0; i < around; ++i) {
            const float outwards = static_cast<float>(ring) / static_cast<float>(rings);
            const float turns =
                (static_cast<float>(i) + 0.5F * static_cast<float>(ring % 2)) / static_cast<float>(around);
            const float angle = 2 * std::numbers::pi_v<float> * turns;
            const float petal = std::cos(static_cast<float>(petals) * angle);
            const float radius = outwards * (0.82F + 0.15F * outwards * petal);
            mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
            const float light = 0.55F + 0.45F * std::cos(std::numbers::pi_v<float> * static_cast<float>(i + ring / 2));
            mesh.colors.push_back(
                rainbow(0.62F * outwards + 0.08F * petal + 0.55F + hue, 0.85F - 0.35F * light, 0.35F + 0.65F * light));
        }
    const auto at = [&](int ring, int i) {
        return static_cast<std::uint32_t>(ring == 0 ? 0 : 1 + (ring - 1) * around + (i + around) % around);
    };
    for (int ring = 1; ring <= rings; ++ring)
        for (int i = 0; i < around; ++i) {
            // Odd rings stand half a step further than even ones.
            const int inner = ring % 2 == 1 ? i : i - 1;
            for (const std::uint32_t index : {at(ring, i), at(ring, i + 1), at(ring - 1, inner + 1)})
                mesh.indices.push_back(index);
            if (ring == 1) continue;
            for (const std::uint32_t index : {at(ring, i), at(ring - 1, inner + 1), at(ring - 1, inner)})
                mesh.indices.push_back(index);
        }
    return mesh;
}

/// A sheet of columns x rows vertices over the square [-0.95, 0.95]², in soft bands of colour. It is bent away from the
/// viewer between its first row and its last, so that a triangle that wrongly joins the two is in front of it.
/// Triangles join every `step`-th vertex only: there are many vertices, and little to draw. `hue` turns all hues.
inline ColoredMesh sheet(int columns, int rows, int step, float hue = 0)
{
    ColoredMesh mesh;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::vec2 place(static_cast<float>(column) / static_cast<float>(columns - 1),
                                  static_cast<float>(row) / static_cast<float>(rows - 1));
            mesh.positions.emplace_back(1.9F * place - 0.95F, 0.8F * std::sin(std::numbers::pi_v<float> * place.y));
            const float wave = std::sin(9 * place.x + 4 * std::sin(5 * place.y)) * std::cos(7 * place.y);
            mesh.colors.push_back(rainbow(0.5F + hue + 0.2F * wave, 0.6F, 0.6F + 0.4F * place.y));
        }
    for (int row = 0; row + step < rows; row += step)
        for (int column = 0; column + step < columns; column += step) {
            const auto at = [&](int right, int up) {
                return static_cast<std::uint32_t>((row + up * step) * columns + column + right * step);
            };
            for (const std::uint32_t index : {at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)})
                mesh.indices.push_back(index);
        }
    return mesh;
}

/// As many vertices as 16 bits can number, all of them in use, and one more: the tip of a triangle in front of the
/// sheet.
inline ColoredMesh sheet_and_one(float hue = 0)
{
    ColoredMesh mesh = sheet(256, 256, 1, hue);
    mesh.positions.emplace_back(0, -0.6F, -0.5F);
    mesh.colors.emplace_back(1, 1, 1);
    const auto top = static_cast<std::uint32_t>(255 * 256);
    for (const std::uint32_t index : {top + 64, top + 256, top + 192}) mesh.indices.push_back(index);
    return mesh;
}

/// A regular polygon round `centre`, as problem 1.2 has it: its centre light, its rim in one hue.
inline ColoredMesh polygon(int corners, const glm::vec3& centre, float radius, float hue)
{
    ColoredMesh mesh;
    mesh.positions.push_back(centre);
    mesh.colors.push_back(rainbow(hue, 0.25F, 1));
    for (int i = 0; i < corners; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(corners);
        mesh.positions.push_back(centre + radius * glm::vec3(std::cos(angle), std::sin(angle), 0));
        mesh.colors.push_back(rainbow(hue + 0.1F * static_cast<float>(i % 2), 0.9F, 0.8F));
        const auto here = static_cast<std::uint32_t>(1 + i);
        for (const std::uint32_t index : {0U, here, static_cast<std::uint32_t>(1 + (i + 1) % corners)})
            mesh.indices.push_back(index);
    }
    return mesh;
}

/// Triangles anywhere, at any depth. Vertices are shared, in no order, and some belong to no triangle.
inline ColoredMesh random_mesh(Random& random, int vertices, int triangles)
{
    ColoredMesh mesh;
    for (int i = 0; i < vertices; ++i) {
        mesh.positions.push_back(0.95F * random.in_cube());
        mesh.colors.push_back(rainbow(random.uniform(), 0.8F, random.uniform(0.4F, 1)));
    }
    for (int i = 0; i < 3 * triangles; ++i) mesh.indices.push_back(random.below(static_cast<std::uint32_t>(vertices)));
    return mesh;
}

}
