#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/shapes.hpp>
#include <kit/stage.hpp>
#include <umbral/projections/fit.hpp>

#include "../island.hpp"

/// The goal picture of this unit: three panels of different shapes side by side.
namespace umbral::projections {

/// A context must be current while it lives.
class Gallery {
public:
    /// Knot and ball are turned about their axes by `more_turn` radians more than usual.
    explicit Gallery(float more_turn = 0)
        : more_turn_(more_turn),
          stage_(sum_of_widths(), height, {0.07F, 0.07F, 0.09F}),
          box_(uploaded(shapes::box())),
          ball_(uploaded(shapes::icosphere(5))),
          knot_(uploaded(shapes::trefoil(240, 24, 0.2F)))
    {
    }

    [[nodiscard]] static PictureSize panel_size(std::size_t panel) { return {widths[panel], height}; }

    /// The frame of a cube from -1 to 1, with a knot in it, seen from (0, 0, eye_z).
    void draw_cube(std::size_t panel, float eye_z, const ViewVolume& volume) const
    {
        begin(panel, eye_z, volume);
        const glm::vec3 colors[] = {{0.62F, 0.10F, 0.06F}, {0.80F, 0.52F, 0.10F}, {0.05F, 0.28F, 0.42F}};
        constexpr float thickness = 0.14F;
        for (int axis = 0; axis < 3; ++axis)
            for (const glm::vec2& sides : {glm::vec2(0, 0), {0, 1}, {1, 0}, {1, 1}}) {
                glm::vec3 size(thickness);
                size[axis] = 2;
                glm::vec3 corner(-1);
                corner[(axis + 1) % 3] += sides.x * (2 - thickness);
                corner[(axis + 2) % 3] += sides.y * (2 - thickness);
                stage_.draw({box_, glm::scale(glm::translate(glm::mat4(1), corner), size), {.color = colors[axis]}});
            }
        const glm::mat4 turned =
            glm::rotate(glm::scale(glm::mat4(1), glm::vec3(0.66F)), 0.5F + more_turn_, {1, 0.4F, 0});
        stage_.draw({knot_, turned, {.color = {0.55F, 0.58F, 0.62F}, .gloss = 0.6F}});
    }

    /// The unit ball with a chequered surface, seen from (0, 0, eye_z).
    void draw_ball(std::size_t panel, float eye_z, const ViewVolume& volume) const
    {
        begin(panel, eye_z, volume);
        const glm::mat4 turned = glm::rotate(glm::mat4(1), 0.6F + more_turn_, {1, 0.3F, 0.2F});
        stage_.draw(
            {ball_, turned, {.color = {0.75F, 0.70F, 0.60F}, .gloss = 0.5F, .odd = glm::vec3(0.05F, 0.28F, 0.42F)}});
    }

    [[nodiscard]] Image picture() const { return stage_.picture(); }

private:
    static constexpr int height = 200;
    static constexpr int gap = 8;
    static constexpr std::array<int, 3> widths = {280, 200, 120};

    static constexpr int sum_of_widths() { return widths[0] + widths[1] + widths[2] + 2 * gap; }

    void begin(std::size_t panel, float eye_z, const ViewVolume& volume) const
    {
        int left = 0;
        for (std::size_t i = 0; i < panel; ++i) left += widths[i] + gap;
        begin_panel({2 * left, 0}, {2 * widths[panel], 2 * height}, {0.80F, 0.84F, 0.88F});
        const auto [l, r, b, t, n, f] = volume;
        look_through(stage_, glm::lookAt(glm::vec3(0, 0, eye_z), glm::vec3(0), glm::vec3(0, 1, 0)),
                     glm::frustum(l, r, b, t, n, f));
    }

    float more_turn_;
    Stage stage_;
    gl::Mesh box_;
    gl::Mesh ball_;
    gl::Mesh knot_;
};

}
