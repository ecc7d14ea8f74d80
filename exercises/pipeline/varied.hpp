#pragma once

#include <array>
#include <glm/glm.hpp>
#include <umbral/record/variation.hpp>

/// What is written down in the drivers of the pipeline, varied.
namespace umbral::pipeline {

/// How far hues are turned, in turns: so far that nothing keeps its colour. 0 unless inputs are to vary.
inline float hue_shift(Variation& vary) { return vary.near(vary.one_of(0.0F, std::array{0.35F, 0.5F, 0.65F}), 0.15F); }

/// A colour that is written down, lighter or darker in each channel.
inline glm::vec3 other_color(Variation& vary, const glm::vec3& color)
{
    return glm::clamp(vary.near(color, 0.3F), 0.0F, 1.0F);
}

}
