#pragma once

#include <string>
#include <umbral/gl/program.hpp>

/// How goal pictures drawn by OpenGL are lit: pieces of GLSL, one of each.
namespace umbral {

/// srgb_encoded and srgb_decoded as in color.hpp; lit(), the light that a surface sends to the eye.
inline constexpr const char* shading_glsl = R"(
vec3 srgb_encoded(vec3 linear)
{
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

vec3 srgb_decoded(vec3 encoded)
{
    return mix(pow((encoded + 0.055) / 1.055, vec3(2.4)), encoded / 12.92, lessThanEqual(encoded, vec3(0.04045)));
}

// A warm key light, a cool sky over a warm ground; with gloss, a highlight and a rim that mirrors the sky. Vectors
// are unit, away from the surface; n may be zero. `key` is how much of the key light arrives, 0 in the shadow.
vec3 lit(vec3 albedo, float gloss, vec3 n, vec3 to_eye, vec3 to_key, float key)
{
    vec3 light = mix(vec3(0.16, 0.13, 0.10), vec3(0.30, 0.36, 0.46), 0.5 + 0.5 * n.y);
    light += key * vec3(0.98, 0.90, 0.78) * max(dot(n, to_key), 0.0);
    vec3 color = albedo * light;
    if (gloss > 0.0 && dot(n, n) > 0.0) {
        color += gloss * key * vec3(1.0, 0.95, 0.85) * pow(max(dot(n, normalize(to_key + to_eye)), 0.0), 60.0);
        color += 0.5 * gloss * vec3(0.30, 0.36, 0.46) * pow(1.0 - max(dot(n, to_eye), 0.0), 4.0);
    }
    return color;
}
)";

/// A fragment shader that may call these; `text` comes without its #version.
inline gl::ShaderSource lit_fragment_shader(const std::string& name, const std::string& text)
{
    std::string whole = "#version 330 core\n";
    return {name, whole.append(shading_glsl).append(text)};
}

}
