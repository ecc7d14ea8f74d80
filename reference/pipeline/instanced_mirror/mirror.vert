// Based on: M. J. Kilgard. Improving Shadows and Reflections via the Stencil Buffer. NVIDIA, 1999.
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
    vec4 place = model * vec4(position, 1.0);
    // From the mirror, counted in lengths of its normal.
    float height = dot(mirror, place) / dot(mirror.xyz, mirror.xyz);

    // Light falls on the thing: its image only shows it.
    world_position = place.xyz;
    world_normal = transpose(inverse(mat3(model))) * normal;

    is_image = gl_InstanceID;
    winding = determinant(mat3(model)) < 0.0 ? -1 : 1;
    if (is_image == 1) {
        place.xyz -= 2.0 * height * mirror.xyz;
        winding = -winding;
    }
    gl_Position = projection * view * place;

    // What is behind the mirror has no image, and is hidden itself: the same cut for both.
    gl_ClipDistance[0] = height;
}
