#pragma once

#include "render/counters.hpp"
#include "render/draw_list.hpp"
#include "render/effects.hpp"
#include "render/frame.hpp"

namespace umbral::render {

struct SoftwarePicture {
    Frame frame;
    Counters counters;
};

/// Draws by the units' own rasteriser: vertex stage, clipping, division, viewport, rasterize_triangle, depth test
/// (less), shading per pixel.
///
/// `effects` chooses the kernel: it must have every effect that the scene calls for (derive_effects), and may have
/// more: the picture is the same, bit by bit. Throws std::invalid_argument if the size is not that of a picture the
/// rasteriser takes.
[[nodiscard]] SoftwarePicture draw_in_software(const DrawList& list, const EffectSet& effects, int width, int height);

}
