#version 330

in vec3 position;
in vec3 normal;
in vec3 color;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform mat4 light_view;
uniform mat4 light_projection;

out vec3 world_position;
out vec3 world_normal;
out vec3 albedo;
out vec4 map_position; // the light's clip coordinates

void main()
{
    vec4 world = model * vec4(position, 1.0);
    world_position = world.xyz;
    world_normal = inverse(transpose(mat3(model))) * normal;
    albedo = color;
    map_position = light_projection * light_view * world;
    gl_Position = projection * view * world;
}
