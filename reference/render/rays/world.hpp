#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "raytrace/hierarchy.hpp"
#include "render/draw_list.hpp"
#include "render/shading.hpp"

namespace umbral::render::rays {

/// A triangle's corners in World::vertices, and whose it is.
struct Face {
    glm::uvec3 corners;
    std::uint32_t draw;  ///< place in DrawList::draws
};

/// All instances of a draw list in eye space, for rays: those that the camera does not see as well, for mirrors do.
struct World {
    const DrawList* list = nullptr;  ///< must outlive it
    std::vector<Vertex> vertices;    ///< normals are unit
    std::vector<Face> faces;
    raytrace::Hierarchy hierarchy;
};

[[nodiscard]] World make_world(const DrawList& list);

/// What a ray sees of a surface.
struct Seen {
    const Draw* draw = nullptr;
    std::uint32_t triangle = 0;  ///< place in World::faces
    glm::vec3 position{0};       ///< rounded, but within `lift` of the triangle
    glm::vec3 face{0};           ///< unit: the triangle's own normal, on the side that the ray comes from
    glm::vec3 normal{0};         ///< unit: the interpolated one, on that side too
    glm::vec2 uv{0};
    glm::vec3 smoothed{0};     ///< `position` lifted to the curved surface that the normals tell of; for shadows
    float lift = 0;            ///< rays that leave the surface begin this far from it
    bool from_behind = false;  ///< the ray comes from the inner side
};

/// The nearest surface on a ray. Backs of instances that show their front only are passed by, unless light goes through
/// their material.
/// Where normals are interpolated, shadows begin on the curved surface: J. Hanika. Hacking the Shadow Terminator. Ray
/// Tracing Gems II, 2021, chapter 4.
[[nodiscard]] std::optional<Seen> look(const World& world, Ray ray);

/// A ray from a surface: beginning on the side that `direction` leads to, far enough from it not to meet it again.
[[nodiscard]] Ray ray_from(const Seen& surface, const glm::vec3& origin, const glm::vec3& direction);

}
