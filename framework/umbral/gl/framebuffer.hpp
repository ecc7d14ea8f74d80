#pragma once

#include <glm/glm.hpp>
#include <umbral/core/grid.hpp>

namespace umbral::gl {

/// A picture to draw into: 8 bits for each of red, green, blue and alpha, with a 24-bit depth buffer.
///
/// Every graded picture is drawn into one of these, since the default framebuffer differs from it in a few pixels.
class Framebuffer {
public:
    /// Makes it and binds it. Needs a current context; width and height > 0. Throws std::runtime_error if the driver
    /// refuses.
    Framebuffer(int width, int height);
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;
    ~Framebuffer();

    /// Draws from now on go here, over the whole size.
    void bind() const;

    /// Binds it, and fills it with `color` (components in [0, 1]) and the largest depth. Undoes scissor and write masks
    /// first.
    void clear(const glm::vec4& color = {0, 0, 0, 1}) const;

    /// What was drawn, top row first.
    [[nodiscard]] Image read_pixels() const;
    /// The depth buffer, in [0, 1], top row first.
    [[nodiscard]] Grid<float> read_depth() const;

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }

private:
    int width_;
    int height_;
    unsigned framebuffer_ = 0;
    unsigned color_ = 0;
    unsigned depth_ = 0;
};

}
