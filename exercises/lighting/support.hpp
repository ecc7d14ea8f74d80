#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <kit/shapes.hpp>

/// What the drivers of lighting share: lights, materials, and the kit's shapes by their own names.
namespace umbral::lighting {

using namespace shapes;

/// A source of light in eye coordinates: w = 1 a place, w = 0 a direction towards the light, of any length.
struct Light {
    glm::vec4 position;
    glm::vec3 color;
};

struct Material {
    glm::vec3 emission{0};
    glm::vec3 ambient{0};
    glm::vec3 diffuse{0};
    glm::vec3 specular{0};
    float shininess = 1;
};

/// The square [-1, 1]² in x and z with waves of that height, its outside upwards.
inline Shape waves(int cells, float height)
{
    return surface(cells, cells, [&](float u, float v) {
        const float x = 2 * u - 1;
        const float z = 1 - 2 * v;
        return glm::vec3(x, height * std::sin(7 * x + 2 * z) * std::cos(6 * z - x), z);
    });
}

}
