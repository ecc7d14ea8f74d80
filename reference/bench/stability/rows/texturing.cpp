#include <algorithm>
#include <cmath>
#include <numbers>

#include "../row.hpp"

namespace stability {
namespace {

using umbral::Random;

constexpr float pi = std::numbers::pi_v<float>;

// Axes along those of the world, in any order and with any signs: unit and perpendicular exactly.
void plane(std::vector<float>& x, Random& random)
{
    const std::size_t first = random.below(3);
    const std::size_t second = (first + 1 + random.below(2)) % 3;
    for (std::size_t i = 0; i < 3; ++i) {
        x[6 + i] = i == first ? 1.0F : 0.0F;
        x[9 + i] = i == second ? -1.0F : 0.0F;
    }
}
void height(std::vector<float>& x, Random& random)
{
    x[3] = random.uniform(-1, 1) * between_powers(random, -4, 4);
    x[4] = x[3] + between_powers(random, -4, 4);
    x[1] = x[3] + (x[4] - x[3]) * random.uniform();
}
void unit_normal(std::vector<float>& x, Random&) { make_unit(x, 3); }
void place(std::vector<float>& x, Random& random)
{
    x[0] = random.uniform();
    x[1] = random.below(2) == 0 ? between_powers(random, -8, 0) : random.uniform();
}
void ball_place(std::vector<float>& x, Random& random)
{
    x[0] = 0.5F + random.uniform(-0.35F, 0.35F);
    x[1] = 0.5F + random.uniform(-0.35F, 0.35F);
}
void positive(std::vector<float>& x, Random& random)
{
    x[0] = between_powers(random, -8, 8);
    x[1] = between_powers(random, -8, 8);
}
void bumps(std::vector<float>& x, Random& random)
{
    const glm::vec3 n = random.unit_vector();
    const glm::vec3 u = glm::normalize(glm::cross(n, random.unit_vector()));
    const glm::vec3 v = glm::cross(n, u);
    const float long_u = between_powers(random, -4, 4);
    const float long_v = long_u * between_powers(random, -1, 1);
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        x[at] = n[i];
        x[3 + at] = u[i] * long_u;
        x[6 + at] = (v[i] + u[i] * 0.3F) * long_v;
    }
    x[9] = long_u * random.uniform(-1, 1) * between_powers(random, -4, 4);
    x[10] = long_v * random.uniform(-1, 1) * between_powers(random, -4, 4);
}

double plane_slack(Numbers x)
{
    const double distance = std::hypot(double{x[0]} - x[3], double{x[1]} - x[4], double{x[2]} - x[5]);
    return 4 * 0x1p-23 * distance;
}
double mirror_slack(Numbers x) { return 4 * 0x1p-23 * std::hypot(double{x[0]}, double{x[1]}, double{x[2]}); }

Answer naive_planar(Numbers x)
{
    const glm::vec3 p = v_at(x, 0);
    const glm::vec3 o = v_at(x, 3);
    return {glm::dot(p, v_at(x, 6)) - glm::dot(o, v_at(x, 6)), glm::dot(p, v_at(x, 9)) - glm::dot(o, v_at(x, 9))};
}
Answer naive_spherical(Numbers x)
{
    return {0.5F + std::atan2(x[2], x[0]) / (2 * pi), 0.5F + std::asin(x[1] / glm::length(v_at(x, 0))) / pi};
}
Answer naive_cylindrical(Numbers x)
{
    return {0.5F + std::atan2(x[2], x[0]) / (2 * pi), (x[1] - x[3]) / (x[4] - x[3])};
}
Answer naive_mirror(Numbers x) { return numbers(2 * glm::dot(v_at(x, 0), v_at(x, 3)) * v_at(x, 3) - v_at(x, 0)); }
Answer naive_panorama(Numbers x)
{
    return {0.5F + std::atan2(x[0], -x[2]) / (2 * pi), 0.5F + std::asin(x[1] / glm::length(v_at(x, 0))) / pi};
}
Answer naive_sphere_place(Numbers x)
{
    const glm::vec3 r = glm::normalize(v_at(x, 0));
    const float m = 2 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
    return {r.x / m + 0.5F, r.y / m + 0.5F};
}
Answer naive_level(Numbers x) { return numbers(std::max(0.0F, std::log2(x[0] / x[1]))); }
Answer naive_step(Numbers x)
{
    const float longer = std::max(glm::length(u_at(x, 0)), glm::length(u_at(x, 2)));
    return numbers(std::max(0.0F, std::log2(1024 * longer)));
}
Answer naive_bump(Numbers x)
{
    const glm::vec3 n = v_at(x, 0);
    return numbers(glm::normalize(glm::cross(v_at(x, 3) + x[9] * n, v_at(x, 6) + x[10] * n)));
}

}

std::vector<Row> texturing_rows()
{
    using enum Unit;
    const char* place_bound = "header: 1.2e-7";
    return {
        {"texturing::planar_coordinates", ulps, 4, "header: 4 ulp, of the distance too", naive_planar, plane,
         plane_slack},
        {"texturing::spherical_coordinates", absolute, 1.2e-7, place_bound, naive_spherical},
        {"texturing::cylindrical_coordinates", absolute, 1.2e-7, place_bound, naive_cylindrical, height},
        {"texturing::mirrored_direction", ulps, 0, "header: 4 ulp of its length", naive_mirror, unit_normal,
         mirror_slack},
        {"texturing::box_place", absolute, 1.2e-7, place_bound},
        {"texturing::panorama_place", absolute, 1.2e-7, place_bound, naive_panorama},
        {"texturing::panorama_direction", absolute, 1.2e-7, place_bound, nullptr, place},
        {"texturing::sphere_place", absolute, 2.4e-7, "header: 2.4e-7, also beside -z", naive_sphere_place},
        {"texturing::sphere_direction", absolute, 1.2e-6, "header: 1.2e-6", nullptr, ball_place},
        {"texturing::level_at_distance", ulps, 1, "header: an ulp", naive_level, positive},
        {"texturing::level_of_step", ulps, 1, "header: an ulp", naive_step},
        {"texturing::bumped_normal", absolute, 4e-7, "header: 4e-7", naive_bump, bumps},
    };
}

}
