#include <algorithm>
#include <stdexcept>
#include <string>
#include <umbral/gl/context.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>

namespace umbral::gl {
namespace {

void attach(GLuint renderbuffer, GLenum format, GLenum attachment, int width, int height)
{
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
}

/// Reads without trusting the pixel-store state that was left behind; turns OpenGL's bottom row first into top row
/// first.
template <class Cell>
Grid<Cell> read(GLuint framebuffer, int width, int height, GLenum format, GLenum type)
{
    Grid<Cell> cells(width, height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glPixelStorei(GL_PACK_SWAP_BYTES, GL_FALSE);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_SKIP_ROWS, 0);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, format, type, cells.cells.data());
    glPopClientAttrib();
    for (int y = 0; y < height / 2; ++y)
        std::swap_ranges(&cells.at(0, y), &cells.at(0, y) + width, &cells.at(0, height - 1 - y));
    return cells;
}

}

Framebuffer::Framebuffer(int width, int height) : width_(width), height_(height)
{
    if (width <= 0 || height <= 0)
        throw std::invalid_argument("gl::Framebuffer: expected a size of at least 1 x 1, got " + std::to_string(width) +
                                    " x " + std::to_string(height));
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &color_);
    glGenRenderbuffers(1, &depth_);
    bind();
    attach(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0, width, height);
    attach(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, width, height);
    if (const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER); status != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("gl::Framebuffer: the driver refuses " + std::to_string(width) + " x " +
                                 std::to_string(height) + " pixels of RGBA8 with depth (status " +
                                 std::to_string(status) + ")");
}

Framebuffer::~Framebuffer()
{
    if (!has_context()) return;
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &color_);
    glDeleteRenderbuffers(1, &depth_);
}

void Framebuffer::bind() const
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
}

void Framebuffer::clear(const glm::vec4& color) const
{
    bind();
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearColor(color.r, color.g, color.b, color.a);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Image Framebuffer::read_pixels() const
{
    return read<glm::u8vec4>(framebuffer_, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE);
}

Grid<float> Framebuffer::read_depth() const
{
    return read<float>(framebuffer_, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT);
}

}
