#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <kit/attributes.hpp>
#include <kit/double_frame.hpp>
#include <kit/shading.hpp>
#include <numbers>
#include <umbral/projections/curved.hpp>

#include "hall.hpp"

/// Pictures of a hall through the unit's functions: its triangles are cut and projected by them, and drawn by OpenGL.
namespace umbral::projections {

inline constexpr const char* hall_vertex_shader = R"(#version 330 core
in vec3 position;
in vec3 world_place;
in vec3 world_normal;
out vec2 disc;
out vec3 place;
out vec3 normal;

void main()
{
    disc = position.xy;
    place = world_place;
    normal = world_normal;
    gl_Position = vec4(position, 1.0);
}
)";

inline constexpr const char* hall_fragment_shader = R"(
in vec2 disc;
in vec3 place;
in vec3 normal;
uniform vec3 color;
uniform vec3 odd;
uniform float tile;
uniform float glow;
uniform vec3 eye;
uniform int is_disc;
out vec4 fragment_color;

void main()
{
    if (is_disc != 0 && dot(disc, disc) > 0.985) discard;
    vec3 n = normalize(normal);
    vec3 paint = color;
    if (tile > 0.0) {
        ivec3 at = ivec3(floor((place - 0.01 * n) / tile));
        if (((at.x + at.y + at.z) & 1) != 0) paint = odd;
    }
    vec3 to_lamp = vec3(0.0, 3.6, -1.0) - place;
    float key = 11.0 / (6.0 + dot(to_lamp, to_lamp));
    // Corners get less light from all around.
    vec3 gap = min(vec3(6.0, 5.0, 6.0) - abs(place - vec3(0.0, 0.0, 0.0)), vec3(1.2));
    float open = 0.55 + 0.45 * smoothstep(0.0, 2.2, min(gap.x, gap.z) + min(place.y, 1.2));
    vec3 shade = open * lit(paint, 0.12, n, normalize(eye - place), normalize(to_lamp), key);
    fragment_color = vec4(srgb_encoded(mix(shade, paint, glow)), 1.0);
}
)";

/// Where an eye stands in the hall, and the columns of this matrix are its axes: right, up, back.
struct HallView {
    glm::vec3 eye;
    glm::mat3 axes;
};

/// The view towards a point, the picture's up as near to +y as it can be (or to -z, from below).
inline HallView hall_view(const glm::vec3& eye, const glm::vec3& target)
{
    const glm::vec3 back = normalize(eye - target);
    const glm::vec3 up = std::abs(back.y) > 0.9F ? glm::vec3(0, 0, -back.y) : glm::vec3(0, 1, 0);
    const glm::vec3 right = normalize(cross(up, back));
    return {eye, {right, cross(back, right), back}};
}

/// Vertices of triangles as OpenGL takes them.
struct HallVertices {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> world_place;
    std::vector<glm::vec3> world_normal;
    std::vector<std::uint32_t> indices;

    void add(const std::array<glm::vec3, 3>& seen, const std::array<glm::vec3, 3>& world)
    {
        const glm::vec3 normal = cross(world[1] - world[0], world[2] - world[0]);
        for (std::size_t i = 0; i < 3; ++i) {
            indices.push_back(static_cast<std::uint32_t>(position.size()));
            position.push_back(seen[i]);
            world_place.push_back(world[i]);
            world_normal.push_back(normal);
        }
    }
};

/// Depth in [-1, 1] of what is at most 20 away.
inline float hall_depth(float distance) { return distance / 10 - 1; }

/// A triangle of camera coordinates as a fisheye lens sees it; none of it if a corner has no place.
inline void add_to_disc(HallVertices& vertices, std::span<const glm::vec3> corners,
                        const std::array<glm::vec3, 3>& world)
{
    std::array<glm::vec3, 3> seen{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<CurvedPoint> point = spherical_projection(corners[i]);
        if (!point) return;
        seen[i] = glm::vec3(point->place, hall_depth(point->distance));
    }
    vertices.add(seen, world);
}

/// The same on the cylinder, whose picture shows heights up to `reach`; twice, if it lies across the seam.
inline void add_to_panorama(HallVertices& vertices, std::span<const glm::vec3> corners,
                            const std::array<glm::vec3, 3>& world, float reach)
{
    constexpr float pi = std::numbers::pi_v<float>;
    std::array<float, 3> angles{};
    std::array<glm::vec3, 3> seen{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<CurvedPoint> point = cylindrical_projection(corners[i]);
        if (!point) return;
        angles[i] = point->place.x;
        seen[i] = glm::vec3(0, point->place.y / reach, hall_depth(point->distance));
    }
    angles = without_seam(angles);
    const auto [least, most] = std::minmax_element(angles.begin(), angles.end());
    for (const float shift : {0.0F, 2 * pi, -2 * pi}) {
        if (shift > 0 && *least >= -pi) continue;
        if (shift < 0 && *most <= pi) continue;
        for (std::size_t i = 0; i < 3; ++i) seen[i].x = (angles[i] + shift) / pi;
        vertices.add(seen, world);
    }
}

/// Draws the hall into the current viewport. `add(vertices, corners, world)` projects one triangle.
template <class Add>
void draw_hall(const gl::Program& program, const std::vector<HallPart>& hall, const HallView& view, Add add)
{
    program.set("eye", view.eye);
    for (const HallPart& part : hall) {
        std::vector<glm::vec3> seen;
        for (const glm::vec3& corner : part.corners) seen.push_back(transpose(view.axes) * (corner - view.eye));
        const std::vector<glm::vec3> cut = tessellated(seen, 0.2F);
        HallVertices vertices;
        // Of a list that is far too long only the beginning is drawn.
        for (std::size_t i = 0; i + 3 <= std::min<std::size_t>(cut.size(), 200'000); i += 3) {
            const auto world = [&](std::size_t k) { return view.axes * cut[i + k] + view.eye; };
            add(vertices, std::span(cut).subspan(i, 3), std::array{world(0), world(1), world(2)});
        }
        if (vertices.indices.empty()) continue;
        program.set("color", part.color);
        program.set("odd", part.odd);
        program.set("tile", part.tile);
        program.set("glow", part.glow);
        AttributeMesh(program, vertices.indices,
                      {{"position", vertices.position},
                       {"world_place", vertices.world_place},
                       {"world_normal", vertices.world_normal}})
            .draw();
    }
}

}
