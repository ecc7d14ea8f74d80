#pragma once

#include <string>
#include <umbral/core/grid.hpp>
#include <umbral/gl/framebuffer.hpp>
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

inline constexpr glm::vec4 night(0.055F, 0.06F, 0.09F, 1);

/// A picture of twice the size to draw into with the program above, and how it is brought down to its own size: edges come out smooth.
class Canvas {
public:
    explicit Canvas(int size) : size_(size), program_({"driver.vert", vertex_shader}, {"driver.frag", fragment_shader}), target_(2 * size, 2 * size)
    {
        target_.clear(night);
        program_.use();
        glEnable(GL_DEPTH_TEST);
    }

    void clear() const { target_.clear(night); }
    void use() const { program_.use(); }

    /// The mean of each four pixels.
    [[nodiscard]] Image picture() const
    {
        const Image large = target_.read_pixels();
        Image small(size_, size_);
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x) {
                glm::uvec4 sum(2);
                for (int i = 0; i < 4; ++i) sum += glm::uvec4(large.at(2 * x + i % 2, 2 * y + i / 2));
                small.at(x, y) = glm::u8vec4(sum / 4U);
            }
        return small;
    }

private:
    int size_;
    gl::Program program_;
    gl::Framebuffer target_;
};

/// A parameter of OpenGL's state, as a number to record.
inline float state_of(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return static_cast<float>(value);
}

/// How many of the first thousand names are names of vertex arrays, or of buffers.
inline float living(GLboolean (*is_one)(GLuint))
{
    int count = 0;
    for (GLuint name = 1; name <= 1000; ++name) count += is_one(name) == GL_TRUE ? 1 : 0;
    return static_cast<float>(count);
}

}
