// mistake: multiplies the derivatives in the wrong order
// credit: 75..86
// hint: Your facets are lit from behind: x × y points towards the viewer, y × x away. Exchange the derivatives.
#version 330

const int maximum_lights = 8;

in vec3 eye_position;
in vec3 eye_normal;

uniform int light_count;
uniform vec4 light_position[maximum_lights];
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
    if (flat_shading == 1) return normalize(cross(dFdy(eye_position), dFdx(eye_position)));

    vec3 interpolated = normalize(eye_normal);
    return gl_FrontFacing ? interpolated : -interpolated;
}

vec3 towards_light(vec4 light) { return light.w == 0.0 ? normalize(light.xyz) : normalize(light.xyz - eye_position); }

float highlight(float cosine) { return shininess == 0.0 ? 1.0 : pow(max(0.0, cosine), shininess); }

vec3 reflected(vec3 n, vec3 v, vec3 l)
{
    vec3 sum = ambient;
    float cosine = dot(n, l);
    if (cosine > 0.0) {
        sum += diffuse * cosine;
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
