#pragma once

#include <array>

#include "render/frame.hpp"

namespace umbral::render {

/// A framebuffer of floats: colour RGBA32F, ids R32UI, depth 32F. Needs a current context.
class OpenGlTarget {
public:
    /// Makes it, binds it and clears it to "nothing". Throws std::runtime_error if the driver refuses the size.
    OpenGlTarget(int width, int height);
    OpenGlTarget(const OpenGlTarget&) = delete;
    OpenGlTarget& operator=(const OpenGlTarget&) = delete;
    ~OpenGlTarget();

    /// What was drawn; row 0 is OpenGL's first, the top one if drawn upside down.
    [[nodiscard]] Frame read() const;

private:
    void release() const;

    int width_;
    int height_;
    unsigned framebuffer_ = 0;
    std::array<unsigned, 3> buffers_{};  ///< colour, ids, depth
};

}
