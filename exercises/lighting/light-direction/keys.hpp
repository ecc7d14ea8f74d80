#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <string_view>
#include <umbral/core/random.hpp>
#include <umbral/lighting/light_direction.hpp>
#include <umbral/record/variation.hpp>

/// What users of a light's keys do, and what cameras do meanwhile.
namespace umbral::lighting {

/// Keys as a user presses them: each one some times in a row, with others in between, of which nearly all mean nothing.
inline std::string random_session(Random& random, std::size_t length)
{
    constexpr std::string_view keys = "aAzZxXcCxaz";
    std::string session;
    while (session.size() < length) {
        const std::uint32_t which = random.below(keys.size() + 1);
        const char key = which < keys.size() ? keys[which] : static_cast<char>(' ' + random.below('~' - ' ' + 1));
        session.append(1 + random.below(6), key);
    }
    session.resize(length);
    return session;
}

/// Keys that are pressed in turn, from some angles on.
struct Session {
    LightAngles initial;
    float step = 0;
    std::string keys;
};

/// The session mirrored: of longitudes, latitudes or both, each is its negative, and keys that turn one way those that
/// turn the other way. As written unless inputs are to vary.
inline Session mirrored(Variation& vary, Session session)
{
    const int which = vary.one_of(0, std::array{1, 2, 3});
    if ((which & 1) != 0) session.initial.longitude_degrees = 0 - session.initial.longitude_degrees;
    if ((which & 2) != 0) session.initial.latitude_degrees = 0 - session.initial.latitude_degrees;
    for (char& key : session.keys)
        for (const std::string_view pair : {"xc", "XC", "az", "AZ"}) {
            const bool swaps = (which & (pair == "xc" || pair == "XC" ? 1 : 2)) != 0;
            const std::size_t at = pair.find(key);
            if (!swaps || at == std::string_view::npos) continue;
            key = pair[1 - at];
            break;
        }
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
