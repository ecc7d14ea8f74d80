#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <type_traits>
#include <umbral/core/random.hpp>
#include <utility>

namespace umbral {

/// A seed whose upper 16 bits are all set asks for varied inputs; no other seed has them.
struct VariedSeed {
    static constexpr std::uint64_t mark = std::uint64_t{0xFFFF} << 48U;

    [[nodiscard]] static constexpr bool is(std::uint64_t seed) { return (seed & mark) == mark; }
    /// The seed with the mark, and without it.
    [[nodiscard]] static constexpr std::uint64_t with_mark(std::uint64_t seed) { return seed | mark; }
    [[nodiscard]] static constexpr std::uint64_t without_mark(std::uint64_t seed)
    {
        return is(seed) ? seed & ~(std::uint64_t{1} << 63U) : seed;
    }
};

/// Coordinates turned by a multiple of a quarter turn about the axes, and made larger or smaller by a power of two.
/// Nothing is rounded, but numbers that leave float's range: what is degenerate, parallel or equal remains so, and
/// triangles keep their winding.
struct ExactMap {
    std::array<int, 3> axis{0, 1, 2};  ///< which of the given coordinates each new one is
    glm::vec3 factor{1};               ///< and what it is multiplied by: sign and scale

    [[nodiscard]] float scale() const { return std::abs(factor.x); }
    /// A place, or a difference of places.
    [[nodiscard]] glm::vec3 place(const glm::vec3& p) const
    {
        return factor * glm::vec3(p[axis[0]], p[axis[1]], p[axis[2]]);
    }
    /// Homogeneous coordinates: w remains.
    [[nodiscard]] glm::vec4 place(const glm::vec4& p) const { return {place(glm::vec3(p)), p.w}; }
    /// A direction, which keeps its length.
    [[nodiscard]] glm::vec3 direction(const glm::vec3& d) const { return place(d) / scale(); }
    /// What places are multiplied by.
    [[nodiscard]] glm::mat3 matrix() const { return {place({1, 0, 0}), place({0, 1, 0}), place({0, 0, 1})}; }
};

/// Makes inputs that are written down in a driver others than written, in runs that are asked for it; else each
/// function gives what it is given. At a desk inputs are as written. Graded work is asked with varied inputs as well:
/// answers that were written down for the inputs that everybody has are wrong there.
///
/// Varied inputs must be as hard as the written ones, and have other answers.
class Variation {
public:
    /// None.
    Variation() = default;
    /// What a run with this seed asks for.
    explicit Variation(std::uint64_t seed)
    {
        if (VariedSeed::is(seed)) random_.emplace(seed ^ 0x5851F42D4C957F2DU);
    }
    /// One that leaves most as it is written: one input in eight is another.
    [[nodiscard]] static Variation of_few(std::uint64_t seed)
    {
        Variation vary;
        vary.random_.emplace(seed);
        vary.leaves_most_ = true;
        return vary;
    }

    /// Are inputs to be others than written?
    explicit operator bool() const { return random_.has_value(); }

    /// Uniform within `spread` of `value`; of integers both ends can come. Of vectors each component is drawn.
    template <class T>
    requires std::is_arithmetic_v<T>
    [[nodiscard]] T near(T value, T spread)
    {
        Random* const drawn = random();
        if (drawn == nullptr) return value;
        if constexpr (std::is_integral_v<T>)
            return value - spread + static_cast<T>(drawn->below(static_cast<std::uint32_t>(2 * spread + 1)));
        else
            return static_cast<T>(value + spread * (2 * drawn->uniform_double() - 1));
    }
    template <glm::length_t L, class T>
    [[nodiscard]] glm::vec<L, T> near(glm::vec<L, T> value, T spread)
    {
        for (glm::length_t i = 0; i < L; ++i) value[i] = near(value[i], spread);
        return value;
    }

    /// `value` times a factor in [1 / `most`, `most`]; most >= 1. For what must stay positive, or keep its direction.
    template <class T>
    [[nodiscard]] T scaled(T value, float most)
    {
        Random* const drawn = random();
        return drawn != nullptr ? value * std::pow(most, drawn->uniform(-1, 1)) : value;
    }

    /// The written value, or one of the others: for settings of which there are a few.
    template <class T, std::size_t N>
    [[nodiscard]] T one_of(const T& written, const std::array<T, N>& others)
    {
        Random* const drawn = random();
        return drawn != nullptr ? others[drawn->below(static_cast<std::uint32_t>(N))] : written;
    }

    /// Another order of coordinates and another size: one of the 23 turns that move something, and a scale of
    /// 2^-`most_doublings` to 2^`most_doublings`.
    [[nodiscard]] ExactMap exact_map(int most_doublings = 2)
    {
        ExactMap map;
        Random* const drawn = random();
        if (drawn == nullptr) return map;
        const std::uint32_t turn = 1 + drawn->below(23);
        const std::uint32_t order = turn / 4;  // three even orders of the axes, then three odd ones
        const auto first = static_cast<int>(order % 3);
        map.axis = {first, (first + 1) % 3, (first + 2) % 3};
        const bool odd = order >= 3;
        if (odd) std::swap(map.axis[1], map.axis[2]);
        const std::uint32_t signs = turn % 4;
        map.factor = {(signs & 1U) != 0 ? -1.0F : 1.0F, (signs & 2U) != 0 ? -1.0F : 1.0F, 1.0F};
        map.factor.z = map.factor.x * map.factor.y * (odd ? -1.0F : 1.0F);
        map.factor *= std::ldexp(1.0F, near(0, most_doublings));
        return map;
    }

    /// The turn about `axis` (unit length) by an angle within `most` radians, as a matrix; else the identity.
    [[nodiscard]] glm::mat3 turn(const glm::vec3& axis, float most)
    {
        Random* const drawn = random();
        return drawn != nullptr ? glm::mat3(glm::rotate(glm::mat4(1), drawn->uniform(-most, most), axis))
                                : glm::mat3(1);
    }

    /// Random numbers for variations that are not here, or nothing: `if (Random* random = c.vary.random()) …`. They may
    /// be there once and not the next time.
    [[nodiscard]] Random* random()
    {
        if (!random_ || (leaves_most_ && random_->below(8) != 0)) return nullptr;
        return &*random_;
    }

private:
    std::optional<Random> random_;
    bool leaves_most_ = false;
};

}
