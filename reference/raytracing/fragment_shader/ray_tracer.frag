// Based on: T. Whitted. An Improved Illumination Model for Shaded Display. CACM, 1980: mirrors only. There is no
// recursion in GLSL: each step adds its light times what all mirrors before it have left.
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

vec3 srgb_encoded(vec3 linear)
{
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

const float closest = 0.001; // what is nearer is where the ray begins
const float nowhere = 1e30;

struct Surface {
    float t;
    vec3 normal;
    vec3 color;
    float mirror;
};

// The nearer root: no ray begins inside a sphere. The one of the form c / q, that does not subtract numbers alike.
float distance_to_sphere(vec3 o, vec3 u, vec4 sphere)
{
    vec3 off = o - sphere.xyz;
    float b = dot(off, u);
    vec3 beside = off - b * u;
    float left = sphere.w * sphere.w - dot(beside, beside);
    if (left < 0.0 || b > 0.0) return nowhere;
    float q = -b + sqrt(left);
    float t = (dot(off, off) - sphere.w * sphere.w) / q;
    return t > closest ? t : nowhere;
}

float distance_to_floor(vec3 o, vec3 u)
{
    float t = -o.y / u.y;
    return u.y != 0.0 && t > closest && length(o.xz + t * u.xz) < floor_radius ? t : nowhere;
}

Surface first_surface(vec3 o, vec3 u)
{
    Surface nearest = Surface(nowhere, vec3(0.0), vec3(0.0), 0.0);
    float to_floor = distance_to_floor(o, u);
    if (to_floor < nowhere) {
        vec2 tile = floor(o.xz + to_floor * u.xz);
        nearest = Surface(to_floor, vec3(0.0, 1.0, 0.0), tiles[int(mod(tile.x + tile.y, 2.0))], floor_mirror);
    }
    for (int i = 0; i < sphere_count; ++i) {
        float t = distance_to_sphere(o, u, spheres[i]);
        if (t < nearest.t)
            nearest = Surface(t, (o + t * u - spheres[i].xyz) / spheres[i].w, sphere_colors[i], mirrors[i]);
    }
    return nearest;
}

bool lit(vec3 p, vec3 l, float distance_of_light)
{
    if (distance_to_floor(p, l) < distance_of_light) return false;
    for (int i = 0; i < sphere_count; ++i)
        if (distance_to_sphere(p, l, spheres[i]) < distance_of_light) return false;
    return true;
}

vec3 local_light(vec3 p, Surface surface)
{
    vec3 to_light = light_position - p;
    vec3 l = normalize(to_light);
    float cosine = dot(surface.normal, l);
    vec3 arriving = ambient;
    if (cosine > 0.0 && lit(p, l, length(to_light))) arriving += cosine * light_color;
    return surface.color * arriving;
}

vec3 radiance(vec3 o, vec3 u)
{
    vec3 sum = vec3(0.0);
    float left = 1.0;
    for (int level = 1; level <= levels && left > 0.0; ++level) {
        Surface surface = first_surface(o, u);
        if (surface.t == nowhere) return sum + left * mix(horizon, zenith, max(0.0, u.y));
        o += surface.t * u;
        sum += left * local_light(o, surface);
        left *= surface.mirror;
        u = normalize(reflect(u, surface.normal));
    }
    return sum;
}

void main()
{
    vec3 u = normalize(camera * vec3(half_height * place, -1.0));
    fragment_color = vec4(srgb_encoded(radiance(eye, u)), 1.0);
}
