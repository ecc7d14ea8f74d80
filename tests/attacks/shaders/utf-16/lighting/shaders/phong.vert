#version 330

// Places a vertex, and hands its eye-space position and normal to phong.frag.

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

    // A tangent t moves with the matrix A, so n stays perpendicular to it only if it moves with the inverse transpose:
    // dot(inverse(transpose(A)) n, A t) = dot(n, t).
    eye_normal = normalize(transpose(inverse(mat3(modelview))) * normal);
    gl_Position = projection * placed;
}
