#version 330

uniform sampler2D slide;         // what is projected: linear light, (0, 0) the lower left corner
uniform vec3 projector_position; // in the world: where all of its light comes from
uniform vec3 lamp_color;         // light that a white slide throws on a surface that faces the projector
uniform vec3 ambient;            // light that comes from everywhere

out vec4 fragment_color;         // what the framebuffer stores: encoded as sRGB

// From linear light to what framebuffers store. Call it once, at the end.
vec3 srgb_encoded(vec3 linear)
{
    vec3 light = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light, lessThanEqual(light, vec3(0.0031308)));
}

void main()
{
    // TODO: is this point in the beam? Where in the slide does it lie? How does the surface face the projector?
    fragment_color = vec4(vec3(0.5), 1.0);
}
