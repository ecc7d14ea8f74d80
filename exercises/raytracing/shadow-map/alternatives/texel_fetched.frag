// alternative: reads a texel by its numbers, and takes the tangent from a cross product
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

float encoded(float x)
{
    x = clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}

float visibility(vec3 n, vec3 l, float far)
{
    float w = map_position.w;
    vec3 p = map_position.xyz;
    if (w <= 0.0 || p.x < -w || p.x > w || p.y < -w || p.y > w) return 1.0;
    ivec2 size = textureSize(distances, 0);
    ivec2 cell = min(ivec2(floor((p.xy / w + 1.0) * 0.5 * vec2(size))), size - 1);
    float near = texelFetch(distances, cell, 0).x;
    float across = w / (light_projection[0][0] * float(size.x));
    float up = w / (light_projection[1][1] * float(size.y));
    float slope = length(cross(n, l)) / dot(n, l);
    return near + 1.02 * sqrt(across * across + up * up) * slope + 0.001 < far ? 0.0 : 1.0;
}

void main()
{
    vec3 n = normalize(world_normal);
    vec3 l = light.xyz;
    float far = -dot(l, world_position);
    if (light.w != 0.0) {
        l = light.xyz - world_position;
        far = sqrt(dot(l, l));
        l /= far;
    }
    vec3 sum = ambient;
    if (dot(n, l) > 0.0) sum += visibility(n, l, far) * dot(n, l) * light_color;
    sum *= albedo;
    fragment_color = vec4(encoded(sum.r), encoded(sum.g), encoded(sum.b), 1.0);
}
