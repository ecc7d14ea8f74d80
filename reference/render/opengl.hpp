#pragma once

#include "render/counters.hpp"
#include "render/draw_list.hpp"
#include "render/effects.hpp"
#include "render/frame.hpp"

namespace umbral::render {

/// Draws by OpenGL, with shaders that hold the code of `effects` only. Needs a current gl::OffscreenContext; leaves no
/// object behind. Adds to `work` what OpenGL was handed, if it is given. Throws std::runtime_error if OpenGL refuses
/// something.
[[nodiscard]] Frame draw_with_opengl(const DrawList& list, const EffectSet& effects, int width, int height,
                                     OpenGlWork* work = nullptr);

}
