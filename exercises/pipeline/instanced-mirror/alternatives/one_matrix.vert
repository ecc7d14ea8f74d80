// alternative: the reflection as a matrix, and no branch
#version 330

in vec3 position;
in vec3 normal;
uniform mat4 model, view, projection;
uniform vec4 mirror;
out vec3 world_position, world_normal;
flat out int is_image, winding;

mat4 reflection()
{
    vec4 plane = mirror / length(mirror.xyz);
    mat4 h = mat4(1.0);
    for (int column = 0; column < 4; ++column) h[column].xyz -= 2.0 * plane[column] * plane.xyz;
    return h;
}

void main()
{
    mat4 instances[2] = mat4[2](mat4(1.0), reflection());
    mat4 seen = instances[gl_InstanceID] * model;
    gl_Position = projection * (view * (seen * vec4(position, 1.0)));
    winding = int(sign(determinant(mat3(seen))));
    is_image = gl_InstanceID;

    vec4 world = model * vec4(position, 1.0);
    world_position = world.xyz;
    world_normal = sign(determinant(mat3(model))) * mat3(cross(model[1].xyz, model[2].xyz), cross(model[2].xyz, model[0].xyz), cross(model[0].xyz, model[1].xyz)) * normal;
    gl_ClipDistance[0] = dot(mirror, world);
}
