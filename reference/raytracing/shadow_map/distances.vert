// Based on: L. Williams. Casting Curved Shadows on Curved Surfaces. SIGGRAPH 1978: the first pass.
#version 330

in vec3 position;

uniform mat4 model;
uniform mat4 light_view;
uniform mat4 light_projection;

out vec3 world_position;

void main()
{
    vec4 world = model * vec4(position, 1.0);
    world_position = world.xyz;
    gl_Position = light_projection * light_view * world;
}
