// Based on: H. Gouraud. Continuous Shading of Curved Surfaces. IEEE Transactions on Computers 20 (1971); B. T. Phong.
// Illumination for Computer Generated Pictures. Communications of the ACM 18 (1975).

#include <umbral/lighting/shading_methods.hpp>
#include <vector>

namespace umbral::lighting {
namespace {

glm::vec3 unit_or_null(const glm::dvec3& v)
{
    const double size = length(v);
    return size > 0 ? glm::vec3(v / size) : glm::vec3(0);
}

/// Draws each triangle with the colours that `shader`, made for it by make_shader(triangle), gives to fragments.
template <class MakeShader>
void draw(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles, pipeline::Layer& target,
          MakeShader make_shader)
{
    std::vector<pipeline::Fragment> fragments;
    for (const glm::uvec3& triangle : triangles) {
        fragments.clear();
        rasterize_triangle({vertices[triangle[0]].window, vertices[triangle[1]].window, vertices[triangle[2]].window},
                           target.colors.width, target.colors.height, fragments);
        if (fragments.empty()) continue;
        const auto shader = make_shader(triangle);
        test_depth({}, fragments, target.depths);
        for (const pipeline::Fragment& fragment : fragments)
            target.colors.at(fragment.pixel.x, fragment.pixel.y) = shader(fragment);
    }
}

}

void draw_flat(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
               const Illumination& illumination, pipeline::Layer& target)
{
    draw(vertices, triangles, target, [&](const glm::uvec3& triangle) {
        const glm::dvec3 a(vertices[triangle[0]].at.position);
        const glm::dvec3 b(vertices[triangle[1]].at.position);
        const glm::vec3& last = vertices[triangle[2]].at.position;
        const glm::vec3 light = illumination({last, unit_or_null(cross(b - a, glm::dvec3(last) - a))});
        return [light](const pipeline::Fragment&) { return light; };
    });
}

void draw_gouraud(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
                  const Illumination& illumination, pipeline::Layer& target)
{
    std::vector<glm::vec3> light;
    light.reserve(vertices.size());
    for (const StagedVertex& vertex : vertices) light.push_back(illumination(vertex.at));
    draw(vertices, triangles, target, [&](const glm::uvec3& triangle) {
        return [&light, triangle](const pipeline::Fragment& fragment) {
            const glm::vec3& w = fragment.weights;
            return w[0] * light[triangle[0]] + w[1] * light[triangle[1]] + w[2] * light[triangle[2]];
        };
    });
}

void draw_phong(std::span<const StagedVertex> vertices, std::span<const glm::uvec3> triangles,
                const Illumination& illumination, pipeline::Layer& target)
{
    draw(vertices, triangles, target, [&](const glm::uvec3& triangle) {
        return [&, triangle](const pipeline::Fragment& fragment) {
            glm::dvec3 position(0);
            glm::dvec3 normal(0);
            for (int i = 0; i < 3; ++i) {
                const SurfacePoint& corner = vertices[triangle[i]].at;
                position += double{fragment.weights[i]} * glm::dvec3(corner.position);
                normal += double{fragment.weights[i]} * glm::dvec3(corner.normal);
            }
            return illumination({glm::vec3(position), unit_or_null(normal)});
        };
    });
}

}
