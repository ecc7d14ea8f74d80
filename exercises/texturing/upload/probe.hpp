#pragma once

#include <array>
#include <kit/attributes.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/texturing/upload.hpp>
#include <vector>

#include "../support.hpp"

/// What a texture unit gives to shaders, and what state OpenGL is in.
namespace umbral::texturing {

inline constexpr int units = 16;

/// A rectangle of texture coordinates, read at the centres of columns x rows cells.
struct Window {
    glm::vec2 low{0};
    glm::vec2 high{1};
    int columns = 1;
    int rows = 1;
};

/// Reads textures as shaders do. A context must be current while it lives.
class Probe {
public:
    Probe()
        : program_({"probe.vert", R"(#version 330 core
in vec2 corner;
uniform vec2 low;
uniform vec2 high;
out vec2 st;
void main()
{
    st = mix(low, high, corner);
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
)"},
                   {"probe.frag", R"(#version 330 core
in vec2 st;
uniform sampler2D picture;
out vec4 color;
void main() { color = texture(picture, st); }
)"}),
          target_(size, size),
          square_(program_, {0, 1, 2, 0, 2, 3}, {{"corner", corners()}})
    {
    }

    /// Red, green, blue, alpha of each cell in bytes, top row first. At most 64 x 64.
    [[nodiscard]] std::vector<glm::vec4> read(int unit, const Window& window) const
    {
        target_.clear(glm::vec4(0.5F));
        glViewport(0, 0, window.columns, window.rows);
        program_.set("low", window.low);
        program_.set("high", window.high);
        program_.set("picture", unit);
        square_.draw();
        const Image picture = target_.read_pixels();
        std::vector<glm::vec4> cells;
        for (int row = size - window.rows; row < size; ++row)
            for (int column = 0; column < window.columns; ++column) cells.emplace_back(picture.at(column, row));
        return cells;
    }

private:
    static constexpr int size = 64;

    static const std::vector<glm::vec2>& corners()
    {
        static const std::vector<glm::vec2> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        return square;
    }

    gl::Program program_;
    gl::Framebuffer target_;
    AttributeMesh square_;
};

/// No two neighbours are alike in any channel.
inline Grid<glm::u8vec3> random_picture(Random& random, int width, int height)
{
    Grid<glm::u8vec3> picture(width, height);
    for (glm::u8vec3& texel : picture.cells)
        for (int channel = 0; channel < 3; ++channel) texel[channel] = static_cast<std::uint8_t>(random.below(256));
    return picture;
}

inline Sampler random_sampler(Random& random)
{
    Sampler sampler;
    sampler.filter = both_filters[random.below(2)];
    sampler.wrap_u = random_wrap(random);
    sampler.wrap_v = random_wrap(random);
    return sampler;
}

inline GLint integer(GLenum name)
{
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

/// How many of the first two hundred names are names of textures.
inline int living_textures()
{
    int count = 0;
    for (GLuint name = 1; name <= 200; ++name) count += glIsTexture(name) == GL_TRUE ? 1 : 0;
    return count;
}

/// A texture of one grey texel for every unit, the driver's own: bound before the student's code runs, so that a
/// binding that goes to a wrong unit shows. The active unit is 0 afterwards.
class Decoys {
public:
    Decoys()
    {
        glGenTextures(units, names_.data());
        constexpr std::array<GLubyte, 4> grey = {77, 77, 77, 255};
        for (int unit = units - 1; unit >= 0; --unit) {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            glBindTexture(GL_TEXTURE_2D, names_[static_cast<std::size_t>(unit)]);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, grey.data());
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
        }
    }
    Decoys(const Decoys&) = delete;
    Decoys& operator=(const Decoys&) = delete;
    ~Decoys() { glDeleteTextures(units, names_.data()); }

    /// What each unit has: 0 nothing, 1 its own decoy as it was, 2 another texture. Leaves the active unit alone.
    [[nodiscard]] std::vector<float> bound() const
    {
        const auto active = static_cast<GLenum>(integer(GL_ACTIVE_TEXTURE));
        std::vector<float> row;
        for (std::size_t unit = 0; unit < names_.size(); ++unit) {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            const auto name = static_cast<GLuint>(integer(GL_TEXTURE_BINDING_2D));
            row.push_back(name == 0 ? 0.0F : name == names_[unit] && is_untouched() ? 1.0F : 2.0F);
        }
        glActiveTexture(active);
        return row;
    }

private:
    /// The texture that is bound.
    static bool is_untouched()
    {
        GLint width = 0;
        GLint wrap = 0;
        GLint filter = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &wrap);
        glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &filter);
        return width == 1 && wrap == GL_MIRRORED_REPEAT && filter == GL_NEAREST;
    }

    std::array<GLuint, units> names_{};
};

}
