#include "shapes.hpp"

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace umbral::bench::scenes {
namespace {

constexpr float pi = 3.14159265F;

void add(Triangles& mesh, const Vertex& a, const Vertex& b, const Vertex& c)
{
    const glm::vec3 n = glm::cross(b.position - a.position, c.position - a.position);
    if (glm::length(n) > 1e-6F) mesh.insert(mesh.end(), {a, b, c});
}

}

Triangles surface(int columns, int rows, const std::function<glm::vec3(glm::vec2)>& at)
{
    constexpr float step = 1e-3F;
    const auto vertex = [&](int i, int j) {
        const glm::vec2 uv(static_cast<float>(i) / static_cast<float>(columns),
                           static_cast<float>(j) / static_cast<float>(rows));
        // At a pole the differences vanish: they are taken a little inside.
        const glm::vec2 inside = glm::clamp(uv, 2 * step, 1 - 2 * step);
        const glm::vec3 along_u = at({inside.x + step, inside.y}) - at({inside.x - step, inside.y});
        const glm::vec3 along_v = at({inside.x, inside.y + step}) - at({inside.x, inside.y - step});
        return Vertex{at(uv), glm::normalize(glm::cross(along_u, along_v)), uv, glm::vec4(1)};
    };
    std::vector<Vertex> grid;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) grid.push_back(vertex(i, j));
    Triangles mesh;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const auto corner = [&](int di, int dj) {
                return grid[static_cast<std::size_t>((j + dj) * (columns + 1) + i + di)];
            };
            add(mesh, corner(0, 0), corner(1, 0), corner(1, 1));
            add(mesh, corner(0, 0), corner(1, 1), corner(0, 1));
        }
    return mesh;
}

Triangles ball(int sectors, int rings)
{
    Triangles mesh = surface(sectors, rings, [](glm::vec2 uv) {
        const float latitude = (uv.y - 0.5F) * pi;
        const float longitude = 2 * pi * uv.x;
        return glm::vec3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                         std::cos(latitude) * std::cos(longitude));
    });
    for (Vertex& v : mesh) v.normal = glm::normalize(v.position);
    return mesh;
}

Triangles torus(float tube, int sectors, int sides)
{
    return surface(sectors, sides, [tube](glm::vec2 uv) {
        const float a = 2 * pi * uv.x;
        const float b = 2 * pi * uv.y;
        const float r = 1 + tube * std::cos(b);
        return glm::vec3(r * std::sin(a), tube * std::sin(b), r * std::cos(a));
    });
}

Triangles knot(float tube, int sectors, int sides)
{
    const auto middle = [](float t) {
        const float r = 0.75F + 0.3F * std::cos(3 * t);
        return glm::vec3(r * std::cos(2 * t), 0.35F * std::sin(3 * t), r * std::sin(2 * t));
    };
    return surface(sectors, sides, [&](glm::vec2 uv) {
        const float t = 2 * pi * uv.x;
        const glm::vec3 along = glm::normalize(middle(t + 1e-2F) - middle(t - 1e-2F));
        const glm::vec3 side = glm::normalize(glm::cross(along, glm::vec3(0, 1, 0)));
        const glm::vec3 up = glm::cross(side, along);
        const float b = 2 * pi * uv.y;
        return middle(t) + tube * (std::cos(b) * side + std::sin(b) * up);
    });
}

Triangles lathe(std::span<const glm::vec2> profile, int sectors)
{
    const int rows = static_cast<int>(profile.size() - 1);
    // Piecewise cubic through the points (Catmull and Rom), four cells between neighbours.
    const auto on_profile = [&](float t) {
        const float place = std::clamp(t, 0.0F, 1.0F) * static_cast<float>(rows);
        const int i = std::min(static_cast<int>(place), rows - 1);
        const float f = place - static_cast<float>(i);
        const auto point = [&](int k) { return profile[static_cast<std::size_t>(std::clamp(k, 0, rows))]; };
        const glm::vec2 p0 = point(i - 1), p1 = point(i), p2 = point(i + 1), p3 = point(i + 2);
        return 0.5F * (2.0F * p1 + (p2 - p0) * f + (2.0F * p0 - 5.0F * p1 + 4.0F * p2 - p3) * f * f +
                       (3.0F * p1 - p0 - 3.0F * p2 + p3) * f * f * f);
    };
    return surface(sectors, 4 * rows, [&](glm::vec2 uv) {
        const glm::vec2 p = on_profile(uv.y);
        return glm::vec3(p.x * std::sin(2 * pi * uv.x), p.y, p.x * std::cos(2 * pi * uv.x));
    });
}

Triangles vase(int sectors)
{
    constexpr auto profile = std::to_array<glm::vec2>({{0.45F, -1},
                                                       {0.50F, -0.95F},
                                                       {0.80F, -0.5F},
                                                       {0.88F, -0.1F},
                                                       {0.60F, 0.4F},
                                                       {0.34F, 0.7F},
                                                       {0.40F, 0.9F},
                                                       {0.55F, 1}});
    return lathe(profile, sectors);
}

Triangles square(int cells)
{
    return surface(cells, cells, [](glm::vec2 uv) { return glm::vec3(2.0F * uv - 1.0F, 0); });
}

Triangles ground(int cells)
{
    return surface(cells, cells, [](glm::vec2 uv) { return glm::vec3(2 * uv.x - 1, 0, 1 - 2 * uv.y); });
}

Triangles box(const glm::vec3& half)
{
    Triangles mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0F, 1.0F}) {
            const auto turned = [&](const glm::vec3& v) {  // +z to the axis, right-handed
                glm::vec3 r(0);
                r[axis] = sign * v.z;
                r[(axis + 1) % 3] = sign * v.x;
                r[(axis + 2) % 3] = v.y;
                return r;
            };
            for (Vertex v : square()) {
                v.position = half * turned({v.position.x, v.position.y, 1});
                v.normal = turned({0, 0, 1});
                mesh.push_back(v);
            }
        }
    return mesh;
}

Triangles gem(int rounds)
{
    const float golden = (1 + std::sqrt(5.0F)) / 2;
    const std::array<glm::vec3, 12> p = {{{-1, golden, 0},
                                          {1, golden, 0},
                                          {-1, -golden, 0},
                                          {1, -golden, 0},
                                          {0, -1, golden},
                                          {0, 1, golden},
                                          {0, -1, -golden},
                                          {0, 1, -golden},
                                          {golden, 0, -1},
                                          {golden, 0, 1},
                                          {-golden, 0, -1},
                                          {-golden, 0, 1}}};
    constexpr auto faces =
        std::to_array<glm::uvec3>({{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                   {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                   {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (const glm::uvec3& f : faces)
        triangles.push_back({glm::normalize(p[f.x]), glm::normalize(p[f.y]), glm::normalize(p[f.z])});
    for (; rounds > 0; --rounds) {
        std::vector<std::array<glm::vec3, 3>> finer;
        for (const auto& [a, b, c] : triangles) {
            const glm::vec3 ab = glm::normalize(a + b);
            const glm::vec3 bc = glm::normalize(b + c);
            const glm::vec3 ca = glm::normalize(c + a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        triangles = finer;
    }
    Triangles mesh;
    for (const auto& [a, b, c] : triangles) {
        const glm::vec3 n = glm::normalize(glm::cross(b - a, c - a));
        for (const glm::vec3& corner : {a, b, c}) mesh.push_back({corner, n, {corner.x, corner.y}, glm::vec4(1)});
    }
    return mesh;
}

void add_stroke(Triangles& strokes, const glm::vec2& from, const glm::vec2& to, float width, const glm::vec4& color)
{
    const glm::vec2 along = glm::normalize(to - from);
    const glm::vec2 aside = glm::vec2(-along.y, along.x) * (width / 2);
    const auto corner = [&](const glm::vec2& p) { return Vertex{{p, 0}, {0, 0, 1}, {0, 0}, color}; };
    strokes.insert(strokes.end(), {corner(from - aside), corner(to - aside), corner(to + aside), corner(from - aside),
                                   corner(to + aside), corner(from + aside)});
}

Triangles edges_of(const Triangles& mesh)
{
    std::set<std::array<float, 6>> known;
    Triangles edges;
    for (std::size_t i = 0; i + 2 < mesh.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vertex& a = mesh[i + k];
            const Vertex& b = mesh[i + (k + 1) % 3];
            const auto key = [](const glm::vec3& p, const glm::vec3& q) {
                return std::array{p.x, p.y, p.z, q.x, q.y, q.z};
            };
            if (known.contains(key(b.position, a.position)) || !known.insert(key(a.position, b.position)).second)
                continue;
            edges.insert(edges.end(), {a, b});
        }
    return edges;
}

void paint(Triangles& mesh, const std::function<glm::vec4(const Vertex&)>& color)
{
    for (Vertex& v : mesh) v.color = color(v);
}

Triangles joined(std::initializer_list<Triangles> parts)
{
    Triangles all;
    for (const Triangles& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

Triangles moved(Triangles mesh, const glm::mat4& by)
{
    const glm::mat3 normals = glm::transpose(glm::inverse(glm::mat3(by)));
    for (Vertex& v : mesh) {
        v.position = glm::vec3(by * glm::vec4(v.position, 1));
        v.normal = glm::normalize(normals * v.normal);
    }
    return mesh;
}

}
