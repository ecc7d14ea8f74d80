#pragma once

#include <optional>
#include <span>
#include <string>
#include <umbral/gl/context.hpp>
#include <vector>

#include "render/counters.hpp"
#include "render/draw_list.hpp"
#include "render/effects.hpp"
#include "render/frame.hpp"
#include "render/rays/draw.hpp"

namespace umbral::render {

/// What all renderers are given.
struct Job {
    const DrawList& list;
    EffectSet effects;
    int width;
    int height;
    bool count = false;        ///< the work too, where that costs time
    rays::Effort effort = {};  ///< for those that follow rays
};

/// What came of it, and the work that was counted.
struct Drawn {
    Frame frame;
    std::vector<Count> counts;
};

struct Renderer {
    const char* name;     ///< as --renderer takes it
    const char* does;     ///< one line
    const char* effects;  ///< how effects are left out that a scene does not call for, one line
    bool needs_opengl;
    Drawn (*draw)(const Job& job);
    bool follows_rays = false;  ///< it may see what the camera does not: its draw list must hold that too
};

[[nodiscard]] std::span<const Renderer> all_renderers();

/// Throws std::invalid_argument if there is none of that name.
[[nodiscard]] const Renderer& renderer_named(const std::string& name);

/// Draws by any renderer. An OpenGL context is made when the first one asks for it, one for all pictures; where nobody
/// asks there is none. Errors as the renderers' own.
class Studio {
public:
    [[nodiscard]] Drawn draw(const Renderer& renderer, const Job& job);

private:
    std::optional<gl::OffscreenContext> context_;
};

}
