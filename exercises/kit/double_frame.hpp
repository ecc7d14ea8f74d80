#pragma once

#include <glm/glm.hpp>
#include <umbral/gl/framebuffer.hpp>

#include "picture.hpp"

namespace umbral {

/// A framebuffer of twice a picture's size, so that edges come out smooth. A context must be current while it lives.
class DoubleFrame {
public:
    /// For a picture of this size. Draws go here from now on, over the whole size; `background` is sRGB.
    DoubleFrame(int width, int height, const glm::vec3& background = ink::night)
        : large_(2 * width, 2 * height), background_(background, 1)
    {
        clear();
    }

    void clear() const { large_.clear(background_); }

    /// What is drawn into.
    [[nodiscard]] const gl::Framebuffer& large() const { return large_; }

    /// What was drawn, at half the size.
    [[nodiscard]] Image picture() const { return halved(large_.read_pixels()); }

private:
    gl::Framebuffer large_;
    glm::vec4 background_;
};

}
