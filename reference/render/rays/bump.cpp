#include "render/rays/bump.hpp"

#include <umbral/texturing/bump.hpp>

namespace umbral::render::rays {
namespace {

/// Without the part along the normal.
glm::vec3 without_part_along(const glm::vec3& tangent, const glm::vec3& normal)
{
    return tangent - dot(tangent, normal) * normal;
}

}

glm::vec3 bumped(const World& world, const Seen& seen, const glm::vec3& direction)
{
    const scene::Material& material = seen.draw->material;
    const Face& face = world.faces[seen.triangle];
    const auto corner = [&](int i) -> const Vertex& { return world.vertices[face.corners[i]]; };
    const auto uv = [&](int i) { return corner(i).uv * material.texture_scale; };
    texturing::Tangents tangents = texturing::triangle_tangents(
        {corner(0).position, corner(1).position, corner(2).position}, {uv(0), uv(1), uv(2)});
    // Heights are counted outwards, whichever side is seen.
    const glm::vec3 outward = seen.from_behind ? -seen.normal : seen.normal;
    tangents.u = without_part_along(tangents.u, outward);
    tangents.v = without_part_along(tangents.v, outward);
    const Grid<glm::vec4>& heights = world.list->textures[*seen.draw->bump].texels;
    const glm::vec2 slopes = texturing::slopes(heights, seen.uv * material.texture_scale, material.bump_height);
    const glm::vec3 raised = texturing::bumped_normal(outward, tangents, slopes);
    if (!(dot(raised, raised) > 0.5F)) return seen.normal;
    const glm::vec3 normal = seen.from_behind ? -raised : raised;
    const glm::vec3 to_viewer = -normalize(direction);
    const float cosine = dot(normal, to_viewer);
    return cosine > 0 ? normal : normalize(normal + (1e-3F - cosine) * to_viewer);
}

}
