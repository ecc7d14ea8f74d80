#include <algorithm>
#include <cmath>

#include "../row.hpp"

namespace stability {
namespace {

using umbral::Random;

// A ray from `away` radii whose target is a point `aim` of the ball, at most 0.9 radii off its middle.
void ray_at_ball(std::vector<float>& x, Random& random)
{
    x[9] = between_powers(random, -3, 3);
    const float away = x[9] * (2 + between_powers(random, -1, 5.5F));
    const glm::vec3 side = random.unit_vector();
    const glm::vec3 aim = random.unit_vector() * 0.5F * x[9];
    const float speed = between_powers(random, -4, 4) / away;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        x[6 + at] = random.uniform(-1, 1) * x[9];
        x[at] = x[6 + at] + side[i] * away;
        x[3 + at] = (x[6 + at] + aim[i] - x[at]) * speed;
    }
}
// The same at a disc, whose normal encloses 0.1 or more with the ray and its origin's direction.
void ray_at_disc(std::vector<float>& x, Random& random)
{
    x[12] = between_powers(random, -3, 3);
    const glm::vec3 normal = random.unit_vector();
    const glm::vec3 across = glm::cross(normal, random.unit_vector());
    const float length = between_powers(random, -4, 4);
    const float away = x[12] * between_powers(random, -1, 3);
    const float speed = between_powers(random, -4, 4) / away;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        x[6 + at] = random.uniform(-1, 1) * x[12];
        x[9 + at] = normal[i] * length;
        x[at] = x[6 + at] + (normal[i] + across[i]) * away;
        x[3 + at] = (x[6 + at] + across[i] * 0.7F * x[12] - x[at]) * speed;
    }
}
// A ray through the inside of a triangle, at a sine of 0.05 or more.
void ray_at_triangle(std::vector<float>& x, Random& random)
{
    const float size = between_powers(random, -3, 3);
    const float far = between_powers(random, -1, 3);
    const float thin = between_powers(random, -3, 0);
    const glm::vec3 u = random.unit_vector();
    const glm::vec3 n = glm::normalize(glm::cross(u, random.unit_vector()));
    const glm::vec3 v = glm::cross(n, u) * thin + u * random.uniform();
    const float speed = between_powers(random, -4, 4);
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        x[6 + at] = random.uniform(-1, 1) * size;
        x[9 + at] = x[6 + at] + u[i] * size;
        x[12 + at] = x[6 + at] + v[i] * size;
        x[at] = x[6 + at] + (n[i] + u[i] * 0.5F) * size * far;
        x[3 + at] = (x[6 + at] + (u[i] + v[i]) * size / 3 - x[at]) * speed;
    }
}
void near_cylinder(std::vector<float>& x, Random& random)
{
    const float angle = random.uniform(0, 7);
    const float radius = random.below(2) == 0 ? 1 + between_powers(random, -7, 0) : between_powers(random, -8, 8);
    x[0] = radius * std::cos(angle);
    x[2] = radius * std::sin(angle);
}
void near_cone(std::vector<float>& x, Random& random)
{
    const float angle = random.uniform(0, 7);
    x[1] = random.uniform(-1, 1) * between_powers(random, -8, 8);
    x[0] = (1 - x[1]) * std::cos(angle) * (1 + between_powers(random, -8, 0));
    x[2] = (1 - x[1]) * std::sin(angle);
}
void unit_pair(std::vector<float>& x, Random&)
{
    make_unit(x, 0);
    make_unit(x, 3);
}
void indices(std::vector<float>& x, Random& random)
{
    x[0] = between_powers(random, -1, 1);
    x[1] = x[0] * (random.below(2) == 0 ? 1 - between_powers(random, -7, -1) : random.uniform(0.001F, 0.999F));
}

double cylinder_slack(Numbers x) { return 0x1p-23 * std::max(1.0, double{x[0]} * x[0] + double{x[2]} * x[2]); }
double cone_slack(Numbers x)
{
    const double up = 1 - double{x[1]};
    return 0x1p-23 * std::max(up * up, double{x[0]} * x[0] + double{x[2]} * x[2]);
}

Answer naive_sphere(Numbers x)
{
    const glm::vec3 o = v_at(x, 0) - v_at(x, 6);
    const glm::vec3 d = v_at(x, 3);
    const float a = glm::dot(d, d);
    const float b = 2 * glm::dot(d, o);
    const float c = glm::dot(o, o) - x[9] * x[9];
    const float square = b * b - 4 * a * c;
    return square < 0 ? Answer{} : numbers((-b - std::sqrt(square)) / (2 * a));
}
Answer naive_disc(Numbers x)
{
    const glm::vec3 n = v_at(x, 9);
    const float t = glm::dot(v_at(x, 6) - v_at(x, 0), n) / glm::dot(v_at(x, 3), n);
    return glm::length(v_at(x, 0) + t * v_at(x, 3) - v_at(x, 6)) < x[12] ? numbers(t) : Answer{};
}
Answer naive_triangle(Numbers x)
{
    const glm::vec3 e1 = v_at(x, 9) - v_at(x, 6);
    const glm::vec3 e2 = v_at(x, 12) - v_at(x, 6);
    const glm::vec3 p = glm::cross(v_at(x, 3), e2);
    const float volume = glm::dot(e1, p);
    if (std::abs(volume) < 1e-12F) return {};
    const glm::vec3 s = v_at(x, 0) - v_at(x, 6);
    const glm::vec3 q = glm::cross(s, e1);
    return numbers(glm::dot(e2, q) / volume);
}
Answer naive_cylinder(Numbers x) { return numbers(x[0] * x[0] + x[2] * x[2] - 1); }
Answer naive_cone(Numbers x) { return numbers(x[0] * x[0] + x[2] * x[2] - (1 - x[1]) * (1 - x[1])); }
Answer naive_mirror(Numbers x) { return numbers(2 * glm::dot(v_at(x, 0), v_at(x, 3)) * v_at(x, 3) - v_at(x, 0)); }
Answer naive_critical(Numbers x) { return numbers(std::asin(x[1] / x[0])); }

}

std::vector<Row> raytracing_rows()
{
    using enum Unit;
    return {
        {"raytracing::intersect sphere", ulps, 24, "header: 24 ulp unless it grazes or starts near", naive_sphere,
         ray_at_ball},
        {"raytracing::intersect disc", ulps, 1, "header: an ulp", naive_disc, ray_at_disc},
        {"raytracing::intersect triangle", ulps, 1, "header: an ulp", naive_triangle, ray_at_triangle},
        {"raytracing::unit_cylinder_field", ulps, 0, "header: an ulp of the larger of x² + z² and 1", naive_cylinder,
         near_cylinder, cylinder_slack},
        {"raytracing::unit_cone_field", ulps, 0, "header: an ulp of the larger square", naive_cone, near_cone,
         cone_slack},
        {"raytracing::mirrored_direction", absolute, 1e-7, "header: within 1e-7", naive_mirror, unit_pair},
        {"raytracing::critical_angle", ulps, 1, "header: an ulp", naive_critical, indices},
    };
}

}
