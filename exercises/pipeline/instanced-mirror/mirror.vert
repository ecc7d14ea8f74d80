#version 330

// What comes in. The program that draws feeds exactly these; a name that you do not use may go, a type may not change.
in vec3 position;        // of the vertex, in the object's coordinates
in vec3 normal;          // of the surface there, unit length, in the object's coordinates

uniform mat4 model;      // object to world: turns, moves, stretches, and sometimes mirrors
uniform mat4 view;       // world to eye
uniform mat4 projection; // eye to clip coordinates
uniform vec4 mirror;     // the plane mirror.x X + mirror.y Y + mirror.z Z + mirror.w = 0 in world coordinates. Its normal, the xyz, points to
                         // the side where the things are, and has any length

// What goes out, to the fragment shader that the program has already.
out vec3 world_position; // of the thing itself, in both instances: light falls on the thing
out vec3 world_normal;   // likewise; any length
flat out int is_image;   // 0: the thing, 1: its image in the mirror
flat out int winding;    // 1: the outside's triangles run anticlockwise, as in the mesh; -1: clockwise, since they are mirrored

void main()
{
    // TODO: instance 0 is the thing, instance 1 its image: find out by gl_InstanceID. Write gl_ClipDistance[0]: what gets a negative
    // number is cut away. README.md has the formula.
    world_position = vec3(0.0);
    world_normal = vec3(0.0);
    is_image = 0;
    winding = 1;
    gl_Position = projection * view * model * vec4(position, 1.0);
}
