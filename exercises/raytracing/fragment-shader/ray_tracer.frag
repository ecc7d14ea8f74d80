#version 330

in vec2 place;                // of the pixel: x to the right, y up from -1 to 1, (0, 0) the middle of the picture

uniform vec3 eye;             // in the world
uniform mat3 camera;          // columns: the camera's right, up and back, unit vectors in the world
uniform float half_height;    // of the picture, at distance 1 before the eye

uniform int sphere_count;     // how many of the spheres there are, 0 to 8
uniform vec4 spheres[8];      // centre and radius
uniform vec3 sphere_colors[8];
uniform float mirrors[8];     // k_ps of each: the fraction that it mirrors

uniform vec3 tiles[2];        // colours of the floor at y = 0: of the square from (0, 0) to (1, 1), and of its neighbours
uniform float floor_mirror;   // k_ps of the floor
uniform float floor_radius;   // the floor is a disc round the origin

uniform vec3 light_position;
uniform vec3 light_color;
uniform vec3 ambient;
uniform vec3 horizon;         // radiance of the background, along directions that do not rise
uniform vec3 zenith;          // and straight up

uniform int levels;           // surfaces that one path may meet at most, 1 to 6: with 1 nothing is mirrored

out vec4 fragment_color;      // what the framebuffer stores: encoded as sRGB

// From linear light to what framebuffers store. Call it once, at the end.
vec3 srgb_encoded(vec3 linear)
{
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

void main()
{
    // TODO: the ray through this pixel; what it meets first; the light there; and on along the mirrored ray.
    fragment_color = vec4(vec3(0.5), 1.0);
}
