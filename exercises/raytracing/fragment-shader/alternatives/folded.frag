// alternative: the sponge by folding thirds, the normal from the corners of a tetrahedron, a shadow march of its own
// file: distance_field.frag
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

float encoded(float x)
{
    x = clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}

// Distances to sponge and hollow.
vec2 parts(vec3 p)
{
    vec3 q = abs(p) - vec3(1.0);
    float d = max(q.x, max(q.y, q.z));
    float scale = 1.0;
    for (int i = 0; i < 4; ++i) {
        if (i == depth) break;
        vec3 a = mod(p * scale, 2.0) - 1.0;
        scale *= 3.0;
        vec3 r = abs(1.0 - 3.0 * abs(a));
        float c = (min(max(r.x, r.y), min(max(r.y, r.z), max(r.z, r.x))) - 1.0) / scale;
        d = max(d, c);
    }
    return vec2(d, ball.w - distance(p, ball.xyz));
}

float field(vec3 p)
{
    vec2 d = parts(p);
    return max(d.x, d.y);
}

vec3 slope(vec3 p)
{
    const float e = 0.0001;
    const vec3 a = vec3(1, -1, -1), b = vec3(-1, -1, 1), c = vec3(-1, 1, -1), d = vec3(1, 1, 1);
    return normalize(a * field(p + e * a) + b * field(p + e * b) + c * field(p + e * c) + d * field(p + e * d));
}

float sunlit(vec3 p)
{
    for (float t = 0.0; t < 4.0;) {
        float step = field(p + t * sun);
        if (step < 0.00005) return 0.0;
        t += step;
    }
    return 1.0;
}

void main()
{
    vec3 d = normalize(camera * vec3(place * half_height, -1.0));
    vec3 p = eye;
    bool hit = false;
    for (int i = 0; i < 500; ++i) {
        float step = field(p);
        if (step < 0.00005) {
            hit = true;
            break;
        }
        if (distance(p, eye) > 25.0) break;
        p += step * d;
    }
    vec3 sum = horizon + (zenith - horizon) * max(d.y, 0.0);
    if (hit) {
        vec3 n = slope(p);
        vec2 which = parts(p);
        float cosine = max(0.0, dot(n, sun));
        sum = ambient + (cosine > 0.0 ? sunlit(p + 0.002 * n) * cosine * sun_color : vec3(0.0));
        sum *= which.y > which.x ? ball_color : sponge_color;
    }
    fragment_color = vec4(encoded(sum.r), encoded(sum.g), encoded(sum.b), 1.0);
}
