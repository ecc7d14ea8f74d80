#pragma once

#include <cmath>
#include <kit/drawing.hpp>
#include <numbers>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/vectors.hpp>

/// Thales' theorem as a flower: the feet of the perpendiculars from the tip of a vector onto all directions lie on a
/// circle over it.
namespace umbral::transforms {

inline glm::dvec2 flat(const glm::vec3& v) { return {v.x, v.y}; }

/// From blue over green and orange to pink as `t` goes from 0 to 1.
inline glm::vec3 colour_at(float t)
{
    constexpr glm::vec3 stops[] = {ink::blue, ink::green, ink::orange, ink::red, ink::pink};
    if (!(t >= 0)) return ink::slate;
    const float place = std::min(t, 1.0F) * 4;
    const int stop = std::min(static_cast<int>(place), 3);
    return glm::mix(stops[stop], stops[stop + 1], place - static_cast<float>(stop));
}

inline Image draw_rosette(Variation& vary, Recorder& out)
{
    constexpr float pi = std::numbers::pi_v<float>;
    constexpr int petals = 6;
    constexpr int threads = 54;
    Drawing drawing(400, 400, {-1.12, -1.12}, {1.12, 1.12});
    const float turn = vary.near(0.0F, 0.45F);
    const auto direction = [turn](float angle) { return glm::vec3(std::cos(angle + turn), std::sin(angle + turn), 0); };
    for (int petal = 0; petal < petals; ++petal) {
        const glm::vec3 vector = direction(pi / 6 + 2 * pi * static_cast<float>(petal) / petals);
        for (int thread = 0; thread < threads; ++thread) {
            const glm::vec3 along = 3.0F * direction(pi * (static_cast<float>(thread) + 0.5F) / threads);
            const glm::vec3 foot = ask<parallel_part>(out, vector, along);
            const glm::vec3 rest = ask<perpendicular_part>(out, vector, along);
            const glm::vec3 color = colour_at(ask<angle_between>(out, vector, along) / pi);
            drawing.line({0, 0}, flat(foot), color, 1, 0.2);
            drawing.line(flat(foot), flat(foot + rest), color, 1, 0.45);
            drawing.disc(flat(foot), 2.2, color);
        }
    }
    for (int petal = 0; petal < petals; ++petal) {
        const float angle = pi / 6 + 2 * pi * static_cast<float>(petal) / petals;
        drawing.arrow({0, 0}, flat(ask<normalised>(out, 7.0F * direction(angle))), ink::white, 2);
    }
    // Every other mark is a cross product: z × v is v, turned to the left.
    for (int petal = 0; petal < petals; ++petal) {
        const glm::vec3 v = direction(2 * pi * static_cast<float>(petal) / petals);
        const glm::vec3 left = ask<cross_product>(out, {0, 0, 1}, v);
        drawing.arrow(flat(0.99F * v - 0.06F * left), flat(0.99F * v + 0.08F * left),
                      colour_at(static_cast<float>(petal) / petals), 3);
    }
    return drawing.picture();
}

}
