// alternative: the normal matrix from cross products of columns; the matrices multiplied first; its own attribute places
#version 330

layout(location = 3) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform mat4 projector_view;
uniform mat4 projector_projection;

out vec3 world_position;
out vec3 world_normal;
out vec3 albedo;
out vec4 slide_position;

void main()
{
    mat3 m = mat3(model);
    mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    world_normal = normalize(sign(dot(m[0], cofactors[0])) * (cofactors * normal));
    vec4 p = vec4(position, 1.0);
    world_position = vec3(model * p);
    albedo = color;
    slide_position = (projector_projection * projector_view * model) * p;
    gl_Position = (projection * view * model) * p;
}
