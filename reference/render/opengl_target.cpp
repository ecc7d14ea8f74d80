#include "render/opengl_target.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <umbral/gl/opengl.hpp>

namespace umbral::render {
namespace {

void attach(GLuint renderbuffer, GLenum format, GLenum attachment, int width, int height)
{
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

template <class Cell>
void read_cells(Grid<Cell>& cells, GLenum attachment, GLenum format, GLenum type)
{
    glReadBuffer(attachment);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, cells.width, cells.height, format, type, cells.cells.data());
}

}

OpenGlTarget::OpenGlTarget(int width, int height, Ids ids) : width_(width), height_(height), ids_(ids)
{
    const bool has_ids = ids == Ids::in_a_buffer;
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(has_ids ? 3 : 2, buffers_.data());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    attach(buffers_[0], GL_RGBA32F, GL_COLOR_ATTACHMENT0, width, height);
    attach(buffers_[1], GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT, width, height);
    if (has_ids) attach(buffers_[2], GL_R32UI, GL_COLOR_ATTACHMENT1, width, height);
    const std::array<GLenum, 2> outputs = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(has_ids ? 2 : 1, outputs.data());
    if (const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER); status != GL_FRAMEBUFFER_COMPLETE) {
        release();
        throw std::runtime_error("OpenGL refuses a picture of " + std::to_string(width) + " x " +
                                 std::to_string(height) + " pixels with colour, ids and depth (status " +
                                 std::to_string(status) + "): try a smaller one");
    }
    glViewport(0, 0, width, height);
    const std::array<GLfloat, 4> no_color = {0, 0, 0, 0};
    const std::array<GLuint, 4> no_id = {0, 0, 0, 0};
    const GLfloat far = 1;
    glClearBufferfv(GL_COLOR, 0, no_color.data());
    if (has_ids) glClearBufferuiv(GL_COLOR, 1, no_id.data());
    glClearBufferfv(GL_DEPTH, 0, &far);
}

OpenGlTarget::~OpenGlTarget() { release(); }

void OpenGlTarget::release() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
}

Frame OpenGlTarget::read() const
{
    Frame frame(width_, height_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    read_cells(frame.color, GL_COLOR_ATTACHMENT0, GL_RGBA, GL_FLOAT);
    read_cells(frame.depth, GL_COLOR_ATTACHMENT0, GL_DEPTH_COMPONENT, GL_FLOAT);
    if (ids_ == Ids::in_a_buffer) {
        read_cells(frame.ids, GL_COLOR_ATTACHMENT1, GL_RED_INTEGER, GL_UNSIGNED_INT);
        return frame;
    }
    for (std::size_t i = 0; i < frame.ids.cells.size(); ++i) {
        float& alpha = frame.color.cells[i].a;
        frame.ids.cells[i] = static_cast<std::uint32_t>(std::lround(alpha));
        alpha = frame.ids.cells[i] != 0 ? 1 : 0;
    }
    return frame;
}

}
