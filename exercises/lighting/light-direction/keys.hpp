#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <umbral/core/random.hpp>
#include <umbral/lighting/light_direction.hpp>

/// What users of a light's keys do, and what cameras do meanwhile.
namespace umbral::lighting {

/// Keys as a user presses them: each one some times in a row, with others in between that mean nothing.
inline std::string random_session(Random& random, std::size_t length)
{
    constexpr char keys[] = "aAzZxXcCxazQ";
    std::string session;
    while (session.size() < length) session.append(1 + random.below(6), keys[random.below(sizeof keys - 1)]);
    session.resize(length);
    return session;
}

/// A rigid view matrix: any rotation, and a translation that is not small.
inline glm::mat4 random_view(Random& random)
{
    const glm::vec3 axis = random.unit_vector();
    const glm::mat4 turned = glm::rotate(glm::mat4(1), random.uniform(0.3F, 6), axis);
    return glm::translate(glm::mat4(1), 8.0F * random.in_cube()) * turned;
}

}
