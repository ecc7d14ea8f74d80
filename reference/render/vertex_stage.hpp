#pragma once

#include <array>
#include <glm/glm.hpp>
#include <umbral/pipeline/rasterize.hpp>

#include "render/clip.hpp"
#include "render/draw_list.hpp"

namespace umbral::render {

/// m · (p, 1), its terms added from the left: the order that opengl_shaders.cpp prescribes too, so that both round
/// alike.
[[nodiscard]] inline glm::vec4 transform(const glm::mat4& m, const glm::vec3& p)
{
    return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
}

/// The vertex stage: positions to eye space and clip space, normals to eye space.
[[nodiscard]] inline ClipVertex place_vertex(const DrawList& list, const Draw& draw, const Vertex& vertex)
{
    const glm::vec3 eye(transform(draw.model_view, vertex.position));
    const glm::vec3& n = vertex.normal;
    const glm::vec3 normal = draw.normal_matrix[0] * n.x + draw.normal_matrix[1] * n.y + draw.normal_matrix[2] * n.z;
    return {transform(list.projection, eye), eye, normalize(normal), vertex.uv};
}

/// Division by w and viewport transform, as OpenGL's, but y goes down.
[[nodiscard]] inline pipeline::WindowVertex to_window(const glm::vec4& clip, int width, int height)
{
    const float inverse_w = 1 / clip.w;
    const glm::vec2 half = glm::vec2(width, height) * 0.5F;
    return {{clip.x * inverse_w * half.x + half.x, clip.y * inverse_w * -half.y + half.y},
            clip.z * inverse_w * 0.5F + 0.5F,
            inverse_w};
}

/// Is it seen from its front: are its corners counter-clockwise (clockwise if mirrored)? y goes down.
[[nodiscard]] inline bool is_front(const std::array<pipeline::WindowVertex, 3>& corners, bool mirrored)
{
    const glm::dvec2 a(corners[0].position);
    const glm::dvec2 b = glm::dvec2(corners[1].position) - a;
    const glm::dvec2 c = glm::dvec2(corners[2].position) - a;
    const double area = b.x * c.y - b.y * c.x;
    return mirrored ? area > 0 : area < 0;
}

}
