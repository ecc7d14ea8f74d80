#pragma once

#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/stage.hpp>
#include <optional>
#include <umbral/interaction/positioning.hpp>
#include <vector>

/// Beads on a floor and a wall that make a heart from one place only: where each bead lies, a pixel says.
namespace umbral::interaction {

inline constexpr int heart_size = 256;
inline constexpr double wall_depth = -1.4;
inline const glm::vec3 heart_eye(-0.6F, 2.3F, 4.6F);

inline glm::mat4 heart_view(const glm::vec3& eye)
{
    return glm::lookAt(eye, glm::vec3(0, 0.45F, 0), glm::vec3(0, 1, 0));
}
inline glm::mat4 heart_projection() { return glm::perspective(glm::radians(40.0F), 1.0F, 0.1F, 100.0F); }

/// The pixels of the heart, in order.
inline std::vector<glm::ivec2> heart_pixels()
{
    constexpr int beads = 84;
    std::vector<glm::ivec2> pixels;
    for (int i = 0; i < beads; ++i) {
        const double t = 2 * 3.14159265358979 * i / beads;
        const double x = 16 * std::pow(std::sin(t), 3);
        const double y = 13 * std::cos(t) - 5 * std::cos(2 * t) - 2 * std::cos(3 * t) - std::cos(4 * t);
        pixels.emplace_back(std::lround(128 + 4.6 * x), std::lround(128 - 5.2 * y));
    }
    return pixels;
}

/// Seen from `eye`; `point` says which point of a plane a pixel shows; beads without one are left out.
inline Image draw_heart(const glm::vec3& eye,
                        const std::function<std::optional<glm::dvec3>(glm::ivec2, const SnapPlane&)>& point)
{
    const SnapPlane floor{{0, 1, 0}, 0.06};
    const SnapPlane wall{{0, 0, 1}, wall_depth + 0.06};
    const Stage stage(2 * heart_size, heart_size, {0.16F, 0.17F, 0.21F});
    const gl::Mesh box = uploaded(shapes::box());
    const gl::Mesh ball = uploaded(shapes::icosphere(2));
    const Stage::Thing ground{box, slab(2.6F), {.color = {0.62F, 0.60F, 0.56F}, .odd = glm::vec3(0.42F, 0.42F, 0.44F)}};
    std::vector<Stage::Thing> beads;
    float hue = 0;
    for (const glm::ivec2& pixel : heart_pixels()) {
        const std::optional<glm::dvec3> on_floor = point(pixel, floor);
        const std::optional<glm::dvec3> place = on_floor && on_floor->z > wall_depth ? on_floor : point(pixel, wall);
        hue += 1.0F / 84;
        if (!place || !(glm::length(*place) < 50)) continue;
        // As large as it has to be, to look as large as the others.
        const float radius = 0.0145F * static_cast<float>(glm::length(*place - glm::dvec3(eye)));
        const glm::vec3 color =
            srgb_decoded(glm::dvec3(rainbow(0.93F + 0.14F * std::sin(6.2832F * hue), 0.85F, 0.95F)));
        beads.push_back({ball,
                         glm::scale(glm::translate(glm::mat4(1), glm::vec3(*place)), glm::vec3(radius)),
                         {.color = color, .gloss = 0.4F}});
    }
    const glm::mat4 upright = glm::scale(
        glm::translate(glm::mat4(1), {-2.6F, 0, static_cast<float>(wall_depth) - 0.1F}), glm::vec3(5.2F, 2.9F, 0.1F));
    const Stage::Thing behind{box, upright, {.color = {0.30F, 0.36F, 0.44F}}};
    for (int column = 0; column < 2; ++column) {
        stage.column(column, 2);
        if (column == 0)
            stage.look(heart_view(eye), 40);
        else
            stage.look({4.4F, 3.6F, 4.0F}, {0, 0.5F, -0.2F}, 42);
        stage.draw_on(ground, beads);
        stage.draw(behind);
    }
    return stage.picture();
}

}
