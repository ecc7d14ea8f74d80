#version 330

uniform sampler2D distances;   // the first pass's map: one distance a texel, in .r, not blended; (0, 0) is lower left
uniform mat4 light_projection; // as in shadows.vert; [0][0] and [1][1] are positive
uniform vec4 light;            // (x, y, z, 1): it stands there, in the world; (x, y, z, 0): the unit vector towards it
uniform vec3 light_color;      // light that it throws on a surface that faces it
uniform vec3 ambient;          // light that comes from everywhere

out vec4 fragment_color;       // what the framebuffer stores: encoded as sRGB

// From linear light to what framebuffers store. Call it once, at the end.
vec3 srgb_encoded(vec3 linear)
{
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

void main()
{
    // TODO: how does the surface face the light? Where on the map does this point lie? Is what the map says nearer than
    // this point by more than the bias?
    fragment_color = vec4(vec3(0.5), 1.0);
}
