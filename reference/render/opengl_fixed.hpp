#pragma once

#include <cstddef>

#include "render/counters.hpp"
#include "render/draw_list.hpp"
#include "render/effects.hpp"
#include "render/frame.hpp"

namespace umbral::render {

/// GL_LIGHT0 to GL_LIGHT7: as many as every OpenGL has.
inline constexpr std::size_t fixed_function_lights = 8;
/// The largest exponent of a highlight that OpenGL takes; larger ones are drawn as this one.
inline constexpr float fixed_function_exponent = 128;

/// Draws by OpenGL's fixed function: no shader, light computed at the vertices by glLight and glMaterial, its colours
/// interpolated, textures by GL_MODULATE before the separate specular colour is added. Nothing is cut off at 1.
///
/// State and objects of effects that are not in `effects` are never set or made. Needs a current gl::OffscreenContext;
/// leaves its state and objects as they were. Adds to `work` what OpenGL was handed, if it is given. Throws
/// std::runtime_error if the list has more than fixed_function_lights lights, or if OpenGL refuses something. Based on:
/// M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 2.1). 2006, section 2.14.
[[nodiscard]] Frame draw_with_fixed_function(const DrawList& list, const EffectSet& effects, int width, int height,
                                             OpenGlWork* work = nullptr);

}
