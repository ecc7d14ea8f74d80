#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>

namespace umbral {

/// The model matrix of a thing that is turned, stretched by 0.5 to 1.7, and moved by up to 3 along each axis.
inline glm::mat4 random_placement(Random& random)
{
    glm::mat4 matrix = glm::translate(glm::mat4(1), 3.0F * random.in_cube());
    matrix = glm::rotate(matrix, random.uniform(0, 6.28F), random.unit_vector());
    return glm::scale(matrix, glm::vec3(1.1F) + 0.6F * random.in_cube());
}

}
