#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <umbral/core/random.hpp>

namespace umbral::render::rays {

/// Places in the unit square for the rays of one pixel: what they are follows from pixel and ray alone, so that a
/// picture is the same by any number of threads. The first few squares of a ray (lens, lights, first bounce) are filled
/// evenly by the rays of a pixel, by the sequence R2 from a place that chance chooses; those after them by chance.
/// Based on: M. Roberts. The Unreasonable Effectiveness of Quasirandom Sequences. 2018; R. Cranley, T. Patterson.
/// Randomization of Number Theoretic Methods for Multiple Integration. 1976.
class Samples {
public:
    Samples(int x, int y, int ray)
        : starts_((static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32U) | static_cast<std::uint32_t>(x)),
          chance_(starts_.bits() + (static_cast<std::uint64_t>(ray) << 32U)),
          ray_(ray)
    {
    }

    [[nodiscard]] glm::vec2 next()
    {
        constexpr int even = 24;
        if (drawn_++ >= even) return {chance_.uniform(), chance_.uniform()};
        const double x = starts_.uniform_double() + ray_ * 0.75487766624669276;
        const double y = starts_.uniform_double() + ray_ * 0.56984029099805327;
        return {below_one(x - std::floor(x)), below_one(y - std::floor(y))};
    }

private:
    static float below_one(double value) { return std::min(static_cast<float>(value), 0x1.fffffep-1F); }

    Random starts_;
    Random chance_;
    int ray_;
    int drawn_ = 0;
};

/// The disc of radius 1, equal areas from equal areas. Based on: P. Shirley, K. Chiu. A Low Distortion Map Between Disk
/// and Square. 1997.
[[nodiscard]] inline glm::vec2 on_disc(const glm::vec2& square)
{
    const glm::vec2 p = 2.0F * square - glm::vec2(1);
    if (p == glm::vec2(0)) return p;
    constexpr float quarter = std::numbers::pi_v<float> / 4;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const float radius = wide ? p.x : p.y;
    const float angle = wide ? quarter * (p.y / p.x) : 2 * quarter - quarter * (p.x / p.y);
    return radius * glm::vec2(std::cos(angle), std::sin(angle));
}

/// Two unit vectors that are perpendicular to the unit vector n, and to each other. Based on: T. Duff and others.
/// Building an Orthonormal Basis, Revisited. 2017.
[[nodiscard]] inline std::array<glm::vec3, 2> across(const glm::vec3& n)
{
    const float sign = std::copysign(1.0F, n.z);
    const float a = -1 / (sign + n.z);
    const float b = n.x * n.y * a;
    return {glm::vec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x), glm::vec3(b, sign + n.y * n.y * a, -n.y)};
}

}
