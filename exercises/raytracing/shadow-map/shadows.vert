#version 330

// What comes in. The program that draws feeds exactly these; a name that you do not use may go, a type may not change.
in vec3 position;  // of the vertex, in the object's coordinates
in vec3 normal;    // of the surface there, unit length, in the object's coordinates
in vec3 color;     // how much of red, green and blue light the surface sends back

uniform mat4 model;            // object to world: turns, moves and stretches
uniform mat4 view;             // world to eye
uniform mat4 projection;       // eye to clip coordinates
uniform mat4 light_view;       // world to the light's eye coordinates: turns and moves
uniform mat4 light_projection; // and from there to its clip coordinates; w = distance along its axis, or 1

// TODO: hand to shadows.frag the world position, the world normal, the colour, and the position in the light's clip
// coordinates (a vec4).

void main() { gl_Position = projection * view * model * vec4(position, 1.0); }
