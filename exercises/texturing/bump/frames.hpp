#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <umbral/core/random.hpp>
#include <umbral/texturing/bump.hpp>

namespace umbral::texturing {

/// A normal and the tangents of a surface.
struct Frame {
    glm::vec3 n;
    Tangents tangents;
};

/// Tangents of lengths up to `stretch` times each other, at 30 degrees or more: every second time perpendicular to the
/// normal; else their plane leans by up to 40 degrees, as a triangle's does of a mesh whose normals are interpolated.
/// One normal in eight is an axis.
inline Frame random_frame(Random& random, float stretch)
{
    Frame frame;
    frame.n = random.unit_vector();
    if (const std::uint32_t axis = random.below(24); axis < 3) {
        frame.n = glm::vec3(0);
        frame.n[static_cast<int>(axis)] = random.below(2) == 0 ? 1.0F : -1.0F;
    }
    const glm::vec3 other = std::abs(frame.n.x) < 0.6F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 side = normalize(cross(frame.n, other));
    const float lean = random.below(2) == 0 ? 0 : random.uniform(-0.7F, 0.7F);
    const glm::vec3 front = std::cos(lean) * cross(frame.n, side) + std::sin(lean) * frame.n;
    const float angle = random.uniform(0, 6.28F);
    const float between = random.uniform(0.55F, 2.6F);
    const auto at = [&](float turned, float length) {
        return length * (std::cos(turned) * side + std::sin(turned) * front);
    };
    frame.tangents.u = at(angle, std::pow(stretch, random.uniform(-1, 1)));
    frame.tangents.v = at(angle + between, std::pow(stretch, random.uniform(-1, 1)));
    return frame;
}

}
