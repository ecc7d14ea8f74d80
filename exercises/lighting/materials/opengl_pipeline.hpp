#pragma once

#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <umbral/core/random.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/lighting/fixed_pipeline.hpp>
#include <umbral/lighting/materials.hpp>

#include "../support.hpp"

/// OpenGL's fixed function as a pipeline. A context must be current.
namespace umbral::lighting {

/// A shape whose vertices have texture coordinates.
struct TexturedShape {
    Shape shape;
    std::vector<glm::vec2> coordinates;
};

/// Of a grid of columns x rows cells, each of which is as large as the others in the texture.
inline TexturedShape textured(Shape shape, int columns, int rows, const glm::vec2& times)
{
    std::vector<glm::vec2> coordinates;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            coordinates.push_back(times * glm::vec2(column, row) / glm::vec2(columns, rows));
    return {std::move(shape), std::move(coordinates)};
}

class OpenGlPipeline final : public LitPipeline {
public:
    /// Objects are called by their places in this list, which must live as long.
    explicit OpenGlPipeline(const std::vector<TexturedShape>& objects) : objects_(objects) {}

    void set_reflection(const Material& reflection) override { set_material(reflection); }
    void set_texture(std::uint32_t texture) override
    {
        texture == 0 ? glDisable(GL_TEXTURE_2D) : glEnable(GL_TEXTURE_2D);
        if (texture != 0) glBindTexture(GL_TEXTURE_2D, texture);
    }
    void compose(const glm::mat4& transformation) override { glMultMatrixf(glm::value_ptr(transformation)); }
    void push() override { glPushMatrix(); }
    void pop() override { glPopMatrix(); }
    void draw(std::uint32_t object) override
    {
        if (object >= objects_.size()) return;
        const auto& [shape, coordinates] = objects_[object];
        glVertexPointer(3, GL_FLOAT, 0, shape.positions.data());
        glNormalPointer(GL_FLOAT, 0, shape.normals.data());
        glTexCoordPointer(2, GL_FLOAT, 0, coordinates.data());
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(shape.indices.size()), GL_UNSIGNED_INT, shape.indices.data());
    }

private:
    const std::vector<TexturedShape>& objects_;
};

/// Smooth noise with a period of 1 in both directions, in [0, 1].
inline float noise(const glm::vec2& place, int cells, std::uint32_t seed)
{
    const auto corner = [&](int x, int y) {
        const auto wrapped = [&](int i) { return static_cast<std::uint32_t>((i % cells + cells) % cells); };
        Random random(seed + 7919U * wrapped(x) + 104'729U * wrapped(y));
        (void)random.bits();
        return random.uniform();
    };
    const glm::vec2 at = place * static_cast<float>(cells);
    const glm::ivec2 cell(floor(at));
    const glm::vec2 t = glm::smoothstep(glm::vec2(0), glm::vec2(1), fract(at));
    return glm::mix(glm::mix(corner(cell.x, cell.y), corner(cell.x + 1, cell.y), t.x),
                    glm::mix(corner(cell.x, cell.y + 1), corner(cell.x + 1, cell.y + 1), t.x), t.y);
}

/// Several octaves of it, the coarsest of four cells.
inline float turbulence(const glm::vec2& place, std::uint32_t seed)
{
    float sum = 0;
    for (int octave = 0; octave < 4; ++octave)
        sum += std::exp2(static_cast<float>(-octave - 1)) * noise(place, 4 << octave, seed);
    return sum;
}

/// A texture of 96 x 96 texels, sent when it is first activated.
template <class Paint>
class PaintedTexture final : public SharedTexture {
public:
    /// paint(uv) is the linear colour there.
    explicit PaintedTexture(Paint paint) : paint_(paint) {}
    PaintedTexture(const PaintedTexture&) = delete;
    PaintedTexture& operator=(const PaintedTexture&) = delete;
    ~PaintedTexture() override { glDeleteTextures(1, &name_); }

    void activate(LitPipeline& pipeline) override
    {
        if (name_ == 0) send();
        pipeline.set_texture(name_);
    }

private:
    void send()
    {
        constexpr int size = 96;
        std::vector<glm::vec3> texels;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) texels.push_back(paint_((glm::vec2(x, y) + 0.5F) / glm::vec2(size)));
        glGenTextures(1, &name_);
        glBindTexture(GL_TEXTURE_2D, name_);
        glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB16F, size, size, 0, GL_RGB, GL_FLOAT, texels.data());
    }

    Paint paint_;
    GLuint name_ = 0;
};

}
