#include "render/rays/world.hpp"

#include <algorithm>
#include <cmath>

namespace umbral::render::rays {
namespace {

/// Of the largest coordinate: what places and the sums for them are rounded by, and some more.
constexpr float rounding = 0x1p-19F;

float largest(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

bool lets_light_through(const Draw& draw) { return draw.material.transmit != glm::vec3(0); }

void add(const DrawList& list, std::uint32_t place, World& world)
{
    const Draw& draw = list.draws[place];
    const VertexMesh& mesh = list.meshes[draw.mesh];
    const auto first = static_cast<std::uint32_t>(world.vertices.size());
    for (const Vertex& vertex : mesh.vertices)
        world.vertices.push_back({glm::vec3(draw.model_view * glm::vec4(vertex.position, 1)),
                                  normalize(draw.normal_matrix * vertex.normal), vertex.uv});
    for (glm::uvec3 triangle : mesh.triangles) {
        // Counter-clockwise stays the front.
        if (draw.mirrored) std::swap(triangle.y, triangle.z);
        world.faces.push_back({triangle + glm::uvec3(first), place});
    }
}

Seen seen_at(const World& world, const Ray& ray, const raytrace::Hit& hit)
{
    const Face& face = world.faces[hit.triangle];
    const Vertex& a = world.vertices[face.corners.x];
    const Vertex& b = world.vertices[face.corners.y];
    const Vertex& c = world.vertices[face.corners.z];
    const glm::vec3 weights(1 - hit.u - hit.v, hit.u, hit.v);
    Seen seen;
    seen.draw = &world.list->draws[face.draw];
    seen.triangle = hit.triangle;
    seen.position = weights.x * a.position + weights.y * b.position + weights.z * c.position;
    seen.uv = weights.x * a.uv + weights.y * b.uv + weights.z * c.uv;
    seen.lift = rounding * std::max({largest(a.position), largest(b.position), largest(c.position)});
    const glm::dvec3 ab = glm::dvec3(b.position) - glm::dvec3(a.position);
    const glm::dvec3 ac = glm::dvec3(c.position) - glm::dvec3(a.position);
    seen.face = glm::vec3(normalize(cross(ab, ac)));
    seen.from_behind = dot(seen.face, ray.direction) > 0;
    glm::vec3 normal = seen.face;
    if (seen.draw->smooth) {
        const glm::vec3 blend = weights.x * a.normal + weights.y * b.normal + weights.z * c.normal;
        if (length(blend) > 0) normal = normalize(blend);
    }
    const float side = seen.from_behind ? -1.0F : 1.0F;
    seen.face *= side;
    seen.normal = side * normal;
    seen.smoothed = seen.position;
    if (seen.draw->smooth && !seen.from_behind)
        for (int i = 0; i < 3; ++i) {
            const Vertex& corner = i == 0 ? a : i == 1 ? b : c;
            const glm::vec3& n = corner.normal;
            seen.smoothed -= weights[i] * std::min(0.0F, dot(seen.position - corner.position, n)) * n;
        }
    return seen;
}

}

World make_world(const DrawList& list)
{
    World world;
    world.list = &list;
    for (std::uint32_t i = 0; i < list.draws.size(); ++i) add(list, i, world);
    std::vector<raytrace::Corners> triangles;
    triangles.reserve(world.faces.size());
    for (const Face& face : world.faces)
        triangles.push_back({world.vertices[face.corners.x].position, world.vertices[face.corners.y].position,
                             world.vertices[face.corners.z].position});
    world.hierarchy = raytrace::make_hierarchy(triangles);
    return world;
}

std::optional<Seen> look(const World& world, Ray ray)
{
    while (true) {
        const raytrace::Hit hit = raytrace::first_hit(world.hierarchy, ray);
        if (hit.triangle == raytrace::Hit::nothing) return std::nullopt;
        Seen seen = seen_at(world, ray, hit);
        if (!seen.from_behind || seen.draw->both_sides || lets_light_through(*seen.draw)) return seen;
        ray.t_min = hit.t;
    }
}

Ray ray_from(const Seen& surface, const glm::vec3& origin, const glm::vec3& direction)
{
    const float side = dot(surface.face, direction) < 0 ? -1.0F : 1.0F;
    return {origin + side * surface.lift * surface.face, direction};
}

}
