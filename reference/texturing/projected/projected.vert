// Based on: M. Segal, C. Korobkin, R. van Widenfelt, J. Foran, P. Haeberli. Fast Shadows and Lighting Effects Using
// Texture Mapping. SIGGRAPH 1992.
#version 330

in vec3 position;
in vec3 normal;
in vec3 color;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform mat4 projector_view;
uniform mat4 projector_projection;

out vec3 world_position;
out vec3 world_normal;
out vec3 albedo;
out vec4 slide_position; // the projector's clip coordinates

void main()
{
    vec4 world = model * vec4(position, 1.0);
    world_position = world.xyz;
    world_normal = inverse(transpose(mat3(model))) * normal;
    albedo = color;
    slide_position = projector_projection * projector_view * world;
    gl_Position = projection * view * world;
}
