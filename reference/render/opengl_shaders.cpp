#include "render/opengl_shaders.hpp"

#include <algorithm>
#include <cctype>

namespace umbral::render {
namespace {

// Upside down: OpenGL's first row is then the top one, and a pixel whose centre lies on a horizontal edge belongs to
// the triangle below it, as rasterize_triangle has it. (Mesa gives it to the one above; glClipControl(GL_UPPER_LEFT)
// does not change that.) `precise`: the sums keep their order, which is place_vertex's, so positions are the same bit
// by bit.
constexpr const char* vertex_text = R"(
in vec3 position;
in vec3 normal;
uniform mat4 model_view;
uniform mat4 projection;
uniform mat3 normal_matrix;

out vec3 eye_position;
#ifdef SMOOTH
out vec3 eye_normal;
#endif
flat out vec3 flat_normal;
#ifdef TEXTURED
in vec2 uv;
out vec2 texture_place;
#endif

void main()
{
    precise vec3 eye = (model_view[0] * position.x + model_view[1] * position.y + model_view[2] * position.z +
                        model_view[3]).xyz;
    precise vec4 clip = projection[0] * eye.x + projection[1] * eye.y + projection[2] * eye.z + projection[3];
    gl_Position = vec4(clip.x, -clip.y, clip.zw);
    eye_position = eye;
    flat_normal = normalize(normal_matrix * normal);
#ifdef SMOOTH
    eye_normal = flat_normal;
#endif
#ifdef TEXTURED
    texture_place = uv;
#endif
}
)";

// The model of lighting/shaders/phong.frag; shading.hpp has the same in C++.
constexpr const char* fragment_text = R"(
in vec3 eye_position;
#ifdef SMOOTH
in vec3 eye_normal;
uniform bool is_smooth;
#endif
flat in vec3 flat_normal;
#ifdef TEXTURED
in vec2 texture_place;
uniform bool is_textured;
uniform vec2 texture_scale;
uniform sampler2D image;
#endif
#if LIGHTS > 0
uniform vec4 light_where[LIGHTS];
uniform vec3 light_color[LIGHTS];
#endif
uniform vec3 global_ambient;
uniform vec3 emission;
uniform vec3 material_ambient;
uniform vec3 material_diffuse;
#ifdef SPECULAR
uniform vec3 specular;
uniform float exponent;
#endif
uniform int id;

layout(location = 0) out vec4 fragment_color;
layout(location = 1) out uint fragment_id;

#ifdef SPECULAR
float highlight(float cosine) { return exponent == 0.0 ? 1.0 : pow(max(0.0, cosine), exponent); }
#endif

void main()
{
    vec3 ambient = material_ambient;
    vec3 diffuse = material_diffuse;
#ifdef TEXTURED
    if (is_textured) {
        vec3 texel = textureLod(image, texture_place * texture_scale, 0.0).rgb;
        ambient *= texel;
        diffuse *= texel;
    }
#endif
    vec3 n = flat_normal;
#ifdef SMOOTH
    if (is_smooth) n = normalize(eye_normal);
#endif
#ifdef TWO_SIDED
    if (!gl_FrontFacing) n = -n;
#endif
    vec3 color = emission + global_ambient * ambient;
#if LIGHTS > 0
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 l = light_where[i].xyz;
#ifdef POSITIONAL
        if (light_where[i].w != 0.0) l = normalize(l - eye_position);
#endif
        vec3 reflected = ambient;
        float cosine = dot(n, l);
        if (cosine > 0.0) {
            reflected += diffuse * cosine;
#ifdef SPECULAR
            vec3 halfway = l + normalize(-eye_position);
            float size = length(halfway);
            if (size > 0.0) reflected += specular * highlight(dot(n, halfway) / size);
#endif
        }
        color += light_color[i] * reflected;
    }
#endif
    fragment_color = vec4(color, 1.0);
    fragment_id = uint(id);
}
)";

}

ShaderTexts shaders_for(const EffectSet& effects, std::size_t lights)
{
    std::string head = "#version 430\n#define LIGHTS " + std::to_string(lights) + "\n";
    for (std::size_t i = 0; i < effect_flags.size(); ++i) {
        if (!(effects.*effect_flags[i])) continue;
        std::string name = effect_names[i];
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
        head += "#define " + name + "\n";
    }
    return {head + vertex_text, head + fragment_text};
}

}
