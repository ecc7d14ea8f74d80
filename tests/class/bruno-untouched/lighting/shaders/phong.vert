#version 330

// What comes in. The program that draws feeds exactly these; a name that you do not use may go, a type may not change.
in vec3 position;        // of the vertex, in the object's coordinates
in vec3 normal;          // of the surface there, unit length, in the object's coordinates

uniform mat4 model;      // object to world: turns, moves and stretches
uniform mat4 view;       // world to eye: turns and moves
uniform mat4 projection; // eye to clip coordinates

// TODO: hand the position and the normal to phong.frag, both in eye coordinates (two `out vec3`).

void main()
{
    gl_Position = projection * view * model * vec4(position, 1.0);
}
