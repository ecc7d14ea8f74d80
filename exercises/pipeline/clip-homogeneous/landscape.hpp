#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/drawing.hpp>
#include <umbral/pipeline/clip.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

/// Hills that a camera stands in: many triangles cross the sides of its view volume, and some reach behind it. The goal
/// picture shows them from outside.
namespace umbral::pipeline {

using ClipTriangle = std::array<glm::vec4, 3>;

/// What the unit appends for a triangle. The vector holds its first corner before, as that of a neighbour: a unit that
/// overwrites it loses a corner, and so does one that takes it for its own. Or it is empty.
inline std::vector<ClipVertex> clipped(Recorder& out, const ClipTriangle& triangle, bool is_empty = false)
{
    std::vector<ClipVertex> polygon;
    if (!is_empty) polygon.push_back({triangle[0], {0, 0, 0}});
    ask<clip_triangle>(out, triangle, polygon);
    if (!is_empty && !polygon.empty()) polygon.erase(polygon.begin());
    return polygon;
}

/// A camera at the origin that looks along -z.
inline glm::mat4 perspective(float zoom, float aspect, float near_plane, float far_plane)
{
    glm::mat4 matrix(0);
    matrix[0][0] = zoom / aspect;
    matrix[1][1] = zoom;
    matrix[2][2] = -(far_plane + near_plane) / (far_plane - near_plane);
    matrix[2][3] = -1;
    matrix[3][2] = -2 * far_plane * near_plane / (far_plane - near_plane);
    return matrix;
}

struct Landscape {
    std::vector<std::array<glm::vec3, 3>> triangles;  ///< in camera coordinates
    glm::mat4 projection = perspective(2.7F, 1.6F, 0.9F, 5);

    [[nodiscard]] ClipTriangle projected(std::size_t i) const
    {
        const auto& [a, b, c] = triangles[i];
        return {projection * glm::vec4(a, 1), projection * glm::vec4(b, 1), projection * glm::vec4(c, 1)};
    }
};

/// Where the hills stand, and how they are cut into triangles.
struct Ground {
    glm::vec2 shift{0};  ///< of squares, along x and z
    float phase = 0.6F;
    int cut = 0;  ///< 1: along the other diagonal of each square
};

inline Ground varied_ground(Variation& vary)
{
    Ground ground;
    ground.shift = vary.near(ground.shift, 0.2F);
    ground.phase = vary.near(vary.one_of(ground.phase, std::array{0.2F, 1.0F}), 0.2F);
    ground.cut = vary.one_of(ground.cut, std::array{1});
    return ground;
}

/// `cells` x `cells` squares of two triangles, from behind the camera to beyond the far plane.
inline Landscape hills(int cells, const Ground& ground)
{
    Landscape land;
    const auto corner = [&](int column, int row) {
        const float x = ground.shift.x - 3.2F + 6.4F * static_cast<float>(column) / static_cast<float>(cells);
        const float z = ground.shift.y + 1.3F - 7.6F * static_cast<float>(row) / static_cast<float>(cells);
        return glm::vec3(
            x,
            -0.28F + 0.42F * std::sin(1.5F * x + ground.phase) * std::cos(1.25F * z) + 0.16F * std::sin(2.6F * z - x),
            z);
    };
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const glm::vec3 a = corner(column, row);
            const glm::vec3 b = corner(column + 1, row);
            const glm::vec3 c = corner(column + 1, row + 1);
            const glm::vec3 d = corner(column, row + 1);
            const bool rising = (row + column) % 2 == ground.cut;
            land.triangles.push_back({a, b, rising ? c : d});
            land.triangles.push_back({rising ? a : b, c, d});
        }
    return land;
}

namespace detail {

/// The second camera, which looks at the first one's view volume from outside.
class Onlooker {
public:
    [[nodiscard]] glm::dvec2 place(const glm::dvec3& point) const
    {
        const glm::dvec4 eye = view_ * glm::dvec4(point, 1);
        return glm::dvec2(eye) / -eye.z;
    }
    [[nodiscard]] double distance(const glm::dvec3& point) const { return glm::distance(point, eye_); }

private:
    glm::dvec3 eye_{4.1, 3.1, 2.1};
    glm::dmat4 view_ = glm::lookAt(eye_, glm::dvec3(-0.05, -0.2, -2.75), glm::dvec3(0, 1, 0));
};

inline glm::vec3 color_of_height(float y)
{
    const float t = std::clamp((y + 0.85F) / 1.1F, 0.0F, 1.0F);
    return t < 0.5F ? glm::mix(ink::blue, ink::green, 2 * t) : glm::mix(ink::green, ink::orange, 2 * t - 1);
}

/// A clipped triangle, ready to be drawn: its places, and what its weights make of the corners' colours.
struct Facet {
    std::vector<glm::dvec2> outline;
    std::vector<bool> is_new;
    glm::vec3 color{0};
    double distance = 0;
};

inline Facet facet(Recorder& out, const Landscape& land, std::size_t i, const Onlooker& onlooker)
{
    const glm::dmat4 back = glm::inverse(glm::dmat4(land.projection));
    const auto& corners = land.triangles[i];
    std::vector<ClipVertex> polygon = clipped(out, land.projected(i));
    polygon.resize(std::min<std::size_t>(polygon.size(), 12));
    Facet result;
    for (const ClipVertex& vertex : polygon) {
        const glm::dvec4 eye = back * glm::dvec4(vertex.position);
        const glm::dvec3 point = glm::dvec3(eye) / eye.w;
        result.outline.push_back(onlooker.place(point));
        result.is_new.push_back(std::max({vertex.weights.x, vertex.weights.y, vertex.weights.z}) < 1);
        for (int k = 0; k < 3; ++k)
            result.color += vertex.weights[k] * color_of_height(corners[static_cast<std::size_t>(k)].y) /
                            static_cast<float>(polygon.size());
        result.distance += onlooker.distance(point) / static_cast<double>(polygon.size());
    }
    if (!std::isfinite(result.distance)) result.distance = 0;  // they are sorted by it
    const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    result.color *= 0.55F + 0.45F * std::abs(glm::dot(normal, glm::normalize(glm::vec3(0.75F, 0.65F, 0.1F))));
    return result;
}

/// The twelve sides of the view volume; those that lie in front of the hills for the onlooker are drawn after them.
inline void draw_volume(Drawing& drawing, const Landscape& land, const Onlooker& onlooker, bool in_front)
{
    const glm::dmat4 back = glm::inverse(glm::dmat4(land.projection));
    const auto corner = [&](int bits) {
        const glm::dvec4 eye =
            back * glm::dvec4((bits & 1) != 0 ? 1 : -1, (bits & 2) != 0 ? 1 : -1, (bits & 4) != 0 ? 1 : -1, 1);
        return onlooker.place(glm::dvec3(eye) / eye.w);
    };
    for (int bits = 0; bits < 8; ++bits)
        for (const int axis : {1, 2, 4}) {
            if ((bits & axis) != 0) continue;
            const bool seen_first = ((bits | axis) & 1) != 0 && ((bits & 2) != 0 || axis == 2 || (bits & 1) != 0);
            if (seen_first != in_front) continue;
            drawing.line(corner(bits), corner(bits | axis), ink::white, in_front ? 2 : 1.5, in_front ? 0.9 : 0.45);
        }
    if (in_front) return;
    for (const int bits : {0, 1, 2, 3}) drawing.line(onlooker.place(glm::dvec3(0)), corner(bits), ink::mist, 1, 0.6);
    drawing.disc(onlooker.place(glm::dvec3(0)), 6, ink::white);
}

}

/// What the unit keeps is coloured, with dots at new corners; the rest of the hills are thin lines.
inline Image draw_hills(Recorder& out, Variation& vary)
{
    const Landscape land = hills(18, varied_ground(vary));
    const detail::Onlooker onlooker;
    Drawing drawing(640, 420, {-0.73, -0.48}, {0.73, 0.48});
    for (const auto& [a, b, c] : land.triangles)
        drawing.outline(std::array{onlooker.place(a), onlooker.place(b), onlooker.place(c)}, ink::slate, 1);
    detail::draw_volume(drawing, land, onlooker, false);

    std::vector<detail::Facet> facets;
    for (std::size_t i = 0; i < land.triangles.size(); ++i) facets.push_back(detail::facet(out, land, i, onlooker));
    std::stable_sort(facets.begin(), facets.end(),
                     [](const detail::Facet& a, const detail::Facet& b) { return a.distance > b.distance; });
    for (const detail::Facet& facet : facets) {
        drawing.area(facet.outline, facet.color);
        drawing.outline(facet.outline, 0.55F * facet.color, 1);
    }
    for (const detail::Facet& facet : facets)
        for (std::size_t i = 0; i < facet.outline.size(); ++i)
            if (facet.is_new[i]) drawing.disc(facet.outline[i], 2.2, ink::white);
    detail::draw_volume(drawing, land, onlooker, true);
    return drawing.picture();
}

}
