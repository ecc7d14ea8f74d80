#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace umbral {

/// Random numbers of few digits: inputs that somebody can work out by hand. All generators that draw from such numbers
/// give simpler results, and keep what they promise of them.
struct Grain {
    std::uint32_t bits = 32;    ///< of each number, the leading ones that are kept
    std::uint32_t smaller = 0;  ///< and how far all are moved towards 0: so many bits

    friend bool operator==(const Grain&, const Grain&) = default;
};

/// Which numbers of a sequence are replaced by others: one in a while, of short gaps and of long ones by turns. What is
/// made of the sequence then is what it was but for some numbers: the same triangle with another corner, the same
/// window elsewhere.
struct Slips {
    std::uint64_t seed = 0;   ///< 0: none
    std::uint32_t left = 0;   ///< numbers until the next one that is replaced
    std::uint32_t count = 0;  ///< of those that were
};

/// A small generator of random numbers that gives the same sequence on every machine.
///
/// The distributions of <random> are left to each standard library, so the same seed would give other test inputs
/// elsewhere. Based on: M. O'Neill. PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms. 2014
/// (pcg32).
class Random {
public:
    explicit Random(std::uint64_t seed, Grain grain = {})
        : increment_((seed << 1U) | 1U), mask_(~std::uint32_t{0} << (32U - grain.bits)), shift_(grain.smaller)
    {
        (void)bits();
        state_ += seed * 0x9E3779B97F4A7C15U + 0xBF58476D1CE4E5B9U;
        (void)bits();
    }

    /// The sequence of `seed`, but for the numbers that are replaced as `slips` (any number but 0) says.
    [[nodiscard]] static Random with_slips(std::uint64_t seed, std::uint64_t slips)
    {
        Random random(seed);
        random.slips_.seed = slips;
        return random;
    }

    /// 32 independent bits.
    [[nodiscard]] std::uint32_t bits()
    {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005U + increment_;
        std::uint32_t drawn = permuted(old);
        if (slips_.seed != 0) slip(drawn);
        return (drawn & mask_) >> shift_;
    }

    /// Uniform in [0, 1), a multiple of 2^-24, so that it is exact in float.
    [[nodiscard]] float uniform() { return static_cast<float>(bits() >> 8U) * 0x1p-24F; }

    /// Uniform in [low, high).
    [[nodiscard]] float uniform(float low, float high) { return low + (high - low) * uniform(); }

    /// Uniform in [0, 1) with 53 random bits.
    [[nodiscard]] double uniform_double()
    {
        const std::uint64_t high = bits();
        return static_cast<double>(((high << 32U) | bits()) >> 11U) * 0x1p-53;
    }

    /// Uniform in {0, …, count - 1}; count > 0.
    [[nodiscard]] std::uint32_t below(std::uint32_t count)
    {
        return static_cast<std::uint32_t>((std::uint64_t{bits()} * count) >> 32U);
    }

    /// Uniform in the box of side 2 round the origin.
    [[nodiscard]] glm::vec3 in_cube()
    {
        const float x = uniform(-1, 1);
        const float y = uniform(-1, 1);
        return {x, y, uniform(-1, 1)};
    }

    /// Uniform on the unit sphere (Archimedes: height and longitude are independent).
    [[nodiscard]] glm::vec3 unit_vector()
    {
        const float height = uniform(-1, 1);
        const float longitude = uniform(0, 6.2831853F);
        const float radius = std::sqrt(1 - height * height);
        return {radius * std::cos(longitude), radius * std::sin(longitude), height};
    }

private:
    [[nodiscard]] static std::uint32_t permuted(std::uint64_t state)
    {
        const auto folded = static_cast<std::uint32_t>(((state >> 18U) ^ state) >> 27U);
        const auto rotation = static_cast<std::uint32_t>(state >> 59U);
        return (folded >> rotation) | (folded << ((32U - rotation) & 31U));
    }

    void slip(std::uint32_t& drawn)
    {
        if (slips_.left-- > 0) return;
        slips_.seed = slips_.seed * 6364136223846793005U + 1442695040888963407U;
        const std::uint32_t other = permuted(slips_.seed);
        slips_.left = other % (slips_.count++ % 2 == 0 ? 48U : 12U);
        drawn = other;
    }

    std::uint64_t state_ = 0;
    std::uint64_t increment_;
    std::uint32_t mask_;
    std::uint32_t shift_;
    Slips slips_{};
};

}
