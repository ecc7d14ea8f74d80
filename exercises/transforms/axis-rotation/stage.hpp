#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/transforms/rotation.hpp>

#include "../../meshes/halved.hpp"
#include "../../projections/scene.hpp"

/// A flower whose petals are one petal, turned about the stalk by the student's matrices. A context must be current.
namespace umbral::transforms {

using projections::Shape;

/// The flower's axis, not unit on purpose.
inline constexpr glm::vec3 flower_axis{0.9F, 2.1F, 0.7F};

/// A ring of petals: how many, how far round the first one stands, the length of each, and how high it rises (radians above the plane across the axis).
struct Ring {
    int petals;
    float first;
    float length;
    float rise;
};

/// A petal along x from the origin, of length 1: an ellipsoid, bent upwards (y) towards its tip.
inline Shape petal_shape()
{
    constexpr int along = 24;
    constexpr int around = 24;
    Shape petal;
    const auto place = [](int i, int j) {
        const float u = 3.1415927F * static_cast<float>(i) / along;
        const float v = 6.2831853F * static_cast<float>(j) / around;
        const float x = 0.5F - 0.5F * std::cos(u);
        const float width = std::sin(u) * (0.35F + 0.65F * x);
        return glm::vec3(x, 0.30F * x * x + 0.035F * width * std::sin(v), 0.27F * width * std::cos(v));
    };
    for (int i = 0; i <= along; ++i) {
        for (int j = 0; j <= around; ++j) {
            petal.positions.push_back(place(i, j));
            // At its ends the petal is a point: the normal of the ring next to it will do.
            const int ring = std::min(std::max(i, 1), along - 1);
            petal.normals.push_back(normalize(cross(place(ring + 1, j) - place(ring - 1, j), place(ring, j + 1) - place(ring, j - 1))));
            if (i == along || j == around) continue;
            const auto here = static_cast<std::uint32_t>(i * (around + 1) + j);
            const std::uint32_t next = here + around + 1;
            petal.indices.insert(petal.indices.end(), {here, next, next + 1, here, next + 1, here + 1});
        }
    }
    return petal;
}

/// The frame in which the flower stands: x across the axis, y along it.
inline glm::mat4 flower_frame(const glm::vec3& heart)
{
    const glm::vec3 up = normalize(flower_axis);
    const glm::vec3 x = normalize(cross(glm::vec3(0, 0, 1), up));
    return {glm::vec4(x, 0), glm::vec4(up, 0), glm::vec4(cross(x, up), 0), glm::vec4(heart, 1)};
}

/// Round the wheel of colours once, in linear light.
inline glm::vec3 hue(float turn)
{
    const glm::vec3 phase = 6.2831853F * (turn + glm::vec3(0.0F, 0.36F, 0.64F));
    const glm::vec3 wave = 0.5F + 0.5F * glm::cos(phase);
    return glm::mix(glm::vec3(0.03F, 0.02F, 0.06F), glm::vec3(0.95F, 0.62F, 0.85F), wave * wave);
}

class Flower {
public:
    Flower()
        : petal_(upload(petal_shape())),
          box_(upload(projections::box_shape())),
          arrow_(upload(projections::arrow_shape())),
          program_({"flower.vert", projections::scene_vertex_shader}, {"flower.frag", projections::scene_fragment_shader})
    {
    }

    void draw() const
    {
        program_.set("view", glm::lookAt(glm::vec3(0.9F, 3.1F, 4.6F), glm::vec3(0.28F, 0.68F, 0.2F), glm::vec3(0, 1, 0)));
        program_.set("projection", glm::perspective(glm::radians(36.0F), 1.0F, 0.1F, 50.0F));
        program_.set("sun", sun());
        paint({0.58F, 0.60F, 0.62F}, {0.47F, 0.50F, 0.54F}, 1);
        program_.set("model", glm::scale(glm::translate(glm::mat4(1), {-20, -0.1F, -20}), {40, 0.1F, 40}));
        box_.draw(program_);
        // Shadows are unlit floor: the flower once more, flat, a hair above it.
        paint({0.58F, 0.60F, 0.62F}, {0.47F, 0.50F, 0.54F}, 0);
        petals(projections::shadow_matrix(sun(), 0.002F), false);
        petals(glm::mat4(1), true);
    }

private:
    static gl::Mesh upload(const Shape& shape) { return gl::Mesh(shape.positions, shape.normals, shape.indices); }
    static glm::vec3 sun() { return glm::normalize(glm::vec3(-0.8F, 1.3F, 0.5F)); }

    void paint(const glm::vec3& even, const glm::vec3& odd, float lit) const
    {
        program_.set("color", even);
        program_.set("color_of_odd_tiles", odd);
        program_.set("lit", lit);
    }

    void petals(const glm::mat4& world, bool painted) const
    {
        constexpr Ring rings[] = {{12, 0, 1.35F, 0.05F}, {12, 0.2617994F, 1.05F, 0.50F}, {8, 0.1F, 0.72F, 0.95F}};
        const glm::vec3 heart = 0.62F * normalize(flower_axis);
        const glm::mat4 frame = flower_frame(glm::vec3(0));
        for (const Ring& ring : rings) {
            // The petal as it grows at angle 0; everything else is the student's rotation about the axis.
            const glm::mat4 raised = glm::rotate(frame, ring.rise, {0, 0, 1});
            const glm::mat4 twisted = glm::scale(glm::rotate(raised, 0.35F, {1, 0, 0}), glm::vec3(ring.length));
            for (int i = 0; i < ring.petals; ++i) {
                const float turn = static_cast<float>(i) / static_cast<float>(ring.petals);
                const glm::mat4 rotation = rotation_matrix({flower_axis, ring.first + 6.2831853F * turn});
                const glm::vec3 color = hue(turn + 0.1F * ring.rise);
                if (painted) paint(color, color, 1);
                program_.set("model", world * glm::translate(glm::mat4(1), heart) * rotation * twisted);
                petal_.draw(program_);
            }
        }
        if (painted) paint({0.80F, 0.52F, 0.10F}, {0.80F, 0.52F, 0.10F}, 1);
        const glm::mat4 along = glm::scale(glm::rotate(frame, -1.5707963F, {1, 0, 0}), {1.8F, 1.8F, 1.75F});
        program_.set("model", world * along);
        arrow_.draw(program_);
    }

    gl::Mesh petal_;
    gl::Mesh box_;
    gl::Mesh arrow_;
    gl::Program program_;
};

/// 320 x 320 pixels.
inline Image draw_flower()
{
    const gl::Framebuffer frame(640, 640);
    frame.clear({0.62F, 0.74F, 0.86F, 1});
    glEnable(GL_DEPTH_TEST);
    Flower().draw();
    return halved(frame.read_pixels());
}

}
