#pragma once

#include <cmath>
#include <kit/drawing.hpp>
#include <kit/varied.hpp>
#include <umbral/core/random.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/about_a_point.hpp>

/// A kaleidoscope: shards of glass in a wedge of 30 degrees, its mirror image, and six turns of both about a point that
/// is not the origin.
namespace umbral::transforms {

/// A triangle of glass, its corners in polar coordinates (radius, degrees) about the centre.
struct Shard {
    glm::vec2 corners[3];
    glm::vec3 color;
};

inline std::vector<Shard> shards(std::uint64_t seed)
{
    constexpr glm::vec3 glass[] = {ink::blue, ink::orange,           ink::green,           ink::red,
                                   ink::pink, {0.45F, 0.36F, 0.80F}, {0.95F, 0.85F, 0.45F}};
    Random random(seed);
    std::vector<Shard> result;
    for (int i = 0; i < 26; ++i) {
        const float radius = random.uniform(0.16F, 2.6F);
        const float angle = random.uniform(0, 30);
        Shard shard{{}, glass[random.below(7)]};
        for (glm::vec2& corner : shard.corners) {
            const float r = radius + random.uniform(-0.42F, 0.42F);
            corner = {std::clamp(r, 0.05F, 2.75F), std::clamp(angle + random.uniform(-14, 14), 0.0F, 30.0F)};
        }
        result.push_back(shard);
    }
    return result;
}

inline Image draw_kaleidoscope(Variation& vary, Recorder& out)
{
    const std::vector<Shard> glass = shards(any_instead(vary, 14U, 0U, 1U << 31U));
    const glm::vec3 centre(7, -4, 0);
    const auto polar = [&](float radius, float degrees) {
        return centre + radius * glm::vec3(std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)), 0);
    };
    const auto place = [](const glm::mat4& m, const glm::vec3& p) {
        const glm::vec4 q = m * glm::vec4(p, 1);
        return glm::dvec2(q.x, q.y);
    };
    Drawing drawing(400, 400, {3.6, -7.4}, {10.4, -0.6});
    // Turns by 60 degrees; half of them as the symmetry about the centre of the others.
    std::vector<glm::mat4> sectors;
    for (int k = 0; k < 3; ++k) {
        const glm::mat4 turn =
            ask<rotation_about_point>(out, centre, {{0, 0, 3}, glm::radians(60.0F * static_cast<float>(k))});
        sectors.push_back(turn);
        sectors.push_back(ask<reflection_in_point>(out, centre) * turn);
    }
    // In the plane the mirror across the wedge's edge and the half turn about that edge do the same.
    const glm::vec3 edge = polar(2, 30) - centre;
    const glm::mat4 mirrors[] = {ask<reflection_in_plane>(out, centre, {edge.y, -edge.x, 0}),
                                 ask<reflection_in_line>(out, centre, edge)};
    int copy = 0;
    for (const glm::mat4& sector : sectors) {
        for (const bool mirrored : {false, true}) {
            const glm::mat4 m = mirrored ? sector * mirrors[copy++ % 2] : sector;
            for (const Shard& shard : glass) {
                std::vector<glm::dvec2> corners;
                for (const glm::vec2& corner : shard.corners) corners.push_back(place(m, polar(corner.x, corner.y)));
                drawing.area(corners, shard.color, 0.62);
                drawing.outline(corners, glm::mix(shard.color, ink::white, 0.45F), 0.8);
            }
        }
    }
    // A rim of darts that point along it, and a small star that is a ring scaled about the centre.
    for (int i = 0; i < 36; ++i) {
        const auto degrees = 10 * static_cast<float>(i);
        const glm::vec3 along(-std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)), 0);
        const glm::mat4 dart = ask<placed_along>(out, polar(3.05F, degrees), along);
        const glm::vec3 color = i % 3 == 0 ? ink::white : ink::mist;
        drawing.arrow(place(dart, {0, 0, -0.17F}), place(dart, {0, 0, 0.2F}), color, i % 3 == 0 ? 3 : 2);
        const glm::vec3 ray =
            glm::vec3(ask<alignment>(out, {1, 0, 0}, polar(1, degrees) - centre) * glm::vec4(0.34F, 0, 0, 0));
        const glm::mat4 shrunk = ask<scaling_about_point>(out, centre, glm::vec3(i % 3 == 0 ? 1 : 0.55F));
        drawing.line({centre.x, centre.y}, place(shrunk, centre + ray), ink::white, 1.5, 0.8);
    }
    return drawing.picture();
}

}
