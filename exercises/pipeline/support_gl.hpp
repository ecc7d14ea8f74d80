#pragma once

#include <kit/double_frame.hpp>
#include <kit/gl_state.hpp>
#include <string>
#include <umbral/core/grid.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>

/// What the drivers share that draw with OpenGL.
namespace umbral::pipeline {

/// Attribute 0 is the position in clip coordinates, attribute 1 the colour.
inline const char* const vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 color;
out vec3 shade;
void main()
{
    gl_Position = vec4(position, 1.0);
    shade = color;
}
)";
inline const char* const fragment_shader = R"(#version 330 core
in vec3 shade;
out vec4 pixel;
void main() { pixel = vec4(shade, 1.0); }
)";

/// A picture to draw into with the program above.
class Canvas {
public:
    explicit Canvas(int size)
        : program_({"driver.vert", vertex_shader}, {"driver.frag", fragment_shader}), target_(size, size)
    {
        program_.use();
        glEnable(GL_DEPTH_TEST);
    }

    void clear() const { target_.clear(); }
    void use() const { program_.use(); }

    [[nodiscard]] Image picture() const { return target_.picture(); }

private:
    gl::Program program_;
    DoubleFrame target_;
};

/// A parameter of OpenGL's state, as a number to record.
inline float state_of(GLenum name) { return static_cast<float>(integer(name)); }

}
