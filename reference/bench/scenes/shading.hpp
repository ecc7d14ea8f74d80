#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "model.hpp"
#include "operators.hpp"

namespace umbral::bench::scenes {

// The functions that shading.glsl calls by GLSL's names.
using glm::abs, glm::clamp, glm::dot, glm::exp, glm::exp2, glm::floor, glm::fract, glm::length, glm::log2, glm::max,
    glm::min, glm::mix, glm::normalize, glm::pow, glm::reflect, glm::smoothstep, glm::sqrt, glm::transpose;

/// Vertex stage and fragment stage, in float or double; the members are the uniforms.
template <class Number>
struct Shading {
    using Real = Number;
    using vec2 = glm::vec<2, Real>;
    using vec3 = glm::vec<3, Real>;
    using vec4 = glm::vec<4, Real>;
    using mat3 = glm::mat<3, 3, Real>;
    using mat4 = glm::mat<4, 4, Real>;
    using Choice = Flaw;
    using Manner = Way;
    using enum Flaw;
    using enum Way;

    const Texture* image = nullptr;
    const std::vector<Grid<glm::vec4>>* levels = nullptr;

    vec4 lookup(vec2 uv, Real lod) const;

// The one word of GLSL that C++ lacks.
#define uniform
#include "shading.glsl"
#undef uniform
};

/// Sets what one batch of a model needs; lights and matrices are computed in Number.
template <class Number>
void prepare(Shading<Number>& s, const Model& m, const Batch& batch, Flaw flaw, Way way)
{
    using S = Shading<Number>;
    using vec3 = typename S::vec3;
    using vec4 = typename S::vec4;
    using mat3 = typename S::mat3;
    using mat4 = typename S::mat4;
    s.flaw = flaw;
    s.way = way;
    const Camera& camera = m.camera;
    s.model = mat4(batch.model);
    s.view = glm::lookAt(vec3(camera.eye), vec3(camera.target), vec3(camera.up));
    const Number aspect = camera.takes_square ? Number(1) : Number(m.width) / Number(m.height);
    const Number near = camera.near;
    const Number far = camera.far;
    const Number half = Number(camera.ortho_height) / 2;
    s.projection = half > 0 ? glm::ortho(-half * aspect, half * aspect, -half, half, near, far)
                            : glm::perspective(glm::radians(Number(camera.fovy_degrees)), aspect, near, far);
    s.all_matrices = s.projection * s.view * s.model;
    const bool world = way == Way::light_in_world_space;
    s.lit_in = world ? s.model : s.view * s.model;
    const mat3 straight(s.lit_in);
    const mat3 inverse = glm::inverse(straight);
    s.normal_matrix = flaw == Flaw::normals_by_model           ? straight
                      : flaw == Flaw::normal_matrix_transposed ? inverse
                                                               : glm::transpose(inverse);
    const mat4 to_light_space = world || flaw == Flaw::light_in_wrong_space ? mat4(1) : s.view;
    s.to_world = world ? mat3(1) : glm::transpose(mat3(s.view));
    const vec4 seen_from = half > 0 ? vec4(0, 0, 1, 0) : vec4(0, 0, 0, 1);
    s.viewer = world ? glm::inverse(s.view) * seen_from : seen_from;
    s.moved = typename S::vec2(m.moved) * typename S::vec2(2, -2) / typename S::vec2(m.width, m.height);
    s.depth_offset = Number(batch.depth_offset);
    s.ambient = vec3(m.ambient);
    s.paint = vec4(batch.material.color);
    s.specular = vec3(batch.material.specular);
    s.shininess = Number(batch.material.shininess);
    s.style = static_cast<int>(batch.material.style);
    s.bands = Number(batch.material.bands);
    s.uv_scale = typename S::vec2(batch.material.uv_scale);
    s.textured = batch.texture ? 1 : 0;
    s.alpha_test = batch.material.alpha_test ? 1 : 0;
    s.encoded = m.encoded ? 1 : 0;
    s.fog_color = vec3(m.fog.color);
    s.fog_density = Number(m.fog.density);
    s.texel = typename S::vec2(0);
    s.image = batch.texture ? &m.textures.at(*batch.texture) : nullptr;
    if (s.image != nullptr) s.texel = Number(1) / typename S::vec2(s.image->texels.width, s.image->texels.height);
    s.lamp_count = static_cast<int>(m.lights.size());
    for (std::size_t i = 0; i < m.lights.size(); ++i) {
        const Light& light = m.lights[i];
        vec4 place = to_light_space * vec4(light.place);
        if (place.w == 0) place = vec4(glm::normalize(vec3(place)), 0);
        s.lamps[i] = {place,
                      vec3(light.color),
                      vec3(light.falloff),
                      glm::normalize(mat3(to_light_space) * vec3(light.aim)),
                      Number(light.cone),
                      Number(light.focus)};
    }
}

}
