// alternative: one formula for lamp and sun, mixed by w
// file: distances.frag
#version 330

in vec3 world_position;

uniform vec4 light;

layout(location = 0) out float light_distance;

void main()
{
    vec3 from_lamp = world_position - light.xyz;
    light_distance = mix(dot(world_position, -light.xyz), sqrt(dot(from_lamp, from_lamp)), light.w);
}
