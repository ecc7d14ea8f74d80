#include <algorithm>
#include <cmath>
#include <numbers>

#include "../row.hpp"

namespace stability {
namespace {

using umbral::Random;

constexpr float degree = std::numbers::pi_v<float> / 180;

// Opposite sides that differ, far from 0 or not; planes at positive distances.
void frustum(std::vector<float>& x, Random& random)
{
    for (std::size_t at = 0; at < 4; at += 2) {
        x[at] = std::clamp(x[at], -1e8F, 1e8F);
        const float wide = std::max(std::abs(x[at]), 1e-8F) * between_powers(random, -5, 2);
        x[at + 1] = x[at] + wide;
        if (x[at + 1] == x[at]) x[at + 1] = std::nextafter(x[at], 1e9F);
    }
    x[4] = between_powers(random, -4, 4);
    x[5] = std::nextafter(x[4], 1e9F) + x[4] * between_powers(random, -6, 6);
}
void lens(std::vector<float>& x, Random& random)
{
    x[0] = random.below(2) == 0 ? between_powers(random, -6, 0) : random.uniform(1, 179.999F);
    x[1] = between_powers(random, -3, 3);
    x[2] = between_powers(random, -4, 4);
    x[3] = std::nextafter(x[2], 1e9F) + x[2] * between_powers(random, -6, 6);
}
void field_of_view(std::vector<float>& x, Random& random)
{
    x[0] = random.below(2) == 0 ? between_powers(random, -6, 0) : random.uniform(1, 179.999F);
    x[1] = between_powers(random, -4, 4);
}
void right_angle(std::vector<float>& x, Random& random)
{
    x[0] = random.below(2) == 0 ? 90 - between_powers(random, -5, 1) : between_powers(random, -6, 1.9F);
}
void lean(std::vector<float>& x, Random& random) { x[0] = random.uniform(-720, 720); }
void screen(std::vector<float>& x, Random& random)
{
    for (std::size_t i = 0; i < 5; ++i) x[i] = between_powers(random, -3, 3);
    x[5] = x[4] * 10;
    x[6] = random.below(2) == 0 ? between_powers(random, -6, 6) : x[2] * (1 + between_powers(random, -6, -1));
}
// Eyes up to 1e6 from the origin, at least 1e-2 of the size from their target; up at a sine of 2e-6 or more.
void view(std::vector<float>& x, Random& random)
{
    const float size = between_powers(random, -4, 5.5F);
    for (std::size_t i = 0; i < 6; ++i) x[i] = random.uniform(-1, 1) * size;
    for (std::size_t i = 0; i < 3; ++i) x[6 + i] = random.uniform(-1, 1);
    if (random.below(2) != 0) return;
    const float off = between_powers(random, -4, -1);
    for (std::size_t i = 0; i < 3; ++i) x[6 + i] = (x[3 + i] - x[i]) / size + off * x[6 + i];
}
void view_parameters(std::vector<float>& x, Random& random)
{
    view(x, random);
    const float off = between_powers(random, -4, 0);
    for (std::size_t i = 0; i < 3; ++i) x[3 + i] = x[6 + i] + off * random.uniform(-1, 1);
}
void flight(std::vector<float>& x, Random& random)
{
    x[12] = between_powers(random, -3, 3);
    x[13] = x[12] * random.uniform(-0.1F, 1.1F);
}

double flight_slack(Numbers x)
{
    float largest = 0;
    for (std::size_t i = 0; i < 12; ++i) largest = std::max(largest, std::abs(x[i]));
    return 1e-12 * largest;
}

Answer naive_frustum(Numbers x)
{
    const auto [l, r, b, t, n, f] = std::array{x[0], x[1], x[2], x[3], x[4], x[5]};
    glm::mat4 m(0);
    m[0][0] = 2 * n / (r - l);
    m[1][1] = 2 * n / (t - b);
    m[2] = {(r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1};
    m[3][2] = -2 * f * n / (f - n);
    return numbers(m);
}
Answer naive_orthographic(Numbers x)
{
    const auto [l, r, b, t, n, f] = std::array{x[0], x[1], x[2], x[3], x[4], x[5]};
    glm::mat4 m(1);
    m[0][0] = 2 / (r - l);
    m[1][1] = 2 / (t - b);
    m[2][2] = -2 / (f - n);
    m[3] = {-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1};
    return numbers(m);
}
Answer naive_perspective(Numbers x)
{
    const float scale = 1 / std::tan(x[0] / 2 * degree);
    glm::mat4 m(0);
    m[0][0] = scale / x[1];
    m[1][1] = scale;
    m[2] = {0, 0, -(x[3] + x[2]) / (x[3] - x[2]), -1};
    m[3][2] = -2 * x[3] * x[2] / (x[3] - x[2]);
    return numbers(m);
}
Answer naive_field(Numbers x) { return numbers(2 * std::atan(std::tan(x[0] / 2 * degree) / x[1]) / degree); }
Answer naive_foreshortening(Numbers x) { return numbers(1 / std::tan(x[0] * degree)); }
Answer naive_curved(Numbers x)
{
    const float d = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    return x[2] > 0 ? Answer{} : Answer{x[0] / d, x[1] / d, d};
}
Answer naive_visual(Numbers x)
{
    return numbers(std::acos(glm::dot(glm::normalize(v_at(x, 0)), glm::normalize(v_at(x, 3)))));
}
Answer naive_parallax(Numbers x) { return numbers(x[3] * (1 - x[2] / x[6])); }
Answer naive_view(Numbers x)
{
    const glm::vec3 z = glm::normalize(v_at(x, 0) - v_at(x, 3));
    const glm::vec3 right = glm::normalize(glm::cross(v_at(x, 6), z));
    const glm::vec3 y = glm::cross(z, right);
    const glm::mat3 turn = glm::transpose(glm::mat3(right, y, z));
    glm::mat4 m(turn);
    m[3] = glm::vec4(-(turn * v_at(x, 0)), 1);
    return numbers(m);
}
Answer naive_flight(Numbers x)
{
    const float u = glm::clamp(x[13] / x[12], 0.0F, 1.0F);
    return joined(v_at(x, 0) + u * (v_at(x, 3) - v_at(x, 0)), v_at(x, 6) + u * (v_at(x, 9) - v_at(x, 6)));
}

}

std::vector<Row> projections_rows()
{
    using enum Unit;
    const char* eight = "header: rounded once, but for a part in 10^8";
    const char* twelve = "header: rounded once, but for a part in 10^12";
    return {
        {"projections::frustum_matrix", ulps, 0.67, eight, naive_frustum, frustum},
        {"projections::orthographic_matrix", ulps, 0.51, "header: but for a part in 10^14", naive_orthographic,
         frustum},
        {"projections::inverse_orthographic_matrix", ulps, 0.51, "header: but for a part in 10^14", nullptr, frustum},
        {"projections::perspective_matrix", ulps, 0.67, eight, naive_perspective, lens},
        {"projections::reversed_perspective_matrix", ulps, 0.67, eight, nullptr, lens},
        {"projections::vertical_field_of_view", ulps, 0.51, twelve, naive_field, field_of_view},
        {"projections::foreshortening_of", ulps, 0.51, twelve, naive_foreshortening, right_angle},
        {"projections::oblique_shear", ulps_of_largest, 0.51, "header: one rounding and 1e-15", nullptr, lean},
        {"projections::projector_direction", ulps_of_largest, 0.51, "header: one rounding and 1e-15", nullptr, lean},
        {"projections::spherical_projection", ulps, 0.51, twelve, naive_curved},
        {"projections::cylindrical_projection", ulps, 0.51, twelve},
        {"projections::visual_angle", ulps, 0.51, twelve, naive_visual},
        {"projections::parallax", ulps, 0.67, eight, naive_parallax, screen},
        {"projections::view_matrix", ulps_of_largest, 0.51, "header: once, but for 2e-10 of the column", naive_view,
         view},
        {"projections::view_frame", ulps_of_largest, 1, "header: 6e-8, the origin rounded once", nullptr,
         view_parameters},
        {"interaction::flight_pose", ulps, 0.51, twelve, naive_flight, flight, flight_slack},
    };
}

}
