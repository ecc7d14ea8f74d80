#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace umbral {

/// The points origin + t * direction with t_min < t < t_max.
///
/// `direction` need not have length one: t counts in its lengths.
struct Ray {
    glm::vec3 origin{0};
    glm::vec3 direction{0, 0, -1};
    float t_min = 0;
    float t_max = std::numeric_limits<float>::infinity();
};

}
