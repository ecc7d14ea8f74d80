#version 330

in vec3 world_position;

uniform vec4 light;

out float light_distance;

// In each fragment: the distance from a point is not a linear function of the place.
void main() { light_distance = light.w == 0.0 ? -dot(light.xyz, world_position) : distance(light.xyz, world_position); }
