#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace umbral::tests {

/// The largest difference between two entries of the rotations (upper left 3 x 3); NaN differs by infinity.
inline double rotation_error(const glm::mat4& got, const glm::mat4& exact)
{
    double worst = 0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double error = std::abs(double{got[column][row]} - double{exact[column][row]});
            worst = std::isnan(error) ? INFINITY : std::max(worst, error);
        }
    }
    return worst;
}

/// The distance between the points that two view matrices move the world's origin to, in world units.
inline double translation_error(const glm::mat4& got, const glm::mat4& exact)
{
    return distance(glm::dvec4(got[3]), glm::dvec4(exact[3]));
}

}
