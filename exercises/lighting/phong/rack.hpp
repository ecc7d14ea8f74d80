#pragma once

#include <array>
#include <umbral/lighting/phong.hpp>
#include <umbral/record/variation.hpp>
#include <vector>

#include "../soft_shadow.hpp"
#include "../visible.hpp"

/// The goal picture: fifteen balls on a cloth below three lamps. The exponent doubles from row to row.
namespace umbral::lighting {

inline constexpr std::array<glm::vec3, 15> ball_colors = {{{0.90F, 0.55F, 0.02F},
                                                           {0.02F, 0.08F, 0.45F},
                                                           {0.62F, 0.02F, 0.02F},
                                                           {0.16F, 0.03F, 0.28F},
                                                           {0.85F, 0.20F, 0.02F},
                                                           {0.01F, 0.22F, 0.09F},
                                                           {0.30F, 0.03F, 0.03F},
                                                           {0.012F, 0.012F, 0.014F},
                                                           {0.85F, 0.60F, 0.10F},
                                                           {0.05F, 0.20F, 0.55F},
                                                           {0.75F, 0.70F, 0.60F},
                                                           {0.50F, 0.04F, 0.16F},
                                                           {0.04F, 0.30F, 0.34F},
                                                           {0.55F, 0.30F, 0.05F},
                                                           {0.25F, 0.05F, 0.35F}}};

/// Varied, the balls have each other's colours, and the lamps are turned about the table's middle.
inline Image rack(int width, int height, Variation vary = {})
{
    const std::size_t first_color = vary.one_of(0, std::array{3, 5, 7, 11});
    const glm::mat4 lamps_turned(vary.turn({0, 1, 0}, 1.5F));
    View view = empty_view(width, height);
    constexpr glm::vec3 eye(0, 6.6F, 9.8F);
    const glm::mat4 camera =
        glm::perspective(glm::radians(33.0F), static_cast<float>(width) / static_cast<float>(height), 0.1F, 80.0F) *
        glm::lookAt(eye, glm::vec3(0, 0.15F, -0.25F), glm::vec3(0, 1, 0));
    Shape cloth;
    cloth.quad({-30, 0, 8}, {60, 0, 0}, {0, 0, -60});
    draw(view, camera, cloth, glm::mat4(1), 1);
    std::vector<Material> materials = {{}, {{}, glm::vec3(0.01F, 0.05F, 0.03F), {0.02F, 0.20F, 0.12F}, {}, 1}};
    std::vector<Ball> balls = {{}, {}};  // thing 0 is nothing, and thing 1 the cloth
    const Shape ball = sphere(72, 36);
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column <= row; ++column) {
            const glm::vec3 place(static_cast<float>(2 * column - row) * 0.72F, 0.7F,
                                  2.4F - 1.247F * static_cast<float>(row));
            const glm::vec3 color = ball_colors[(first_color + materials.size() - 2) % ball_colors.size()];
            draw(view, camera, ball, glm::scale(glm::translate(glm::mat4(1), place), glm::vec3(0.7F)),
                 static_cast<int>(materials.size()));
            const float shininess = 8 * std::exp2(static_cast<float>(row));
            materials.push_back({{}, 0.10F * color, color, glm::vec3(0.55F), shininess});
            balls.push_back({place, 0.7F});
        }
    std::array<Light, 3> lamps = {{{{-5.2F, 6.2F, -1.5F, 1}, {0.62F, 0.52F, 0.36F}},
                                   {{0.4F, 7.0F, -4.5F, 1}, {0.55F, 0.52F, 0.46F}},
                                   {{5.2F, 5.6F, 1.2F, 1}, {0.34F, 0.42F, 0.58F}}}};
    for (Light& lamp : lamps) lamp.position = lamps_turned * lamp.position;
    return lit_picture(view, {0, 0, 0}, [&](const Visible& seen) {
        std::array<Light, 3> arriving = lamps;
        for (Light& lamp : arriving)
            for (std::size_t i = 2; i < balls.size(); ++i)
                if (static_cast<int>(i) != seen.thing)
                    lamp.color *= share_seen(seen.at.position, glm::vec3(lamp.position), 0.5F, balls[i]);
        return phong_reflection(seen.at, materials[static_cast<std::size_t>(seen.thing)], arriving, glm::vec3(0.3F),
                                eye);
    });
}

}
