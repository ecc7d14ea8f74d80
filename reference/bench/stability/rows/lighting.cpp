#include <algorithm>
#include <cmath>
#include <numbers>

#include "../row.hpp"

namespace stability {
namespace {

using umbral::Random;

constexpr float degree = std::numbers::pi_v<float> / 180;

void exponent(std::vector<float>& x, Random& random) { x[9] = between_powers(random, -2, 4); }
void angles(std::vector<float>& x, Random& random)
{
    x[0] = random.uniform(-1, 1) * between_powers(random, 0, 7);
    x[1] = random.uniform(-1, 1) * between_powers(random, 0, 7);
}
void stored(std::vector<float>& x, Random& random)
{
    x[0] = random.below(2) == 0 ? between_powers(random, -8, 0) : random.uniform();
}
// A light farther from the centre than 1.001 radii.
void lit_sphere(std::vector<float>& x, Random& random)
{
    const glm::vec3 side = random.unit_vector();
    x[3] = between_powers(random, -3, 3);
    const float away = x[3] * (1.01F + between_powers(random, -2, 4));
    const float far = x[3] * between_powers(random, -2, 3);
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        x[at] = random.uniform(-1, 1) * far;
        x[4 + at] = x[at] + side[i] * away;
    }
    const double dx = double{x[4]} - x[0];
    const double dy = double{x[5]} - x[1];
    const double dz = double{x[6]} - x[2];
    if (std::sqrt(dx * dx + dy * dy + dz * dz) < 1.002 * x[3]) x[4] = x[0] + 2 * x[3];
}

double sphere_slack(Numbers x) { return 1e-7 * x[3]; }
double mirror_slack(Numbers x) { return 2e-7 * std::hypot(double{x[0]}, double{x[1]}, double{x[2]}); }

Answer naive_half(Numbers x)
{
    return numbers(glm::normalize(glm::normalize(v_at(x, 0)) + glm::normalize(v_at(x, 3))));
}
Answer naive_blinn(Numbers x)
{
    const glm::vec3 n = glm::normalize(v_at(x, 0));
    const glm::vec3 l = glm::normalize(v_at(x, 3));
    const glm::vec3 h = glm::normalize(l + glm::normalize(v_at(x, 6)));
    return numbers(glm::dot(n, l) > 0 ? std::pow(std::max(0.0F, glm::dot(n, h)), x[9]) : 0.0F);
}
Answer naive_phong(Numbers x)
{
    const glm::vec3 n = glm::normalize(v_at(x, 0));
    const glm::vec3 l = glm::normalize(v_at(x, 3));
    const glm::vec3 r = 2 * glm::dot(n, l) * n - l;
    return numbers(glm::dot(n, l) > 0 ? std::pow(std::max(0.0F, glm::dot(r, glm::normalize(v_at(x, 6)))), x[9]) : 0.0F);
}
Answer naive_mirror(Numbers x)
{
    const glm::vec3 n = glm::normalize(v_at(x, 3));
    return numbers(2 * glm::dot(n, v_at(x, 0)) * n - v_at(x, 0));
}
Answer naive_to_light(Numbers x) { return numbers(glm::normalize(v_at(x, 0) - v_at(x, 3))); }
Answer naive_direction(Numbers x)
{
    const float a = x[0] * degree;
    const float b = x[1] * degree;
    return {std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a)};
}
Answer naive_angles(Numbers x)
{
    const float a = std::atan2(x[0], x[2]) / degree;
    return {a < 0 ? a + 360 : a, std::asin(x[1] / glm::length(v_at(x, 0))) / degree};
}
Answer naive_encode(Numbers x)
{
    return numbers(x[0] <= 0.0031308F ? 12.92F * x[0] : 1.055F * std::pow(x[0], 1 / 2.4F) - 0.055F);
}
Answer naive_decode(Numbers x)
{
    return numbers(x[0] <= 0.04045F ? x[0] / 12.92F : std::pow((x[0] + 0.055F) / 1.055F, 2.4F));
}
Answer naive_brightest(Numbers x) { return numbers(v_at(x, 0) + x[3] * glm::normalize(v_at(x, 4) - v_at(x, 0))); }

}

std::vector<Row> lighting_rows()
{
    using enum Unit;
    const char* seven = "header: within 1e-7";
    return {
        {"lighting::half_vector", absolute, 1e-7, seven, naive_half},
        {"lighting::blinn_highlight", absolute, 1e-7, seven, naive_blinn, exponent},
        {"lighting::phong_highlight", absolute, 1e-7, seven, naive_phong, exponent},
        {"lighting::mirrored_direction", ulps, 0.5, "header: within 2e-7 |l|", naive_mirror, nullptr, mirror_slack},
        {"lighting::direction_to_light", absolute, 1e-7, seven, naive_to_light},
        {"lighting::light_direction", absolute, 1e-7, "header: within 1e-7, up to 10^7 degrees", naive_direction,
         angles},
        {"lighting::light_angles", ulps, 1, "header: an ulp", naive_angles},
        {"lighting::encode_srgb", ulps, 0.501, "header: 0.501 ulp", naive_encode, stored},
        {"lighting::decode_srgb", ulps, 0.501, "header: 0.501 ulp", naive_decode, stored},
        {"lighting::brightest_diffuse", ulps, 0.5, "header: 1e-7 of the radius, and a rounding", naive_brightest,
         lit_sphere, sphere_slack},
    };
}

}
