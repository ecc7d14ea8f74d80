#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <kit/picture.hpp>
#include <stdexcept>
#include <umbral/gl/opengl.hpp>

/// Where OpenGL draws light itself: in floats, without rounding and without an upper bound.
namespace umbral::lighting {

/// A picture of floats with a depth buffer. A context must be current while it lives.
class LinearFrame {
public:
    /// Draws go here from now on, over the whole size, without a program; OpenGL no longer clamps colours between
    /// vertex and pixel.
    LinearFrame(int width, int height) : width_(width), height_(height)
    {
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glGenRenderbuffers(2, buffers_);
        attach(GL_COLOR_ATTACHMENT0, buffers_[0], GL_RGBA32F);
        attach(GL_DEPTH_ATTACHMENT, buffers_[1], GL_DEPTH_COMPONENT24);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("OpenGL cannot draw into a framebuffer of floats");
        glUseProgram(0);
        glBindVertexArray(0);
        glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
        glViewport(0, 0, width, height);
        clear();
    }
    LinearFrame(const LinearFrame&) = delete;
    LinearFrame& operator=(const LinearFrame&) = delete;
    ~LinearFrame()
    {
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteRenderbuffers(2, buffers_);
    }

    /// Fills it with this light, and the largest depth.
    void clear(const glm::vec3& light = glm::vec3(0)) const
    {
        glClearColor(light.r, light.g, light.b, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

    /// The light that was drawn, top row first.
    [[nodiscard]] Grid<glm::vec3> light() const
    {
        Grid<glm::vec3> upwards(width_, height_);
        glReadPixels(0, 0, width_, height_, GL_RGB, GL_FLOAT, upwards.cells.data());
        Grid<glm::vec3> result(width_, height_);
        for (int y = 0; y < height_; ++y)
            std::copy_n(upwards.cells.begin() + (height_ - 1 - y) * width_, width_, result.cells.begin() + y * width_);
        return result;
    }

    /// What was drawn as a picture of half the size, so that edges have no steps.
    [[nodiscard]] Image picture() const { return halved(encoded(light())); }

private:
    void attach(GLenum place, GLuint buffer, GLenum format) const
    {
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    }

    int width_;
    int height_;
    GLuint framebuffer_ = 0;
    GLuint buffers_[2] = {0, 0};
};

}
