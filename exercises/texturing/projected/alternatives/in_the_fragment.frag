// alternative: projects again in the fragment shader, from the world position
#version 330

uniform mat4 projector_view;
uniform mat4 projector_projection;

in vec3 world_position;
in vec3 world_normal;
in vec3 albedo;

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

void main()
{
    vec4 clip = projector_projection * projector_view * vec4(world_position, 1.0);
    vec3 light = ambient;
    if (clip.w > 0.0) {
        vec2 place = clip.xy / clip.w;
        if (abs(place.x) <= 1.0 && abs(place.y) <= 1.0) {
            vec3 picture = texture(slide, (place + 1.0) / 2.0).rgb;
            vec3 towards = normalize(projector_position - world_position);
            light += picture * lamp_color * clamp(dot(normalize(world_normal), towards), 0.0, 1.0);
        }
    }
    fragment_color = vec4(srgb_encoded(light * albedo), 1.0);
}
