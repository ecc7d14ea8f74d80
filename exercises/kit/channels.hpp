#pragma once

#include <glm/glm.hpp>
#include <umbral/core/random.hpp>

/// Colours of which channels are missing.
namespace umbral {

/// The colour without one of its channels.
inline glm::vec3 without_a_channel(Random& random, glm::vec3 color)
{
    color[static_cast<glm::length_t>(random.below(3))] = 0;
    return color;
}

/// The colour without one of its channels, or with only one.
inline glm::vec3 some_channels(Random& random, const glm::vec3& color)
{
    const glm::vec3 others = without_a_channel(random, color);
    return random.below(2) == 0 ? others : color - others;
}

}
