// Based on: J. C. Hart. Sphere Tracing: A Geometric Method for the Antialiased Ray Tracing of Implicit Surfaces. The
// Visual Computer, 1996. The sponge: K. Menger, 1926.
#version 330

in vec2 place;

uniform vec3 eye;
uniform mat3 camera;
uniform float half_height;

uniform int depth;
uniform vec4 ball;

uniform vec3 sponge_color;
uniform vec3 ball_color;
uniform vec3 sun;
uniform vec3 sun_color;
uniform vec3 ambient;
uniform vec3 horizon;
uniform vec3 zenith;

out vec4 fragment_color;

vec3 srgb_encoded(vec3 linear)
{
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

const float touching = 0.00005;
const float far = 30.0; // nothing is farther than this
const int most_steps = 300;

float cube(vec3 p)
{
    vec3 q = abs(p) - 1.0;
    return length(max(q, 0.0)) + min(0.0, max(q.x, max(q.y, q.z)));
}

// The cube from which, in each of its cells of a third, three bars through the middle are taken: not more than the
// distance to the surface, so that no step leads through it.
float sponge(vec3 p)
{
    float d = cube(p);
    float cell = 2.0;
    for (int i = 0; i < depth; ++i) {
        // The place in the cell, from its middle, in thirds of the cell.
        vec3 q = 3.0 * abs(mod(p + 1.0, cell) / cell - 0.5);
        float bars = min(max(q.x, q.y), min(max(q.y, q.z), max(q.z, q.x))) - 0.5;
        d = max(d, -bars * cell / 3.0);
        cell /= 3.0;
    }
    return d;
}

float hollow(vec3 p) { return ball.w - length(p - ball.xyz); }

float scene(vec3 p) { return max(sponge(p), hollow(p)); }

// How far along the unit vector u the surface is; `far` if it is nowhere.
float march(vec3 o, vec3 u)
{
    // Nothing is outside the cube: begin a little before it.
    float t = max(0.0, length(o) - 2.0);
    for (int i = 0; i < most_steps && t < far; ++i) {
        float d = scene(o + t * u);
        if (abs(d) <= touching) return t;
        t += d;
    }
    return far;
}

vec3 normal_at(vec3 p)
{
    const vec2 h = vec2(0.0001, 0.0);
    return normalize(vec3(scene(p + h.xyy) - scene(p - h.xyy), scene(p + h.yxy) - scene(p - h.yxy),
                          scene(p + h.yyx) - scene(p - h.yyx)));
}

void main()
{
    vec3 u = normalize(camera * vec3(half_height * place, -1.0));
    float t = march(eye, u);
    vec3 light = mix(horizon, zenith, max(0.0, u.y));
    if (t < far) {
        vec3 p = eye + t * u;
        vec3 n = normal_at(p);
        float cosine = dot(n, sun);
        light = ambient;
        if (cosine > 0.0 && march(p + 0.002 * n, sun) == far) light += cosine * sun_color;
        light *= hollow(p) > sponge(p) ? ball_color : sponge_color;
    }
    fragment_color = vec4(srgb_encoded(light), 1.0);
}
