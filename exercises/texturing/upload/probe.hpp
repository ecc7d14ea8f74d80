#pragma once

#include <array>
#include <kit/attributes.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/texturing/upload.hpp>
#include <vector>

#include "../support.hpp"

/// What a texture unit gives to shaders.
namespace umbral::texturing {

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

}
