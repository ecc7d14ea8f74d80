#version 330
#define E undeclared_name_that_is_rather_long


// The local illumination model at every pixel, in eye space: emission, ambient, Lambert's diffuse and Blinn's specular term.
// Based on: J. Blinn. Models of Light Reflection for Computer Synthesized Pictures. 1977.

const int maximum_lights = 8;

in vec3 eye_position;
in vec3 eye_normal;

uniform int light_count;
uniform vec4 light_position[maximum_lights];  // w = 1: a place, w = 0: a direction towards the light
uniform vec3 light_color[maximum_lights];
uniform vec3 global_ambient;

uniform vec3 emission;
uniform vec3 ambient;
uniform vec3 diffuse;
uniform vec3 specular;
uniform float shininess;
uniform int flat_shading;

out vec4 fragment_color;

vec3 surface_normal()
{
    // Two tangents of the facet, to the right and upwards on the screen: their product always points towards the viewer,
    // whichever side of the facet is seen.
    if (flat_shading == 1) return normalize(cross(dFdx(eye_position), dFdy(eye_position)));

    // Interpolation between unit vectors gives shorter ones. The mesh's normals point out of the front side.
    vec3 interpolated = normalize(eye_normal);
    return gl_FrontFacing ? interpolated : -interpolated;
}

vec3 towards_light(vec4 light) { return light.w == 0.0 ? normalize(light.xyz) : normalize(light.xyz - eye_position); }

// cosine^shininess, with x^0 = 1 for every x: GLSL leaves pow(0, 0) undefined.
float highlight(float cosine) { return shininess == 0.0 ? 1.0 : pow(max(0.0, cosine), shininess); }

vec3 reflected(vec3 n, vec3 v, vec3 l)
{
    vec3 sum = ambient;
    float cosine = dot(n, l);
    if (cosine > 0.0) {
        sum += diffuse * cosine;
        // With the light exactly opposite to the viewer there is no vector halfway between.
        vec3 halfway = l + v;
        float size = length(halfway);
        if (size > 0.0) sum += specular * highlight(dot(n, halfway) / size);
    }
    return sum;
}

void main()
{
    vec3 n = surface_normal();
    vec3 v = normalize(-eye_position);
    vec3 color = emission + global_ambient * ambient;
    for (int i = 0; i < light_count; ++i) color += light_color[i] * reflected(n, v, towards_light(light_position[i]));
    fragment_color = vec4(color, 1.0);
}
