// Based on: L. Williams. Casting Curved Shadows on Curved Surfaces. SIGGRAPH 1978: the second pass.
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

// How much nearer the map may say that a plane is: at the centre of its texel, at most half a diagonal away across the
// light, the plane is nearer by at most that times the tangent of its angle. w scales the texel with the distance along
// the axis; in a parallel projection it is 1.
float bias(float cosine)
{
    vec2 scale = vec2(light_projection[0][0], light_projection[1][1]) * vec2(textureSize(distances, 0));
    float half_diagonal = map_position.w * length(1.0 / scale);
    float tangent = sqrt(1.0 - min(1.0, cosine * cosine)) / cosine;
    return 1.02 * half_diagonal * tangent + 0.001;
}

// Whether the light sees the point. Where the map has nothing to say, it does.
bool visible(float distance_here, float cosine)
{
    bool on_map = map_position.w > 0.0 && all(lessThanEqual(abs(map_position.xy), vec2(map_position.w)));
    if (!on_map) return true;
    vec2 st = 0.5 * map_position.xy / map_position.w + 0.5;
    return distance_here - textureLod(distances, st, 0.0).r <= bias(cosine);
}

void main()
{
    bool directional = light.w == 0.0;
    vec3 to_light = directional ? light.xyz : light.xyz - world_position;
    float distance_here = directional ? -dot(light.xyz, world_position) : length(to_light);
    float cosine = dot(normalize(world_normal), normalize(to_light));
    vec3 arriving = ambient;
    if (cosine > 0.0 && visible(distance_here, cosine)) arriving += cosine * light_color;
    fragment_color = vec4(srgb_encoded(albedo * arriving), 1.0);
}
