#pragma once

#include <gtest/gtest.h>

#include <array>
#include <pipeline/software-pipeline/scenes.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>

/// The calls of the software pipeline, drawn by OpenGL.
namespace umbral::pipeline {

inline constexpr const char* vertex_text =
    "#version 330\nlayout(location = 0) in vec3 position;\nlayout(location = 1) in vec3 color;\nuniform mat4 "
    "to_clip;\nout vec3 smooth_color;\n"
    "flat out vec3 flat_color;\nvoid main() {\n    vec4 clip = to_clip * vec4(position, 1.0);\n    gl_Position = "
    "vec4(clip.x, -clip.y, clip.zw);\n"
    "    smooth_color = color;\n    flat_color = color;\n}\n";
inline constexpr const char* fragment_text =
    "#version 330\nin vec3 smooth_color;\nflat in vec3 flat_color;\nuniform int is_flat;\nout vec4 result;\n"
    "void main() { result = vec4(is_flat != 0 ? flat_color : smooth_color, 1.0); }\n";

/// A framebuffer of float colours with a depth buffer of any format. Its first row is the top one, since the shader
/// turns pictures over.
class Target {
public:
    Target(int width, int height, DepthFormat format) : width_(width), height_(height)
    {
        constexpr std::array<GLenum, 3> formats = {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F};
        glGenFramebuffers(1, &framebuffer_);
        glGenRenderbuffers(2, buffers_.data());
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        attach(buffers_[0], GL_RGBA32F, GL_COLOR_ATTACHMENT0);
        attach(buffers_[1], formats.at(static_cast<std::size_t>(format)), GL_DEPTH_ATTACHMENT);
        EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
    }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    ~Target()
    {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteRenderbuffers(2, buffers_.data());
    }

    void clear(float depth) const
    {
        const glm::vec4 color(untouched, 0);
        glDepthMask(GL_TRUE);
        glClearBufferfv(GL_COLOR, 0, &color.r);
        glClearBufferfv(GL_DEPTH, 0, &depth);
    }

    [[nodiscard]] Layer read() const
    {
        Layer layer{Grid<glm::vec3>(width_, height_), Grid<float>(width_, height_)};
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width_, height_, GL_RGB, GL_FLOAT, layer.colors.cells.data());
        glReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, layer.depths.cells.data());
        return layer;
    }

private:
    void attach(GLuint buffer, GLenum format, GLenum place) const
    {
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    }

    int width_, height_;
    GLuint framebuffer_ = 0;
    std::array<GLuint, 2> buffers_{};
};

inline void set(const PipelineState& state)
{
    const auto enable = [](GLenum what, bool on) { on ? glEnable(what) : glDisable(what); };
    glViewport(state.viewport.left, state.viewport.top, state.viewport.width, state.viewport.height);
    glDepthRange(state.viewport.near_depth, state.viewport.far_depth);
    glFrontFace(GL_CW);
    enable(GL_CULL_FACE, state.culling != Culling::none);
    glCullFace(state.culling == Culling::front ? GL_FRONT : GL_BACK);
    constexpr std::array<GLenum, 3> modes = {GL_POINT, GL_LINE, GL_FILL};
    glPolygonMode(GL_FRONT_AND_BACK, modes.at(static_cast<std::size_t>(state.mode)));
    enable(GL_DEPTH_TEST, state.depth.enabled);
    glDepthFunc(GL_NEVER + static_cast<GLenum>(state.depth.function));
    glDepthMask(state.depth.writes ? GL_TRUE : GL_FALSE);
}

inline Layer drawn_by_mesa(const Call& call, const gl::Program& program)
{
    const Target target(call.width, call.height, call.state.depth.format);
    target.clear(call.clear_depth);
    set(call.state);
    program.set("to_clip", call.state.to_clip);
    program.set("is_flat", call.state.shading == ShadeModel::flat ? 1 : 0);
    GLuint array = 0;
    std::array<GLuint, 2> buffers{};
    glGenVertexArrays(1, &array);
    glGenBuffers(2, buffers.data());
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(call.vertices.size() * sizeof(ColoredVertex)),
                 call.vertices.data(), GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex),
                              reinterpret_cast<const void*>(i * sizeof(glm::vec3)));
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(call.triangles.size() * sizeof(glm::uvec3)),
                 call.triangles.data(), GL_STATIC_DRAW);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * call.triangles.size()), GL_UNSIGNED_INT, nullptr);
    glDeleteBuffers(2, buffers.data());
    glDeleteVertexArrays(1, &array);
    gl::check_errors("drawing a call");
    return target.read();
}

}
