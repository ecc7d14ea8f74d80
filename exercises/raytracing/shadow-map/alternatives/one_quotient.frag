// alternative: the bias as an angle's tangent, the map's coordinates divided first, one product of all that arrives
// file: shadows.frag
#version 330

in vec3 world_position;
in vec3 world_normal;
in vec3 albedo;
in vec4 map_position;

uniform sampler2D distances;
uniform mat4 light_projection;
uniform vec4 light;
uniform vec3 light_color;
uniform vec3 ambient;

out vec4 fragment_color;

vec3 srgb_encoded(vec3 linear)
{
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

void main()
{
    vec3 towards = light.xyz - light.w * world_position;
    float mine = light.w > 0.5 ? length(towards) : -dot(towards, world_position);
    float angle = acos(clamp(dot(normalize(world_normal), normalize(towards)), -1.0, 1.0));
    vec3 ndc = map_position.xyz / map_position.w;
    float stored = texture(distances, ndc.xy * 0.5 + 0.5).r;
    vec2 half_texel = map_position.w / vec2(light_projection[0].x, light_projection[1].y);
    half_texel /= vec2(textureSize(distances, 0));
    float limit = stored + length(half_texel) * 1.02 * tan(angle) + 1e-3;
    bool unknown = map_position.w <= 0.0 || max(abs(ndc.x), abs(ndc.y)) > 1.0;
    float v = unknown || mine <= limit ? 1.0 : 0.0;
    vec3 radiance = albedo * (ambient + v * light_color * max(cos(angle), 0.0));
    fragment_color = vec4(srgb_encoded(radiance), 1.0);
}
