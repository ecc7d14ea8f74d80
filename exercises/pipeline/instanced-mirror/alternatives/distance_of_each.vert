// alternative: cuts each instance on its own side of the mirror, and takes the normal's inverse from the left
#version 330

in vec3 position;
in vec3 normal;
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec4 mirror;
out vec3 world_position;
out vec3 world_normal;
flat out int is_image;
flat out int winding;

void main()
{
    world_position = (model * vec4(position, 1.0)).xyz;
    world_normal = normalize(normal * inverse(mat3(model)));
    bool image = gl_InstanceID % 2 == 1;
    vec3 unit = normalize(mirror.xyz);
    float offset = mirror.w / length(mirror.xyz);
    vec3 seen = image ? reflect(world_position, unit) - 2.0 * offset * unit : world_position;
    float side = dot(unit, seen) + offset;
    gl_ClipDistance[0] = image ? -side : side;
    gl_Position = projection * view * vec4(seen, 1.0);
    is_image = image ? 1 : 0;
    winding = image == (determinant(model) < 0.0) ? 1 : -1;
}
