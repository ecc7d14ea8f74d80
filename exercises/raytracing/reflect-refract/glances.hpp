#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <umbral/raytracing/reflect_refract.hpp>
#include <vector>

#include "../rays.hpp"

/// Questions about refraction of which it is known whether light comes through.
namespace umbral::raytracing {

/// One question put to a refraction.
struct SurfaceGlance {
    glm::vec3 v;
    glm::vec3 n;
    float outside;
    float inside;
};

/// A unit vector whose angle with the unit vector `axis` has this sine, on the side of `axis`.
inline glm::dvec3 leaning(const glm::dvec3& axis, double sine, Random& random)
{
    return std::sqrt(1 - sine * sine) * axis + sine * perpendicular_to(axis, random);
}

/// Two indices, the larger 1.1 to 2 times as large. Every third time they are no usual ones: the smaller is 1/4 to 4.
struct Indices {
    float rare;
    float dense;
};

inline Indices random_indices(Random& random)
{
    const float rare = random.below(3) == 0 ? std::exp2(random.uniform(-2, 2)) : random.uniform(1, 1.5F);
    return {rare, rare * random.uniform(1.1F, 2)};
}

/// A ray that arrives from the side of index `from`, with this sine of its angle with the normal. Which side that is,
/// the outside or the inside, is random; directions are unit but for rounding.
inline SurfaceGlance arriving(float from, float into, double sine, Random& random)
{
    const glm::vec3 n = random.unit_vector();
    const glm::dvec3 axis = normalize(glm::dvec3(n));
    if (random.below(2) == 0) return {glm::vec3(leaning(axis, sine, random)), n, from, into};
    return {glm::vec3(leaning(-axis, sine, random)), n, into, from};
}

/// A ray that goes on into a denser or, every second, into a rarer medium. cos² of the refracted angle is 0.04 or more.
inline SurfaceGlance refracted_glance(Random& random)
{
    const auto [rare, dense] = random_indices(random);
    const double sine = 0.98 * random.uniform_double();
    if (random.below(2) == 0) return arriving(rare, dense, sine, random);
    return arriving(dense, rare, sine * double{rare} / double{dense}, random);
}

/// A ray in the denser medium that is reflected totally, 2 % or more of the sines beyond the critical one.
inline SurfaceGlance total_glance(Random& random)
{
    const auto [rare, dense] = random_indices(random);
    const double critical = double{rare} / double{dense};
    const double beyond = 0.02 + 0.97 * random.uniform_double();
    return arriving(dense, rare, critical + (1 - critical) * beyond, random);
}

/// A ray in the denser medium for which Snell's law gives 1 - `cosine_squared` as the square of the refracted sine,
/// but for the rounding of v: it moves that by some 1e-7. A negative one means total reflection. `v` and `n` have
/// lengths from 1/4 to 4.
inline SurfaceGlance critical_glance(double cosine_squared, Random& random)
{
    const auto [rare, dense] = random_indices(random);
    const double sine = double{rare} / double{dense} * std::sqrt(1 - cosine_squared);
    SurfaceGlance glance = arriving(dense, rare, sine, random);
    glance.v *= std::exp2(random.uniform(-2, 2));
    glance.n *= std::exp2(random.uniform(-2, 2));
    return glance;
}

/// `count` rays on both sides of the critical angle: |cos²| of the refracted angle is 1e-6 to 1e-3.
inline std::vector<SurfaceGlance> critical_glances(Random& random, int count)
{
    std::vector<SurfaceGlance> glances;
    for (int i = 0; i < count; ++i) {
        const double size = std::pow(10.0, -6 + 3 * random.uniform_double());
        glances.push_back(critical_glance(random.below(3) == 0 ? -size : size, random));
    }
    return glances;
}

/// The whole number x below `modulus`, without a common divisor with `number`, for which their product leaves 1.
inline std::int64_t inverse(std::int64_t number, std::int64_t modulus)
{
    std::int64_t rest = modulus;
    std::int64_t x = 1;
    std::int64_t next = 0;
    while (number > 1) {
        const std::int64_t quotient = number / rest;
        number = std::exchange(rest, number % rest);
        x = std::exchange(next, x - quotient * next);
    }
    return (x + modulus) % modulus;
}

/// A ray nearer the critical angle than roundings of v let rays come: no number here is rounded. |cos²| of the
/// refracted angle is 1e-13 to 1e-9, and not the least of these where the indices differ by a factor of up to 16. Half
/// of the rays are reflected.
///
/// v leads along the longest side of a right triangle whose sides a, b, h are whole numbers; and so are the indices f
/// and i, for which f a = i h + e. Then sin² of the refracted angle is (f a)² / (i h)², which is 1 + 2 e / (i h).
inline SurfaceGlance exactly_critical_glance(Random& random)
{
    // All sides that have no common divisor are q² - p², 2 p q and q² + p².
    const std::int64_t q = 2048;
    const auto p = 2 * static_cast<std::int64_t>(std::exp2(random.uniform(5, 9.9F))) + 1;
    const bool odd = random.below(2) == 0;
    const std::int64_t a = odd ? q * q - p * p : 2 * p * q;
    const std::int64_t b = odd ? 2 * p * q : q * q - p * p;
    const std::int64_t h = q * q + p * p;
    const double ratio = static_cast<double>(h) / static_cast<double>(a);
    const double off = 1e-13 * std::max(std::pow(10.0, 4 * random.uniform_double()), ratio * ratio);
    const std::int64_t least = 1 << 23;
    const std::int64_t size = std::llround(off / 2 * static_cast<double>(least) * static_cast<double>(a)) + 1;
    const std::int64_t e = random.below(2) == 0 ? size : -size;
    const std::int64_t rest = ((e * inverse(a, h)) % h + h) % h;
    const std::int64_t f = rest + (least - rest + h - 1) / h * h;
    const float from = std::ldexp(static_cast<float>(f), -23);
    const float into = std::ldexp(static_cast<float>((f * a - e) / h), -23);

    const int axis = static_cast<int>(random.below(3));
    const int other = (axis + 1 + static_cast<int>(random.below(2))) % 3;
    glm::vec3 v(0);
    glm::vec3 n(0);
    v[axis] = std::ldexp(random.below(2) == 0 ? static_cast<float>(b) : -static_cast<float>(b), -22);
    v[other] = std::ldexp(random.below(2) == 0 ? static_cast<float>(a) : -static_cast<float>(a), -22);
    n[axis] = std::exp2(random.uniform(-2, 2)) * (random.below(2) == 0 ? 1.0F : -1.0F);
    const bool enters = v[axis] * n[axis] > 0;
    return {v, n, enters ? from : into, enters ? into : from};
}

/// A ray that nearly runs along a surface that is turned any way: the sine of its angle with the surface is 1e-10 to
/// 1e-6, but for the rounding of v, which moves it by some 1e-8 to either side. `v` is hardly longer or shorter than
/// unit.
inline SurfaceGlance grazing_glance(Random& random)
{
    const auto [rare, dense] = random_indices(random);
    const glm::vec3 n = random.unit_vector();
    const double aside = std::pow(10.0, -10 + 4 * random.uniform_double()) * (random.below(2) == 0 ? 1 : -1);
    const double longer = 1 + 1e-6 * (random.uniform_double() - 0.5);
    const glm::dvec3 axis = normalize(glm::dvec3(n));
    const glm::vec3 v(longer * (aside * axis + perpendicular_to(axis, random)));
    const bool swapped = random.below(2) == 0;
    return {v, n, swapped ? dense : rare, swapped ? rare : dense};
}

/// Two media for a critical angle: hardly different ones, ones that have little in common, or ones with indices of
/// any size that hardly differ.
inline Indices hard_indices(Random& random, int i)
{
    const float dense = i % 3 == 2 ? std::pow(10.0F, random.uniform(-9, 9)) : random.uniform(1, 4);
    if (i % 3 == 1) return {dense * std::pow(10.0F, random.uniform(-7, -1)), dense};
    const float hardly_less = dense * (1 - std::exp2(random.uniform(-22, -7)));
    return {std::min(hardly_less, std::nextafter(dense, 0.0F)), dense};
}

}
