// alternative: normals by the matrix's cofactors, positions brought through the matrices one by one
// file: shadows.vert
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
out vec4 map_position;

void main()
{
    vec3 a = model[0].xyz, b = model[1].xyz, c = model[2].xyz;
    world_position = position.x * a + position.y * b + position.z * c + model[3].xyz;
    world_normal = normal.x * cross(b, c) + normal.y * cross(c, a) + normal.z * cross(a, b);
    albedo = color;
    map_position = light_projection * (light_view * vec4(world_position, 1.0));
    gl_Position = projection * (view * vec4(world_position, 1.0));
}
