#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "stage.hpp"

namespace umbral {

/// A small scene to look at through a student's view matrix: a chequered floor, the world's axes as arrows (red x,
/// green y, blue z), and some boxes. In perspective, 256 x 256 pixels. A context must be current.
inline Image draw_scene(const glm::mat4& view)
{
    const Stage stage(256, 256, {0.62F, 0.74F, 0.86F});
    stage.look(view, 42);
    const gl::Mesh box = uploaded(shapes::box());
    const gl::Mesh arrow = uploaded(shapes::arrow());
    std::vector<Stage::Thing> things;
    const auto add_box = [&](glm::vec3 corner, glm::vec3 size, float turn, glm::vec3 color) {
        things.push_back({box,
                          glm::scale(glm::rotate(glm::translate(glm::mat4(1), corner), turn, {0, 1, 0}), size),
                          {.color = color}});
    };
    add_box({-1.5F, 0, -1.4F}, {0.7F, 1.3F, 0.7F}, 0.3F, {0.68F, 0.14F, 0.06F});
    add_box({0.7F, 0, -1.3F}, {0.9F, 0.6F, 0.6F}, -0.35F, {0.88F, 0.50F, 0.05F});
    add_box({-1.5F, 0, 0.9F}, {0.5F, 0.5F, 0.5F}, 0.6F, {0.06F, 0.36F, 0.42F});
    add_box({1.0F, 0, 0.75F}, {0.35F, 0.35F, 0.35F}, 0.9F, {0.36F, 0.12F, 0.46F});
    const auto add_arrow = [&](float turn, glm::vec3 axis, glm::vec3 color) {
        const glm::mat4 origin = glm::translate(glm::mat4(1), {0, 0.08F, 0});
        things.push_back({arrow, glm::scale(glm::rotate(origin, turn, axis), glm::vec3(1.25F)), {.color = color}});
    };
    constexpr float quarter = 1.5707963F;
    add_arrow(quarter, {0, 1, 0}, {0.80F, 0.02F, 0.02F});
    add_arrow(-quarter, {1, 0, 0}, {0.04F, 0.50F, 0.05F});
    add_arrow(0, {0, 1, 0}, {0.02F, 0.08F, 0.80F});
    stage.draw_on({box, slab(2), {.color = {0.80F, 0.78F, 0.72F}, .odd = glm::vec3(0.12F, 0.18F, 0.26F)}}, things);
    return stage.picture();
}

}
