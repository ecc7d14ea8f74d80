#pragma once

#include <glm/glm.hpp>
#include <umbral/core/random.hpp>

/// Directions that random ones never have.
namespace umbral {

/// A unit vector in a plane of two of the world's axes, which are those but `missing` (0 to 2); one time in three along
/// one of them.
inline glm::vec3 axial_vector(Random& random, int missing)
{
    glm::vec3 vector = random.unit_vector();
    vector[missing] = 0;
    if (random.below(3) == 0) vector[(missing + 1) % 3] = 0;
    return normalize(vector);
}

}
