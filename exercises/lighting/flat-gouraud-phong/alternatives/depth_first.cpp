// alternative: makes the depth test by hand, in one function for all methods with a colour for each fragment; in float
#include <umbral/lighting/shading_methods.hpp>
#include <vector>

namespace umbral::lighting {
namespace {

using Color = std::function<glm::vec3(std::size_t, const pipeline::Fragment&)>;

void draw_all(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles, pipeline::Layer& target,
              const Color& color)
{
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const glm::uvec3& t = triangles[i];
        std::vector<pipeline::Fragment> fragments;
        pipeline::rasterize_triangle({vertices[t.x].window, vertices[t.y].window, vertices[t.z].window},
                                     target.colors.width, target.colors.height, fragments);
        for (const pipeline::Fragment& fragment : fragments) {
            float& depth = target.depths.at(fragment.pixel.x, fragment.pixel.y);
            if (!(fragment.depth < depth)) continue;
            depth = fragment.depth;
            target.colors.at(fragment.pixel.x, fragment.pixel.y) = color(i, fragment);
        }
    }
}

glm::vec3 safe_unit(const glm::vec3& v)
{
    const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest > 0 ? normalize(v / largest) : glm::vec3(0);
}

}

void draw_flat(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
               const Illumination& illumination, pipeline::Layer& target)
{
    std::vector<glm::vec3> light;
    for (const glm::uvec3& t : triangles) {
        const glm::vec3& c = vertices[t.z].at.position;
        // Unit sides first: the product of short ones would vanish.
        const glm::vec3 u = safe_unit(vertices[t.x].at.position - c);
        const glm::vec3 v = safe_unit(vertices[t.y].at.position - c);
        light.push_back(illumination({c, safe_unit(cross(u, v))}));
    }
    draw_all(vertices, triangles, target, [&](std::size_t i, const pipeline::Fragment&) { return light[i]; });
}

void draw_gouraud(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
                  const Illumination& illumination, pipeline::Layer& target)
{
    std::vector<glm::vec3> light(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) light[i] = illumination(vertices[i].at);
    draw_all(vertices, triangles, target, [&](std::size_t i, const pipeline::Fragment& fragment) {
        const glm::uvec3& t = triangles[i];
        return glm::mat3(light[t.x], light[t.y], light[t.z]) * fragment.weights;
    });
}

void draw_phong(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
                const Illumination& illumination, pipeline::Layer& target)
{
    draw_all(vertices, triangles, target, [&](std::size_t i, const pipeline::Fragment& fragment) {
        const SurfacePoint& a = vertices[triangles[i].x].at;
        const SurfacePoint& b = vertices[triangles[i].y].at;
        const SurfacePoint& c = vertices[triangles[i].z].at;
        const glm::vec3 place = glm::mat3(a.position, b.position, c.position) * fragment.weights;
        return illumination({place, safe_unit(glm::mat3(a.normal, b.normal, c.normal) * fragment.weights)});
    });
}

}
