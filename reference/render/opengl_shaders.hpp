#pragma once

#include <string>

#include "render/effects.hpp"

namespace umbral::render {

/// The shaders for a set of effects and a number of lights: each effect is a name that is defined or not, so the
/// compiler never sees the code of the others.
struct ShaderTexts {
    std::string vertex;
    std::string fragment;
};
[[nodiscard]] ShaderTexts shaders_for(const EffectSet& effects, std::size_t lights);

}
