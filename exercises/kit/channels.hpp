#pragma once

#include <glm/glm.hpp>
#include <umbral/core/random.hpp>

/// Colours of which channels are missing.
namespace umbral {

/// The colour without one of its channels, or with only one.
inline glm::vec3 some_channels(Random& random, const glm::vec3& color)
{
    const auto one = static_cast<glm::length_t>(random.below(3));
    glm::vec3 others = color;
    others[one] = 0;
    return random.below(2) == 0 ? others : color - others;
}

}
