#pragma once

#include <optional>
#include <umbral/raytracing/intersect.hpp>

/// The school's way to meet a sphere with a ray, in three widths of numbers: the quadratic formula, as every textbook
/// prints it.
namespace umbral::bench {

/// All in float.
[[nodiscard]] std::optional<float> intersect_school(const Ray& ray, const raytracing::Sphere& sphere);

/// All in double, rounded to float at the end.
[[nodiscard]] std::optional<float> intersect_double(const Ray& ray, const raytracing::Sphere& sphere);

#ifdef __SIZEOF_FLOAT128__
using Wide = __float128;
#else
using Wide = long double;  // 113 bits on arm64
#endif

/// The truth with 113 bits, not rounded: what errors are counted from.
[[nodiscard]] std::optional<Wide> intersect_exactly(const Ray& ray, const raytracing::Sphere& sphere);

/// |got - exact| in units in the last place of a float of the size of `exact`.
[[nodiscard]] double error_in_ulp(float got, Wide exact);

}
