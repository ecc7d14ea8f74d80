#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <kit/shapes.hpp>
#include <umbral/lighting/light.hpp>

/// What the drivers of lighting share: the kit's shapes by their own names.
namespace umbral::lighting {

using namespace shapes;

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
