#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "render/counters.hpp"
#include "render/draw_list.hpp"
#include "render/effects.hpp"

namespace umbral::render {

/// Where a fragment lies on a surface, in eye space.
struct SurfacePoint {
    glm::vec3 eye{0};     ///< given if a light has a place or something is specular
    glm::vec3 normal{0};  ///< towards the viewer's side; unit if the surface is flat
    glm::vec2 uv{0};      ///< given if something is textured
};

/// cosine^exponent, with x^0 = 1 for every x.
[[nodiscard]] inline float highlight(float cosine, float exponent)
{
    return exponent == 0 ? 1 : std::pow(std::max(0.0F, cosine), exponent);
}

/// The local illumination model, exactly as lighting/shaders/phong.frag has it: emission, ambient, Lambert's diffuse
/// and Blinn's specular term; a texture multiplies ambient and diffuse. Linear colours. Based on: J. Blinn. Models of
/// Light Reflection for Computer Synthesized Pictures. 1977.
template <EffectSet effects>
[[nodiscard]] glm::vec3 shade(const DrawList& list, const Draw& draw, const SurfacePoint& at, Counters& counters)
{
    const scene::Material& material = draw.material;
    glm::vec3 ambient = material.ambient;
    glm::vec3 diffuse = material.diffuse;
    if (effects.textured && draw.texture) {
        const Texture& texture = list.textures[*draw.texture];
        ++counters.texture_lookups;
        const glm::vec3 texel(texturing::lookup(texture.texels, texture.sampler, at.uv * material.texture_scale));
        ambient *= texel;
        diffuse *= texel;
    }
    glm::vec3 n = at.normal;
    if (effects.smooth && draw.smooth) {
        ++counters.normals_interpolated;
        n = normalize(n);
    }
    const bool is_specular = effects.specular && draw.specular;
    const glm::vec3 v = is_specular ? normalize(-at.eye) : glm::vec3(0);

    glm::vec3 color = material.emission + list.ambient * ambient;
    for (const Light& light : list.lights) {
        ++counters.light_evaluations;
        glm::vec3 l(light.where);
        if (effects.positional && light.where.w != 0) {
            ++counters.light_directions;
            l = normalize(l - at.eye);
        }
        glm::vec3 reflected = ambient;
        const float cosine = dot(n, l);
        if (cosine > 0) {
            reflected += diffuse * cosine;
            if (is_specular) {
                ++counters.specular_evaluations;
                // With the light exactly opposite to the viewer there is no vector halfway between.
                const glm::vec3 halfway = l + v;
                const float size = length(halfway);
                if (size > 0) reflected += material.specular * highlight(dot(n, halfway) / size, material.exponent);
            }
        }
        color += light.color * reflected;
    }
    return color;
}

}
