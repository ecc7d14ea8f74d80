// Based on: S. Woop, C. Benthin, I. Wald. Watertight Ray/Triangle Intersection. Journal of Computer Graphics Techniques
// 2(1), 2013; and C.-P. Jeannerod, N. Louvet, J.-M. Muller. Further Analysis of Kahan's Algorithm for the Accurate
// Computation of 2 x 2 Determinants. Mathematics of Computation 82, 2013.

#include <cmath>
#include <umbral/raytracing/triangle.hpp>

namespace umbral::raytracing {
namespace {

/// The axis along which a vector is longest.
int longest_axis(const glm::dvec3& v)
{
    const glm::dvec3 size = abs(v);
    if (size.x > size.y) return size.x > size.z ? 0 : 2;
    return size.y > size.z ? 1 : 2;
}

/// A corner as the ray sees it: its place across the ray, which follows from nothing but ray and corner, and its t.
struct Seen {
    glm::dvec2 place;
    double t;
};

/// Twice the area of the triangle of the ray and two places. Its sign is exact, so two triangles that share an edge see
/// the ray on the same side of it.
double area(const glm::dvec2& p, const glm::dvec2& q)
{
    const double product = p.y * q.x;
    const double rounded_off = std::fma(-p.y, q.x, product);
    return std::fma(p.x, q.y, -product) + rounded_off;
}

}

std::optional<TriangleHit> intersect(const Ray& ray, const Triangle& triangle)
{
    // Shear space so that the ray runs along an axis.
    const glm::dvec3 direction(ray.direction);
    const int along = longest_axis(direction);
    const int x = (along + 1) % 3;
    const int y = (along + 2) % 3;
    const auto seen = [&](const glm::vec3& corner) {
        const glm::dvec3 p = glm::dvec3(corner) - glm::dvec3(ray.origin);
        const double t = p[along] / direction[along];
        return Seen{{p[x] - t * direction[x], p[y] - t * direction[y]}, t};
    };
    const Seen s0 = seen(triangle.v0);
    const Seen s1 = seen(triangle.v1);
    const Seen s2 = seen(triangle.v2);

    // The ray passes inside where it lies on the same side of all three edges, or on them.
    const double w0 = area(s1.place, s2.place);
    const double w1 = area(s2.place, s0.place);
    const double w2 = area(s0.place, s1.place);
    if ((w0 < 0 || w1 < 0 || w2 < 0) && (w0 > 0 || w1 > 0 || w2 > 0)) return std::nullopt;
    const double sum = w0 + w1 + w2;
    if (sum == 0) return std::nullopt;

    const auto t = static_cast<float>((w0 * s0.t + w1 * s1.t + w2 * s2.t) / sum);
    if (!(ray.t_min < t && t < ray.t_max)) return std::nullopt;
    return TriangleHit{t, static_cast<float>(w1 / sum), static_cast<float>(w2 / sum)};
}

}
