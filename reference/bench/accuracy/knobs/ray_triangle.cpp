#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <umbral/core/random.hpp>
#include <umbral/raytracing/triangle.hpp>

#include "../study.hpp"

namespace umbral::bench {
namespace {

using raytracing::Triangle;

/// Möller and Trumbore's test as printed, in one width of numbers; `slack` widens the triangle.
template <class Number>
std::optional<float> moeller_trumbore(const Ray& ray, const Triangle& triangle, Number slack)
{
    using Vector = glm::vec<3, Number>;
    const Vector a = Vector(triangle.v1) - Vector(triangle.v0);
    const Vector b = Vector(triangle.v2) - Vector(triangle.v0);
    const Vector p = cross(Vector(ray.direction), b);
    const Number determinant = dot(a, p);
    if (determinant == 0) return std::nullopt;
    const Vector s = Vector(ray.origin) - Vector(triangle.v0);
    const Number u = dot(s, p) / determinant;
    const Vector q = cross(s, a);
    const Number v = dot(Vector(ray.direction), q) / determinant;
    if (u < -slack || v < -slack || u + v > 1 + slack) return std::nullopt;
    return static_cast<float>(dot(b, q) / determinant);
}

/// Two triangles on both sides of an edge, and a ray at a point of that edge.
struct Seam {
    Triangle left;
    Triangle right;
    Ray ray;
};

Seam random_seam(Random& random)
{
    const glm::vec3 a = random.in_cube();
    const glm::vec3 b = random.in_cube();
    const glm::vec3 side = normalize(cross(b - a, random.unit_vector()));
    const glm::vec3 aim = mix(a, b, random.uniform(0.05F, 0.95F));
    const glm::vec3 origin = aim + 10.0F * normalize(cross(b - a, side)) + random.in_cube();
    return {{a, b, aim + side}, {b, a, aim - side}, {origin, normalize(aim - origin)}};
}

/// A ray that passes the edge by some millionths, on the side of the right triangle; is it outside the left one?
bool is_outside(const Seam& seam, Ray& ray)
{
    const glm::vec3 away = normalize(seam.right.v2 - mix(seam.left.v0, seam.left.v1, 0.5F));
    const glm::vec3 at = seam.ray.origin + 10.0F * seam.ray.direction + 3e-6F * away;
    ray = {seam.ray.origin, at - seam.ray.origin};
    return !moeller_trumbore<long double>(ray, seam.left, 0);
}

}

Knob measure_ray_triangle(Means& means)
{
    constexpr std::uint64_t seed = 21;
    const int count = means.quick ? 20'000 : 500'000;
    Study study = study_of(
        "ray-triangle", "Rays along a mesh's seams",
        fmt::format("{} rays aimed at the common edge of two triangles: those that hit neither slip "
                    "through the mesh. And rays some millionths beside it: those that the wrong "
                    "triangle claims, against 64 bits of mantissa. Seed {}.",
                    count, seed),
        "ns per test", {{"slipped", "rays that slip through", "%"}, {"claimed", "rays beside, claimed wrongly", "%"}});
    using Test = std::optional<float> (*)(const Ray&, const Triangle&);
    const std::vector<std::pair<std::string, Test>> tests = {
        {"float", [](const Ray& ray, const Triangle& one) { return moeller_trumbore<float>(ray, one, 0); }},
        {"float, slack 1e-5", [](const Ray& ray, const Triangle& one) { return moeller_trumbore(ray, one, 1e-5F); }},
        {"double", [](const Ray& ray, const Triangle& one) { return moeller_trumbore<double>(ray, one, 0); }},
        {"watertight", [](const Ray& ray, const Triangle& one) -> std::optional<float> {
             const auto hit = raytracing::intersect(ray, one);
             return hit ? std::optional(hit->t) : std::nullopt;
         }}};
    for (const auto& [name, test] : tests) {
        Random random(seed);
        int slipped = 0;
        int beside = 0;
        int claimed = 0;
        std::vector<Seam> timed;
        for (int i = 0; i < count; ++i) {
            const Seam seam = random_seam(random);
            slipped += !test(seam.ray, seam.left) && !test(seam.ray, seam.right) ? 1 : 0;
            Ray ray;
            if (is_outside(seam, ray)) {
                ++beside;
                claimed += test(ray, seam.left) ? 1 : 0;
            }
            if (i < 1000) timed.push_back(seam);
        }
        study.trials.push_back(
            {name,
             "",
             0,
             {{"slipped", 100.0 * slipped / count}, {"claimed", 100.0 * claimed / std::max(beside, 1)}},
             1000,
             [timed, test = test] {
                 for (const Seam& seam : timed) keep(test(seam.ray, seam.left));
             }});
    }
    return finish(std::move(study), means);
}

}
