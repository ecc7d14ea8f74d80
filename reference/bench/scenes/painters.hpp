#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "opengl.hpp"
#include "render/renderers.hpp"
#include "software.hpp"

namespace umbral::bench::scenes {

/// All that can draw here.
class Painters {
public:
    /// OpenGL is drawn by `kind`; the other back end is loaded too where there is one.
    explicit Painters(gl::BackendKind kind);

    [[nodiscard]] Image opengl(const Model& model, Flaw flaw, Way way);
    /// The build that the way asks for; the plain one for ways that ask for none.
    [[nodiscard]] static SoftwareBuild software(Way way);
    /// The engine's picture, by the renderer of this name.
    [[nodiscard]] render::Frame engine(const std::string& renderer, const render::Job& job);
    /// Can this way be drawn on this machine, with this build?
    [[nodiscard]] bool has(Way way) const;
    [[nodiscard]] std::string description() { return main_.description(); }

private:
    OpenGlPainter main_;
    std::unique_ptr<OpenGlPainter> other_;
    render::Studio studio_;
};

}
