#include <cstddef>
#include <memory>
#include <umbral/gl/context.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>

#include "raster.hpp"

namespace umbral::bench {
namespace {

// Upside down, so that OpenGL's first row is the top one, and its left and bottom edges are left and top ones.
constexpr const char* vertex_text =
    "#version 330\nlayout(location = 0) in vec4 clip;\nlayout(location = 1) in vec3 color;\nout vec3 blended;\n"
    "void main() { gl_Position = vec4(clip.x, -clip.y, clip.zw); blended = color; }\n";
constexpr const char* fragment_text =
    "#version 330\nin vec3 blended;\nout vec4 result;\nvoid main() { result = vec4(blended, 1); }\n";

class Gl final : public RasterContestant {
public:
    Gl(std::span<const RasterVertex> vertices, int side)
        : target_(side, side),
          program_({"raster.vert", vertex_text}, {"raster.frag", fragment_text}),
          count_(static_cast<GLsizei>(vertices.size()))
    {
        glGenVertexArrays(1, &array_);
        glGenBuffers(1, &buffer_);
        glBindVertexArray(array_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(), GL_STATIC_DRAW);
        for (GLuint i = 0; i < 2; ++i) glEnableVertexAttribArray(i);
        glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(RasterVertex),
                              reinterpret_cast<const void*>(offsetof(RasterVertex, clip)));
        glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(RasterVertex),
                              reinterpret_cast<const void*>(offsetof(RasterVertex, color)));
        gl::check_errors("preparing the triangles");
    }
    Gl(const Gl&) = delete;
    Gl& operator=(const Gl&) = delete;
    ~Gl() override
    {
        glDeleteVertexArrays(1, &array_);
        glDeleteBuffers(1, &buffer_);
    }

    void clear() override
    {
        target_.clear({0, 0, 0, 0});
        glFinish();
    }

    void draw() override
    {
        target_.clear({0, 0, 0, 0});
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        program_.use();
        glBindVertexArray(array_);
        glDrawArrays(GL_TRIANGLES, 0, count_);
        glFinish();
    }

    [[nodiscard]] Grid<std::uint32_t> picture() const override
    {
        const Image image = target_.read_pixels();
        Grid<std::uint32_t> grid(image.width, image.height);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const glm::uvec4 pixel(image.at(x, image.height - 1 - y));
                grid.at(x, y) = pixel.r | pixel.g << 8U | pixel.b << 16U;
            }
        return grid;
    }

private:
    gl::Framebuffer target_;
    gl::Program program_;
    GLsizei count_;
    GLuint array_ = 0;
    GLuint buffer_ = 0;
};

}

std::unique_ptr<RasterContestant> make_gl_raster(std::span<const RasterVertex> vertices, int side)
{
    return std::make_unique<Gl>(vertices, side);
}

}
