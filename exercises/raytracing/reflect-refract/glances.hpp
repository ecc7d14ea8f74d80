#pragma once

#include <algorithm>
#include <cmath>
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

}
