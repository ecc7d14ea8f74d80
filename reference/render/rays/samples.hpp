#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>
#include <umbral/core/random.hpp>

namespace umbral::render::rays {

/// A random permutation of 32-bit numbers that keeps what shares its leading bits together, and with it the evenness
/// of a sequence: Owen's scrambling. Based on: B. Burley. Practical Hash-based Owen Scrambling. JCGT 9(4), 2020.
[[nodiscard]] inline std::uint32_t scrambled(std::uint32_t value, std::uint32_t seed)
{
    const auto reversed = [](std::uint32_t bits) {
        bits = (bits >> 16U) | (bits << 16U);
        bits = ((bits & 0x00FF00FFU) << 8U) | ((bits & 0xFF00FF00U) >> 8U);
        bits = ((bits & 0x0F0F0F0FU) << 4U) | ((bits & 0xF0F0F0F0U) >> 4U);
        bits = ((bits & 0x33333333U) << 2U) | ((bits & 0xCCCCCCCCU) >> 2U);
        return ((bits & 0x55555555U) << 1U) | ((bits & 0xAAAAAAAAU) >> 1U);
    };
    std::uint32_t x = reversed(value);
    x ^= x * 0x3D20ADEAU;
    x += seed;
    x *= (seed >> 16U) | 1U;
    x ^= x * 0x05526C56U;
    x ^= x * 0x53A22864U;
    return reversed(x);
}

/// The point of this number in Sobol's sequence of the unit square, in 2^-32. Based on: I. Sobol. 1967.
[[nodiscard]] inline std::array<std::uint32_t, 2> sobol_point(std::uint32_t number)
{
    std::array<std::uint32_t, 2> point{};
    std::uint32_t first = 1U << 31U;
    for (std::uint32_t second = first; number != 0; number >>= 1U, first >>= 1U, second ^= second >> 1U)
        if ((number & 1U) != 0) {
            point[0] ^= first;
            point[1] ^= second;
        }
    return point;
}

/// Places in the unit square for the rays of one pixel: what they are follows from pixel and ray alone, so that a
/// picture is the same by any number of threads. Each square of a ray (pixel, lens, lights, bounces) is filled evenly
/// by the rays of a pixel; of two squares neither knows the other's order.
class Samples {
public:
    Samples(int x, int y, int ray, std::uint32_t scrambling = 0)
        : seeds_(((static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32U) | static_cast<std::uint32_t>(x)) ^
                 (scrambling * 0x9E3779B97F4A7C15U)),
          ray_(static_cast<std::uint32_t>(ray))
    {
    }

    [[nodiscard]] glm::vec2 next()
    {
        const std::uint32_t number = scrambled(ray_, seeds_.bits());
        const auto [x, y] = sobol_point(number);
        const std::uint32_t across = scrambled(x, seeds_.bits());
        return {unit(across), unit(scrambled(y, seeds_.bits()))};
    }

private:
    /// The leading 24 bits, which float holds: below 1.
    static float unit(std::uint32_t bits) { return static_cast<float>(bits >> 8U) * 0x1p-24F; }

    Random seeds_;
    std::uint32_t ray_;
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
