#pragma once

#include <array>

#include "render/frame.hpp"

namespace umbral::render {

/// Where the ids of what was drawn are.
enum class Ids {
    in_a_buffer,  ///< of their own, R32UI: a shader writes them
    in_alpha      ///< of the colour, for the fixed function, which has no other way: whole numbers after rounding
};

/// A framebuffer of floats: colour RGBA32F, ids as said, depth 32F. Needs a current context.
class OpenGlTarget {
public:
    /// Makes it, binds it and clears it to "nothing". Throws std::runtime_error if the driver refuses the size.
    OpenGlTarget(int width, int height, Ids ids = Ids::in_a_buffer);
    OpenGlTarget(const OpenGlTarget&) = delete;
    OpenGlTarget& operator=(const OpenGlTarget&) = delete;
    ~OpenGlTarget();

    /// What was drawn; row 0 is OpenGL's first, the top one if drawn upside down.
    [[nodiscard]] Frame read() const;

private:
    void release() const;

    int width_;
    int height_;
    Ids ids_;
    unsigned framebuffer_ = 0;
    std::array<unsigned, 3> buffers_{};  ///< colour, depth, ids (0 where they are in alpha)
};

}
