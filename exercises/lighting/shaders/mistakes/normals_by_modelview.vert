// mistake: moves normals with the matrix that moves points
// credit: 73..88
// hint: On stretched things your light lies wrong: where a surface is pressed flat, normals must tilt the other way. Use the inverse of the transpose.
#version 330

in vec3 position;
in vec3 normal;

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

    eye_normal = normalize(mat3(modelview) * normal);
    gl_Position = projection * placed;
}
