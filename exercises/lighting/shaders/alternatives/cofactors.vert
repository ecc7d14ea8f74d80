// alternative: the normal matrix from cross products of columns, no inverse; its own places for the attributes
#version 330

layout(location = 3) in vec3 position;
layout(location = 0) in vec3 normal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;

out vec3 eye_position;
out vec3 eye_normal;

void main()
{
    mat4 modelview = view * model;
    vec4 placed = modelview * vec4(position, 1.0);
    eye_position = placed.xyz;

    mat3 a = mat3(modelview);
    eye_normal = normalize(mat3(cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])) * normal);
    gl_Position = projection * placed;
}
