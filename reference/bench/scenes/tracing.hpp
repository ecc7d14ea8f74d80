#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace umbral::bench::scenes {

/// What is estimated by random samples.
enum class Estimate {
    soft_shadow,        ///< light from a square lamp
    ambient_occlusion,  ///< how much of the sky is seen
    interreflection,    ///< sky light, bounced up to four times
    depth_of_field,     ///< a lens, and pixels with an extent
};

struct TracedBall {
    glm::vec3 centre{0};
    float radius = 1;
    glm::vec3 color{0.8F};
};

/// Balls on the plane y = 0, seen by a pinhole or a lens.
struct Traced {
    Estimate estimate = Estimate::soft_shadow;
    int width = 256;
    int height = 256;
    int samples = 16;  ///< a pixel; a square number
    std::uint64_t seed = 1;
    glm::vec3 eye{0, 2, 6};
    glm::vec3 target{0, 0.7F, 0};
    float fovy_degrees = 40;
    float aperture = 0;       ///< radius of the lens, focused on the target
    glm::vec3 lamp{0, 4, 0};  ///< the middle of a square lamp that faces down
    float lamp_half = 0.8F;   ///< half its side
    float lamp_power = 9;     ///< its radiance
    std::vector<TracedBall> balls;
};

}
