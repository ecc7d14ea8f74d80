#pragma once

#include <glm/glm.hpp>

namespace umbral::raytracing {

/// A lamp with an area: the points corner + a * edge_a + b * edge_b with a, b in [0, 1], a parallelogram.
///
/// It shines to one side, the one that cross(edge_a, edge_b) points to, equally bright from all directions there: a
/// point of it that is seen has the radiance `radiance`. It is dark from behind. The edges are not parallel.
struct AreaLamp {
    glm::vec3 corner;
    glm::vec3 edge_a;
    glm::vec3 edge_b;
    glm::vec3 radiance;
};

}
