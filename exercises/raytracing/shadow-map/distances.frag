#version 330

uniform vec4 light;       // (x, y, z, 1): it stands there, in the world; (x, y, z, 0): the unit vector towards it

out float light_distance; // what the map keeps, a float

void main()
{
    // TODO: how far is this point from the light?
    light_distance = 0.0;
}
