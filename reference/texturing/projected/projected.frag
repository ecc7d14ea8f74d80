#version 330

in vec3 world_position;
in vec3 world_normal;
in vec3 albedo;
in vec4 slide_position;

uniform sampler2D slide;
uniform vec3 projector_position;
uniform vec3 lamp_color;
uniform vec3 ambient;

out vec4 fragment_color;

vec3 srgb_encoded(vec3 linear)
{
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

// Behind the projector w is negative, and no number is at least as large as x and as -x; on its plane w is 0.
bool in_beam() { return slide_position.w > 0.0 && all(lessThanEqual(abs(slide_position.xy), vec2(slide_position.w))); }

vec3 light_of_projector()
{
    vec3 l = normalize(projector_position - world_position);
    float cosine = max(0.0, dot(normalize(world_normal), l));
    // Divided here and not at the vertices: quotients of linear functions are not linear.
    vec2 st = 0.5 * slide_position.xy / slide_position.w + 0.5;
    return cosine * lamp_color * textureLod(slide, st, 0.0).rgb;
}

void main()
{
    vec3 light = ambient;
    if (in_beam()) light += light_of_projector();
    fragment_color = vec4(srgb_encoded(albedo * light), 1.0);
}
