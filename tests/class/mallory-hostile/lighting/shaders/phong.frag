#version 330

// Never ends: the driver cuts one loop after 65,000 rounds, so there are three, one inside the other.
uniform int light_count;
out vec4 fragment_color;

void main()
{
    float x = gl_FragCoord.x;
    for (int i = 0; i >= light_count - 100; ++i)
        for (int j = 0; j >= light_count - 100; ++j)
            for (int k = 0; k >= light_count - 100; ++k) x = sin(x + float(i + j + k));
    fragment_color = vec4(vec3(x), 1.0);
}
