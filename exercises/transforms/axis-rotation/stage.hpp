#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/stage.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/rotation.hpp>
#include <vector>

/// A flower whose petals are one petal, turned about the stalk by the student's matrices. A context must be current.
namespace umbral::transforms {

/// The flower's axis, not unit on purpose.
inline constexpr glm::vec3 flower_axis{0.9F, 2.1F, 0.7F};

/// A ring of petals: how many, how far round the first one stands, the length of each, and how high it rises (radians
/// above the plane across the axis).
struct Ring {
    int petals;
    float first;
    float length;
    float rise;
};

/// A petal along x from the origin, of length 1: an ellipsoid, bent upwards (y) towards its tip.
inline shapes::Shape petal_shape()
{
    constexpr int cells = 24;
    const auto place = [](float along, float around) {
        const float u = 0.5F * shapes::turn * along;
        const float v = shapes::turn * around;
        const float x = 0.5F - 0.5F * std::cos(u);
        const float width = std::sin(u) * (0.35F + 0.65F * x);
        return glm::vec3(x, 0.30F * x * x + 0.035F * width * std::sin(v), 0.27F * width * std::cos(v));
    };
    return shapes::woven(cells, cells, [&](float u, float v) {
        // At its ends the petal is a point: the normal of the ring next to it will do.
        constexpr float step = 1.0F / cells;
        const float ring = std::clamp(u, step, 1 - step);
        return shapes::Vertex{place(u, v), normalize(cross(place(ring + step, v) - place(ring - step, v),
                                                           place(ring, v + step) - place(ring, v - step)))};
    });
}

/// The frame in which the flower stands: x across the axis, y along it.
inline glm::mat4 flower_frame()
{
    const glm::vec3 up = normalize(flower_axis);
    const glm::vec3 x = normalize(cross(glm::vec3(0, 0, 1), up));
    return {glm::vec4(x, 0), glm::vec4(up, 0), glm::vec4(cross(x, up), 0), glm::vec4(0, 0, 0, 1)};
}

/// Round the wheel of colours once, in linear light.
inline glm::vec3 hue(float turn)
{
    const glm::vec3 phase = shapes::turn * (turn + glm::vec3(0.0F, 0.36F, 0.64F));
    const glm::vec3 wave = 0.5F + 0.5F * glm::cos(phase);
    return glm::mix(glm::vec3(0.03F, 0.02F, 0.06F), glm::vec3(0.95F, 0.62F, 0.85F), wave * wave);
}

/// 320 x 320 pixels.
inline Image draw_flower(Variation& vary, Recorder& out)
{
    const Stage stage(320, 320, {0.62F, 0.74F, 0.86F});
    stage.look(vary.near(glm::vec3(0.9F, 3.1F, 4.6F), 0.9F), {0.28F, 0.68F, 0.2F}, 36);
    const gl::Mesh petal = uploaded(petal_shape());
    const gl::Mesh box = uploaded(shapes::box());
    const gl::Mesh arrow = uploaded(shapes::arrow());
    std::vector<Stage::Thing> things;
    constexpr Ring rings[] = {{12, 0, 1.35F, 0.05F}, {12, 0.2617994F, 1.05F, 0.50F}, {8, 0.1F, 0.72F, 0.95F}};
    const glm::mat4 heart = glm::translate(glm::mat4(1), 0.62F * normalize(flower_axis));
    const glm::mat4 frame = flower_frame();
    for (const Ring& ring : rings) {
        // The petal as it grows at angle 0; everything else is the student's rotation about the axis.
        const glm::mat4 raised = glm::rotate(frame, ring.rise, {0, 0, 1});
        const glm::mat4 twisted = glm::scale(glm::rotate(raised, 0.35F, {1, 0, 0}), glm::vec3(ring.length));
        for (int i = 0; i < ring.petals; ++i) {
            const float turn = static_cast<float>(i) / static_cast<float>(ring.petals);
            const glm::mat4 rotation = ask<rotation_matrix>(out, {flower_axis, ring.first + shapes::turn * turn});
            things.push_back({petal, heart * rotation * twisted, {.color = hue(turn + 0.1F * ring.rise)}});
        }
    }
    things.push_back({arrow,
                      glm::scale(glm::rotate(frame, -1.5707963F, {1, 0, 0}), {1.8F, 1.8F, 1.75F}),
                      {.color = {0.80F, 0.52F, 0.10F}}});
    stage.draw_on({box, slab(20), {.color = {0.58F, 0.60F, 0.62F}, .odd = glm::vec3(0.47F, 0.50F, 0.54F)}}, things);
    return stage.picture();
}

}
