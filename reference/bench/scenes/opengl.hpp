#pragma once

#include <memory>
#include <string>
#include <umbral/gl/context.hpp>

#include "model.hpp"
#include "operators.hpp"

namespace umbral::bench::scenes {

/// Draws models by OpenGL, upside down, so that its rule for ties is ours: coverage is the same in software.
class OpenGlPainter {
public:
    /// Throws std::runtime_error if the back end cannot be loaded.
    explicit OpenGlPainter(gl::BackendKind kind);
    OpenGlPainter(const OpenGlPainter&) = delete;
    OpenGlPainter& operator=(const OpenGlPainter&) = delete;
    ~OpenGlPainter();

    /// Makes its context current, and leaves it so.
    [[nodiscard]] Image paint(const Model& model, Flaw flaw, Way way);

    /// Back end, version and renderer.
    [[nodiscard]] std::string description();

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}
