#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <umbral/core/random.hpp>

/// What the drivers of projections share: placements of a camera.
namespace umbral::projections {

/// Where a camera stands, what it looks at, and which way is up for it.
struct Placement {
    glm::vec3 eye;
    glm::vec3 target;
    glm::vec3 up;
};

/// The sine of the angle between the view and `up`, in double; 0 if either is zero.
inline double sine_to_up(const Placement& camera)
{
    const glm::dvec3 view = glm::dvec3(camera.eye) - glm::dvec3(camera.target);
    const double size = length(view) * length(glm::dvec3(camera.up));
    return size > 0 ? length(cross(glm::dvec3(camera.up), view)) / size : 0;
}

/// A camera within 10 of the origin that looks at a point within 2 of it, at least 1 away, its unit `up` at least 10
/// degrees off the view.
inline Placement random_placement(Random& random)
{
    for (;;) {
        const Placement camera{10.0F * random.in_cube(), 2.0F * random.in_cube(), random.unit_vector()};
        if (distance(camera.eye, camera.target) >= 1 && length(camera.eye) >= 1 && sine_to_up(camera) >= 0.17)
            return camera;
    }
}

/// Is one component of the direction clearly the smallest, so that rounding cannot decide which axis is most
/// perpendicular to it?
inline bool has_clear_smallest(const glm::vec3& direction)
{
    glm::vec3 size = abs(direction);
    std::sort(&size[0], &size[0] + 3);
    return size[1] >= 1.05F * size[0] + 0.01F * size[2];
}

/// The same camera with its `up` turned until the sine of its angle to the view is near `sine`, as close as floats
/// allow. `flipped`: to the other end of the view.
inline Placement with_up_near_view(Placement camera, double sine, bool flipped, Random& random)
{
    const glm::dvec3 view = normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
    glm::dvec3 aside(0);
    while (length(aside) < 0.1) aside = cross(view, glm::dvec3(random.unit_vector()));
    camera.up = glm::vec3((flipped ? -1.0 : 1.0) * std::sqrt(1 - sine * sine) * view + sine * normalize(aside));
    return camera;
}

}
