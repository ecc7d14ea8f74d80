// alternative: textureProj divides, and borders are tested in the slide's coordinates times w
#version 330

in vec3 world_position;
in vec3 world_normal;
in vec3 albedo;
in vec4 slide_position;

uniform sampler2D slide;
uniform vec3 projector_position;
uniform vec3 lamp_color;
uniform vec3 ambient;

out vec4 fragment_color;

float encoded(float x)
{
    x = clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}

void main()
{
    vec3 to_projector = projector_position - world_position;
    float product = dot(world_normal, to_projector);
    vec3 stq = vec3(0.5 * (slide_position.xy + slide_position.w), slide_position.w);
    bool inside = stq.z > 0.0 && min(stq.s, stq.t) >= 0.0 && max(stq.s, stq.t) <= stq.z;
    vec3 sum = ambient;
    if (inside && product > 0.0) {
        float lengths = sqrt(dot(world_normal, world_normal) * dot(to_projector, to_projector));
        sum += product / lengths * lamp_color * textureProj(slide, stq).rgb;
    }
    sum *= albedo;
    fragment_color = vec4(encoded(sum.r), encoded(sum.g), encoded(sum.b), 1.0);
}
