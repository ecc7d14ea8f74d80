#pragma once

#include <kit/picture.hpp>
#include <kit/shapes.hpp>

#include "scenes.hpp"

/// The goal picture: a camera that stands in a hilly country under a knot. The land begins behind it, so that it must
/// be clipped; the right third of the knot is a net, and a small viewport shows it in points.
namespace umbral::pipeline {

struct Model {
    std::vector<ColoredVertex> vertices;
    std::vector<glm::uvec3> triangles;
};

/// A shape in the colours that `color(vertex, number)` gives.
template <class Color>
Model colored(const shapes::Shape& shape, const Color& color)
{
    Model model;
    for (std::size_t i = 0; i < shape.positions.size(); ++i)
        model.vertices.push_back({shape.positions[i], color(shapes::Vertex{shape.positions[i], shape.normals[i]}, i)});
    for (std::size_t i = 0; i < shape.indices.size(); i += 3)
        model.triangles.emplace_back(shape.indices[i], shape.indices[i + 1], shape.indices[i + 2]);
    return model;
}

inline glm::vec3 sky(float up)
{
    return glm::mix(glm::vec3(0.78F, 0.55F, 0.40F), glm::vec3(0.05F, 0.09F, 0.24F), glm::smoothstep(0.0F, 0.75F, up));
}

inline Model country()
{
    const auto height = [](float x, float z) {
        const float valley = std::min(1.0F, 0.09F * x * x);
        return -1.35F + valley * (0.75F + 0.5F * std::sin(1.7F * x + 0.4F * z) * std::cos(1.1F * z)) +
               0.1F * std::sin(2.3F * z + 1.4F * x);
    };
    const shapes::Shape ground = shapes::surface(70, 90, [&](float u, float v) {
        const float x = -11 + 22 * u;
        const float z = 3 - 21 * v;
        return glm::vec3(x, height(x, z), z);
    });
    return colored(ground, [](const shapes::Vertex& vertex, std::size_t) {
        const auto& [place, normal] = vertex;
        const float light = std::max(0.0F, dot(normal, normalize(glm::vec3(-0.6F, 0.45F, 0.5F))));
        const glm::vec3 soil = glm::mix(glm::vec3(0.05F, 0.16F, 0.07F), glm::vec3(0.42F, 0.24F, 0.13F),
                                        glm::smoothstep(-1.25F, -0.1F, place.y));
        return glm::mix(soil * (0.15F + 1.3F * light), sky(0.05F), 1 - std::exp(0.035F * std::min(place.z, 0.0F)));
    });
}

inline Model knot()
{
    constexpr std::size_t along = 96;
    shapes::Shape tube = shapes::trefoil(along, 12, 0.2F);
    for (glm::vec3& position : tube.positions) position = 1.45F * position + glm::vec3(0, 0.52F, -5);
    return colored(tube, [](const shapes::Vertex& vertex, std::size_t i) {
        const float light = std::max(0.0F, dot(vertex.normal, normalize(glm::vec3(-0.6F, 0.5F, 0.6F))));
        const float u = static_cast<float>(i % (along + 1)) / along;
        const glm::vec3 hue = 0.5F + 0.5F * cos(shapes::turn * u + glm::vec3(0.2F, 2.4F, 4.2F));
        return (hue * hue + 0.04F) * (0.2F + 0.8F * light) + 0.3F * std::pow(light, 24.0F);
    });
}

inline Layer scenery(Recorder& out, int width, int height)
{
    Layer layer{Grid<glm::vec3>(width, height), Grid<float>(width, height, 1)};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            layer.colors.at(x, y) = sky(1 - static_cast<float>(y) / (0.62F * static_cast<float>(height)));
    const Model land = country();
    const Model tube = knot();

    PipelineState state;
    state.viewport = {0, 0, width, height, 0, 1};
    state.to_clip = perspective(1.9F, static_cast<float>(width) / static_cast<float>(height));
    ask<draw_triangles>(out, state, land.vertices, land.triangles, layer);

    // Solid to the left of a plane, a net to the right of it.
    std::vector<glm::uvec3> solid;
    std::vector<glm::uvec3> net;
    for (const glm::uvec3& triangle : tube.triangles)
        (tube.vertices[triangle.x].position.x < 0.3F ? solid : net).push_back(triangle);
    state.culling = Culling::back;
    ask<draw_triangles>(out, state, tube.vertices, solid, layer);
    state.mode = PolygonMode::line;
    ask<draw_triangles>(out, state, tube.vertices, net, layer);

    // Points, from the side, in a viewport of their own, in front of all.
    state.mode = PolygonMode::point;
    state.culling = Culling::none;
    state.viewport = {width - width / 4 - 10, 10, width / 4, width / 4, 0, 0.1F};
    state.to_clip = perspective(2.4F, 1);
    state.to_clip[3] = state.to_clip * glm::vec4(0, -0.52F, 0, 1);
    ask<draw_triangles>(out, state, tube.vertices, tube.triangles, layer);
    return layer;
}

}
