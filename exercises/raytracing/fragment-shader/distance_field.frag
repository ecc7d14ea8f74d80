#version 330

in vec2 place;                // of the pixel: x to the right, y up from -1 to 1, (0, 0) the middle of the picture

uniform vec3 eye;             // in the world
uniform mat3 camera;          // columns: the camera's right, up and back, unit vectors in the world
uniform float half_height;    // of the picture, at distance 1 before the eye

uniform int depth;            // of the sponge, 0 to 4: how often it is drilled; 0 is the cube
uniform vec4 ball;            // centre and radius of the ball that is cut out of it

uniform vec3 sponge_color;
uniform vec3 ball_color;      // where the ball was
uniform vec3 sun;             // towards it, unit length
uniform vec3 sun_color;
uniform vec3 ambient;
uniform vec3 horizon;         // radiance of the background, along directions that do not rise
uniform vec3 zenith;          // and straight up

out vec4 fragment_color;      // what the framebuffer stores: encoded as sRGB

// From linear light to what framebuffers store. Call it once, at the end.
vec3 srgb_encoded(vec3 linear)
{
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

void main()
{
    // TODO: the distance from a point to sponge and ball; steps along the ray; the normal; the light.
    fragment_color = vec4(vec3(0.5), 1.0);
}
