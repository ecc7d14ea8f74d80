// alternative: the school's quadratic equation, things by number, loops over all eight spheres
// file: ray_tracer.frag
#version 330

in vec2 place;

uniform vec3 eye;
uniform mat3 camera;
uniform float half_height;
uniform int sphere_count;
uniform vec4 spheres[8];
uniform vec3 sphere_colors[8];
uniform float mirrors[8];
uniform vec3 tiles[2];
uniform float floor_mirror;
uniform float floor_radius;
uniform vec3 light_position;
uniform vec3 light_color;
uniform vec3 ambient;
uniform vec3 horizon;
uniform vec3 zenith;
uniform int levels;

out vec4 fragment_color;

float encoded(float x)
{
    x = clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}

// The number of what the ray meets first between 0.0005 and t, -1 the floor, -2 nothing; t becomes its distance.
int meet(vec3 o, vec3 d, inout float t)
{
    int found = -2;
    if (abs(d.y) > 1e-12) {
        float s = -o.y / d.y;
        vec3 p = o + s * d;
        if (s > 0.0005 && s < t && dot(p.xz, p.xz) < floor_radius * floor_radius) {
            t = s;
            found = -1;
        }
    }
    for (int i = 0; i < 8; ++i) {
        if (i >= sphere_count) break;
        vec3 off = o - spheres[i].xyz;
        float a = dot(d, d);
        float b = 2.0 * dot(off, d);
        float c = dot(off, off) - spheres[i].w * spheres[i].w;
        float discriminant = b * b - 4.0 * a * c;
        if (discriminant < 0.0) continue;
        float s = (-b - sqrt(discriminant)) / (2.0 * a);
        if (s > 0.0005 && s < t) {
            t = s;
            found = i;
        }
    }
    return found;
}

void main()
{
    vec3 o = eye;
    vec3 d = normalize(half_height * place.x * camera[0] + half_height * place.y * camera[1] - camera[2]);
    vec3 sum = vec3(0.0);
    float weight = 1.0;
    for (int level = 0; level < 6; ++level) {
        if (level == levels) break;
        float t = 1e20;
        int what = meet(o, d, t);
        if (what == -2) {
            float rise = clamp(d.y, 0.0, 1.0);
            sum += weight * ((1.0 - rise) * horizon + rise * zenith);
            break;
        }
        vec3 p = o + t * d;
        vec3 n = vec3(0.0, 1.0, 0.0);
        vec3 albedo;
        float mirrored = floor_mirror;
        if (what == -1) {
            int parity = int(floor(p.x)) + int(floor(p.z));
            albedo = (parity & 1) == 0 ? tiles[0] : tiles[1];
        } else {
            n = normalize(p - spheres[what].xyz);
            albedo = sphere_colors[what];
            mirrored = mirrors[what];
        }
        vec3 l = light_position - p;
        float whole = 1.0;
        float seen = meet(p, l, whole) == -2 ? 1.0 : 0.0;
        sum += weight * albedo * (ambient + seen * light_color * max(0.0, dot(n, l) / length(l)));
        weight *= mirrored;
        o = p + 0.0005 * n;
        d -= 2.0 * dot(d, n) * n;
    }
    fragment_color = vec4(encoded(sum.r), encoded(sum.g), encoded(sum.b), 1.0);
}
