// mistake: leaves the normals in world coordinates
// credit: 50..66
// hint: Lights and viewer are in eye coordinates, so the normals must be too: the view matrix turns them as well.
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

    eye_normal = normalize(transpose(inverse(mat3(model))) * normal);
    gl_Position = projection * placed;
}
