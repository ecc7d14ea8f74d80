#version 330

// What comes in. The program that draws feeds exactly these; a name that you do not use may go, a type may not change.
in vec3 position;  // of the vertex, in the object's coordinates

uniform mat4 model;            // object to world: turns, moves and stretches
uniform mat4 light_view;       // world to the light's eye coordinates: turns and moves
uniform mat4 light_projection; // and from there to its clip coordinates; w = distance along its axis, or 1

// TODO: hand the world position to distances.frag, and put gl_Position where the light sees the vertex.

void main() { gl_Position = vec4(position, 1.0); }
