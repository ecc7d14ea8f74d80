#version 330

const int maximum_lights = 8;

// The lights. Only the first light_count entries count; all are in eye coordinates.
uniform int light_count;
uniform vec4 light_position[maximum_lights]; // w = 1: a place; w = 0: a direction towards the light, of any length
uniform vec3 light_color[maximum_lights];
uniform vec3 global_ambient;

// The material.
uniform vec3 emission;
uniform vec3 ambient;
uniform vec3 diffuse;
uniform vec3 specular;
uniform float shininess;  // the exponent, 0 to 128

uniform int flat_shading; // 1: one normal for each facet; 0: the normals of the vertices, interpolated

out vec4 fragment_color;

void main()
{
    // TODO: the normal n (flat or smooth), the vector v to the viewer, and for each light the vector l to it;
    // then the sum of the model. README.md has the formula.
    fragment_color = vec4(vec3(0.5), 1.0);
}
