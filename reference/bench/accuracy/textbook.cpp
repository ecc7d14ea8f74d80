#include "textbook.hpp"

#include <cmath>

namespace umbral::bench {
namespace {

double square_root(double value) { return std::sqrt(value); }
float square_root(float value) { return std::sqrt(value); }
#ifdef __SIZEOF_FLOAT128__
// Newton's method doubles the right digits of the estimate: from 64 bits to all.
Wide square_root(Wide value)
{
    if (value <= 0) return 0;
    const Wide estimate = std::sqrt(static_cast<long double>(value));
    return (estimate + value / estimate) / 2;
}
#else
long double square_root(long double value) { return std::sqrt(value); }
#endif

/// (-b ± √(b² - 4ac)) / 2a, with the coefficients of |o + t d - c|² = r².
template <class Number>
std::optional<Number> school_formula(const Ray& ray, const raytracing::Sphere& sphere)
{
    Number a = 0;
    Number b = 0;
    Number c = -Number(sphere.radius) * Number(sphere.radius);
    for (int i = 0; i < 3; ++i) {
        const Number e = Number(ray.origin[i]) - Number(sphere.centre[i]);
        const Number d = ray.direction[i];
        a += d * d;
        b += 2 * d * e;
        c += e * e;
    }
    const Number discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const Number root = square_root(discriminant);
    for (const Number t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
        if (Number(ray.t_min) < t && t < Number(ray.t_max)) return t;
    return std::nullopt;
}

}

std::optional<float> intersect_school(const Ray& ray, const raytracing::Sphere& sphere)
{
    return school_formula<float>(ray, sphere);
}

std::optional<float> intersect_double(const Ray& ray, const raytracing::Sphere& sphere)
{
    const std::optional<double> t = school_formula<double>(ray, sphere);
    return t ? std::optional(static_cast<float>(*t)) : std::nullopt;
}

std::optional<Wide> intersect_exactly(const Ray& ray, const raytracing::Sphere& sphere)
{
    return school_formula<Wide>(ray, sphere);
}

double error_in_ulp(float got, Wide exact)
{
    const int exponent = std::max(std::ilogb(static_cast<double>(exact)), -126);
    const Wide difference = Wide(got) - exact;
    return std::ldexp(static_cast<double>(difference < 0 ? -difference : difference), 23 - exponent);
}

}
