// Based on: A. S. Glassner (editor). An Introduction to Ray Tracing. 1989, chapter 2, 3.3: quadrics; and for roots
// without cancellation G. E. Forsythe. Pitfalls in Computation, or Why a Math Book Isn't Enough. 1970.

#include <array>
#include <cmath>
#include <umbral/raytracing/cylinder_cone.hpp>
#include <utility>

namespace umbral::raytracing {
namespace {

double squared(double x) { return x * x; }

/// a t² + 2 half_b t + c = 0. The discriminant half_b² - a c comes with it: subtracted here, it would lose what two
/// large products have in common.
struct Quadratic {
    double a;
    double half_b;
    double c;
    double discriminant;
};

/// Its roots, the smaller first; infinite or NaN where there is none.
std::array<double, 2> roots(const Quadratic& equation)
{
    // Both terms of the sum have the same sign, so none of the digits is lost; the product of the roots is c / a. If a
    // is 0, the equation is linear, and the second form is its root.
    const double sum = equation.half_b + std::copysign(std::sqrt(equation.discriminant), equation.half_b);
    std::array<double, 2> result{-sum / equation.a, -equation.c / sum};
    if (result[1] < result[0]) std::swap(result[0], result[1]);
    return result;
}

/// The first root that counts: within the ray's interval, and at a height where there is a surface.
std::optional<float> first_on_surface(const Ray& ray, const Quadratic& equation)
{
    for (const double t : roots(equation)) {
        const double height = double{ray.origin.y} + t * double{ray.direction.y};
        const auto rounded = static_cast<float>(t);
        if (height >= 0 && height <= 1 && ray.t_min < rounded && rounded < ray.t_max) return rounded;
    }
    return std::nullopt;
}

}

float unit_cylinder_field(const glm::vec3& p) { return static_cast<float>(squared(p.x) + squared(p.z) - 1); }

float unit_cone_field(const glm::vec3& p)
{
    return static_cast<float>(squared(p.x) + squared(p.z) - squared(1 - double{p.y}));
}

std::optional<float> intersect_unit_cylinder(const Ray& ray)
{
    const glm::dvec3 o(ray.origin);
    const glm::dvec3 d(ray.direction);
    const double a = d.x * d.x + d.z * d.z;
    const double about_axis = o.x * d.z - o.z * d.x;
    return first_on_surface(ray, {.a = a,
                                  .half_b = o.x * d.x + o.z * d.z,
                                  .c = o.x * o.x + o.z * o.z - 1,
                                  .discriminant = a - about_axis * about_axis});
}

std::optional<float> intersect_unit_cone(const Ray& ray)
{
    const glm::dvec3 o(ray.origin);
    const glm::dvec3 d(ray.direction);
    // With the apex as origin and s as the depth below it, the cone is x² + z² = s², and half_b² - a c a sum of three
    // squares of 2 x 2 determinants (Lagrange's identity, with the signs of this form).
    const double s = 1 - o.y;
    const double ds = -d.y;
    return first_on_surface(ray, {.a = d.x * d.x + d.z * d.z - ds * ds,
                                  .half_b = o.x * d.x + o.z * d.z - s * ds,
                                  .c = o.x * o.x + o.z * o.z - s * s,
                                  .discriminant = squared(o.x * ds - s * d.x) + squared(o.z * ds - s * d.z) -
                                                  squared(o.x * d.z - o.z * d.x)});
}

}
