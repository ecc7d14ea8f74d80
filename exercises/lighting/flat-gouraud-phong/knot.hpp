#pragma once

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/picture.hpp>
#include <kit/shapes.hpp>
#include <umbral/lighting/blinn_phong.hpp>
#include <umbral/lighting/shading_methods.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

/// The goal picture: a knot of few triangles, from left to right in flat, Gouraud and Phong shading.
namespace umbral::lighting {

/// The vertices of a shape as a camera sees them; all lie in front of it. Rows go downwards.
inline std::vector<StagedVertex> staged(const shapes::Shape& shape, const glm::mat4& model, const glm::mat4& camera,
                                        const glm::vec2& size)
{
    const glm::mat3 turned = glm::transpose(glm::inverse(glm::mat3(model)));
    std::vector<StagedVertex> vertices;
    for (std::size_t i = 0; i < shape.positions.size(); ++i) {
        const glm::vec4 world = model * glm::vec4(shape.positions[i], 1);
        const glm::vec4 clip = camera * world;
        const glm::vec3 ndc = glm::vec3(clip) / clip.w;
        const glm::vec2 place = size * (0.5F + glm::vec2(0.5F, -0.5F) * glm::vec2(ndc));
        vertices.push_back(
            {{place, 0.5F + 0.5F * ndc.z, 1 / clip.w}, {glm::vec3(world), normalize(turned * shape.normals[i])}});
    }
    return vertices;
}

/// The triangles of a shape.
inline std::vector<glm::uvec3> triangles_of(const shapes::Shape& shape)
{
    std::vector<glm::uvec3> triangles;
    for (std::size_t i = 0; i < shape.indices.size(); i += 3)
        triangles.push_back({shape.indices[i], shape.indices[i + 1], shape.indices[i + 2]});
    return triangles;
}

/// Varied, the knot is turned and has another glaze.
inline Image knot(int width, int height, Variation vary = {})
{
    const glm::vec2 size(2 * width, 2 * height);
    const glm::vec3 eye(0, 0.25F, 4.55F);
    const glm::mat4 camera = glm::perspective(glm::radians(33.0F), size.x / size.y, 0.5F, 12.0F) *
                             glm::lookAt(eye, glm::vec3(0), glm::vec3(0, 1, 0));
    const std::array<Light, 3> lights = {{{{-3.0F, 4.0F, 3.5F, 1}, {2.30F, 2.00F, 1.60F}},
                                          {{4.0F, 1.0F, 2.5F, 1}, {0.30F, 0.42F, 0.70F}},
                                          {{1.0F, -3.0F, 1.5F, 1}, {0.10F, 0.05F, 0.16F}}}};
    const auto in_material = [&lights, eye](const Material& material) {
        return [&lights, material, eye](const SurfacePoint& at) {
            return blinn_phong_reflection(at, material, lights, glm::vec3(0.06F), eye);
        };
    };
    const Illumination glaze = in_material({{},
                                            {0.003F, 0.001F, 0.002F},
                                            glm::vec3(0.20F, 0.016F, 0.010F) + vary.near(glm::vec3(0), 0.01F),
                                            {0.80F, 0.66F, 0.52F},
                                            vary.scaled(70.0F, 2)});
    const shapes::Shape shape = shapes::trefoil(46, 9, 0.24F);
    const glm::mat4 model =
        glm::rotate(glm::scale(glm::mat4(1), glm::vec3(1.22F, 0.98F, 1)), vary.near(0.52F, 1.0F), glm::vec3(0, 0, 1));
    const std::vector<StagedVertex> vertices = staged(shape, model, camera, size);
    const std::vector<glm::uvec3> triangles = triangles_of(shape);

    Grid<glm::vec3> backdrop(2 * width, 2 * height);
    for (int y = 0; y < backdrop.height; ++y)
        for (int x = 0; x < backdrop.width; ++x) {
            const glm::vec2 at = (glm::vec2(x, y) + 0.5F) / size - glm::vec2(0.5F, 0.45F);
            backdrop.at(x, y) = glm::vec3(0.022F, 0.027F, 0.042F) * std::exp(-4 * dot(at, at));
        }
    using Draw =
        void (*)(std::span<const StagedVertex>, std::span<const glm::uvec3>, const Illumination&, pipeline::Layer&);
    Grid<glm::vec3> picture = backdrop;
    const std::array<Draw, 3> methods = {draw_flat, draw_gouraud, draw_phong};
    for (int i = 0; i < 3; ++i) {
        pipeline::Layer layer{backdrop, Grid<float>(2 * width, 2 * height, 1)};
        methods[static_cast<std::size_t>(i)](vertices, triangles, glaze, layer);
        if (layer.colors.cells.size() != picture.cells.size()) continue;
        for (int y = 0; y < picture.height; ++y)
            for (int x = i * picture.width / 3; x < (i + 1) * picture.width / 3; ++x)
                picture.at(x, y) = x < i * picture.width / 3 + 2 && i > 0 ? glm::vec3(0.35F) : layer.colors.at(x, y);
    }
    return halved(encoded(picture));
}

}
