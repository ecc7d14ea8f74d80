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

/// Light that always arrives: where nothing stands in its way, or nobody asks.
inline constexpr auto always_seen = [](const Light&, const glm::vec3&) { return true; };

/// A colour of the material, times the texture's where it has one.
[[nodiscard]] inline glm::vec3 textured(const DrawList& list, const Draw& draw, const glm::vec2& uv,
                                        const glm::vec3& color)
{
    if (!draw.texture) return color;
    const Texture& texture = list.textures[*draw.texture];
    return color * glm::vec3(texturing::lookup(texture.texels, texture.sampler, uv * draw.material.texture_scale));
}

/// The local illumination model, exactly as lighting/shaders/phong.frag has it: emission, ambient, Lambert's diffuse
/// and Blinn's specular term; a texture multiplies ambient and diffuse. Linear colours. `v` is the unit vector towards
/// the viewer, given if something is specular. Without `with_ambient` no ambient light is added. `sees(light)`
/// says whether the light reaches the point; it is asked where the surface faces the light. Based on:
/// J. Blinn. Models of Light Reflection for Computer Synthesized Pictures. 1977.
template <EffectSet effects, class Sees>
[[nodiscard]] glm::vec3 shade_from(const DrawList& list, const Draw& draw, const SurfacePoint& at, const glm::vec3& v,
                                   bool with_ambient, Counters& counters, const Sees& sees)
{
    const scene::Material& material = draw.material;
    glm::vec3 ambient = with_ambient ? material.ambient : glm::vec3(0);
    glm::vec3 diffuse = material.diffuse;
    if (effects.textured && draw.texture) {
        ++counters.texture_lookups;
        const glm::vec3 texel = textured(list, draw, at.uv, glm::vec3(1));
        ambient *= texel;
        diffuse *= texel;
    }
    glm::vec3 n = at.normal;
    if (effects.smooth && draw.smooth) {
        ++counters.normals_interpolated;
        n = normalize(n);
    }
    const bool is_specular = effects.specular && draw.specular;

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
        if (cosine > 0 && sees(light)) {
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

/// The same as the camera sees it, without shadows.
template <EffectSet effects>
[[nodiscard]] glm::vec3 shade(const DrawList& list, const Draw& draw, const SurfacePoint& at, Counters& counters)
{
    const glm::vec3 v = effects.specular && draw.specular ? normalize(-at.eye) : glm::vec3(0);
    return shade_from<effects>(list, draw, at, v, true, counters, [](const Light&) { return true; });
}

}
