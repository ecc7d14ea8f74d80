#pragma once

#include <utility>

#include "model.hpp"
#include "scenes.hpp"

/// What builders of scenes share.
namespace umbral::bench::scenes {

[[nodiscard]] inline Material glossy(const glm::vec3& color, float shine = 0.5F, float shininess = 32)
{
    Material m;
    m.color = glm::vec4(color, 1);
    m.specular = glm::vec3(shine);
    m.shininess = shininess;
    return m;
}

/// Not lit.
[[nodiscard]] inline Material plain_paint(const glm::vec4& color = glm::vec4(1))
{
    Material m;
    m.color = color;
    m.style = Style::plain;
    return m;
}

[[nodiscard]] inline Light sun(const glm::vec3& towards, const glm::vec3& color)
{
    Light light;
    light.place = {towards, 0};
    light.color = color;
    return light;
}

[[nodiscard]] inline Light lamp(const glm::vec3& at, const glm::vec3& color)
{
    Light light;
    light.place = {at, 1};
    light.color = color;
    return light;
}

/// A square picture seen from `eye`.
[[nodiscard]] inline Model framed(const Pose& pose, const glm::vec3& eye, const glm::vec3& target = glm::vec3(0))
{
    Model m;
    m.width = m.height = pose.size;
    m.camera.eye = eye;
    m.camera.target = target;
    return m;
}

/// A picture of the plane z = 0, `height` units high, seen straight on; y up, the origin in the middle.
[[nodiscard]] inline Model flat_picture(int width, int height, float units)
{
    Model m;
    m.width = width;
    m.height = height;
    m.camera.ortho_height = units;
    m.encoded = false;
    return m;
}

/// A mesh whose back is not drawn.
[[nodiscard]] inline Batch solid(Triangles mesh, const glm::mat4& placed, const Material& material)
{
    Batch batch;
    batch.corners = std::move(mesh);
    batch.model = placed;
    batch.material = material;
    batch.cull = Cull::back;
    return batch;
}

/// A mesh seen from both sides that lets through what is behind it, and hides nothing.
[[nodiscard]] inline Batch layer(Triangles mesh, const glm::mat4& placed, const Material& material,
                                 Blend blend = Blend::over)
{
    Batch batch = solid(std::move(mesh), placed, material);
    batch.cull = Cull::none;
    batch.blend = blend;
    batch.depth_write = false;
    return batch;
}

/// A mesh with the texture at this place of Model::textures.
[[nodiscard]] inline Batch with_texture(Batch batch, std::size_t texture, const glm::vec2& scale = glm::vec2(1))
{
    batch.texture = texture;
    batch.material.uv_scale = scale;
    return batch;
}

}
