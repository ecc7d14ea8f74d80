#include <umbral/lighting/shading_methods.hpp>

namespace umbral::lighting {

void draw_flat(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
               const Illumination& illumination, pipeline::Layer& target)
{
    // TODO: for each triangle: its fragments by rasterize_triangle; its light, from its last corner's place and its own
    // normal; the depth test; the light into each pixel that is left.
    not_implemented<int>(vertices, triangles, illumination, target);
}

void draw_gouraud(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
                  const Illumination& illumination, pipeline::Layer& target)
{
    // TODO: first the light of all vertices; then each triangle, mixing its corners' light by the weights.
    not_implemented<int>(vertices, triangles, illumination, target);
}

void draw_phong(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
                const Illumination& illumination, pipeline::Layer& target)
{
    // TODO: for each fragment that passes the depth test: place and normal by the weights, the normal made unit, and
    // only then the light.
    not_implemented<int>(vertices, triangles, illumination, target);
}

}
