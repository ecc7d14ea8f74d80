#pragma once

#include <optional>
#include <span>
#include <string>
#include <umbral/gl/context.hpp>

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
    rays::Effort effort = {};  ///< for those that follow rays
};

/// What came of it; only some renderers can count their work.
struct Drawn {
    Frame frame;
    std::optional<Counters> counters;
};

struct Renderer {
    const char* name;  ///< as --renderer takes it
    const char* does;  ///< one line
    bool needs_opengl;
    Drawn (*draw)(const Job& job);
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
