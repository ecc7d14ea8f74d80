#pragma once

#include <kit/varied.hpp>
#include <umbral/record/variation.hpp>

#include "stage.hpp"

/// What the cases of texturing/projected show.
namespace umbral::texturing {

/// A rose window in linear light: petals of coloured glass between bars of lead, on black.
inline Grid<glm::vec4> rose_window(int size)
{
    return painted(size, [](glm::vec2 p) {
        const float radius = length(p);
        const float angle = std::atan2(p.y, p.x) / shapes::turn;
        const auto petal = [&](float count, float shift) {
            return std::abs(glm::fract(count * angle + shift) - 0.5F) * 2;  // 0 in the middle of a petal, 1 at its bars
        };
        const glm::vec3 ruby(0.85F, 0.08F, 0.07F);
        const glm::vec3 cobalt(0.08F, 0.20F, 0.85F);
        const glm::vec3 amber(1.0F, 0.55F, 0.06F);
        const glm::vec3 emerald(0.10F, 0.55F, 0.28F);
        glm::vec3 glass(0);
        if (radius < 0.13F)
            glass = amber;
        else if (radius < 0.20F)
            glass = petal(12, 0) < 0.8F ? ruby : glm::vec3(0);
        else if (radius < 0.58F) {
            // Long petals, rounded where they end.
            const float across = petal(12, 0.5F) * radius * 0.262F;
            const float wide = 0.80F * 0.262F * std::min(radius, 0.47F);
            const float beyond = std::max(0.0F, radius - 0.47F);
            if (across * across + beyond * beyond < wide * wide)
                glass = mix(cobalt, emerald, glm::smoothstep(0.24F, 0.50F, radius));
            else if (radius > 0.44F)
                glass = petal(12, 0) < 0.42F && radius > 0.49F ? amber : glm::vec3(0);
        } else if (radius < 0.62F) {
            glass = glm::vec3(0);
        } else if (radius < 0.86F) {
            // Medallions, with a ground of ruby.
            const float at = (glm::fract(24 * angle) - 0.5F) * shapes::turn / 24 * 0.74F;
            const float from = length(glm::vec2(at, radius - 0.74F));
            glass = from < 0.055F ? amber : from < 0.072F ? glm::vec3(0) : from < 0.092F ? cobalt : 0.75F * ruby;
            if (petal(24, 0) > 0.94F) glass = glm::vec3(0);
        } else if (radius > 0.89F && radius < 0.96F) {
            glass = petal(48, 0) < 0.86F ? mix(emerald, amber, 0.35F) : glm::vec3(0);
        }
        // One pane of the rim is clear: the window shows which way is up.
        if (radius > 0.62F && radius < 0.86F && std::abs(glm::fract(angle - 0.25F + 0.5F) - 0.5F) < 0.021F)
            glass = glm::vec3(1.0F, 0.95F, 0.8F);
        return glass;
    });
}

inline shapes::Shape plane(const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up)
{
    shapes::Shape shape;
    shape.quad(corner, along, up);
    return shape;
}

/// A half cylinder from `low` to `high`, open to the viewer; with a dome, a quarter of a sphere above it.
inline shapes::Shape niche(const glm::vec3& centre, float radius, float low, float high, bool dome)
{
    return shapes::woven(96, dome ? 48 : 1, [&](float u, float v) {
        const float turn = 3.1415927F * u;
        const float rise = dome ? 1.5707963F * v : 0;
        const glm::vec3 out(std::cos(rise) * -std::cos(turn), std::sin(rise), std::cos(rise) * -std::sin(turn));
        const float height = dome ? high : low + v * (high - low);
        return shapes::Vertex{centre + glm::vec3(0, height, 0) + radius * out, -out};
    });
}

/// Steps up into an apse; the window is in the viewer's back.
inline Scene steps()
{
    Scene scene;
    const glm::vec3 stone(0.80F, 0.74F, 0.66F);
    shapes::Shape treads;
    shapes::Shape risers;
    constexpr int count = 7;
    constexpr float rise = 0.2F;
    for (int i = 0; i < count; ++i) {
        const float y = rise * static_cast<float>(i);
        const float z = 2.2F - 0.5F * static_cast<float>(i);
        treads.quad({-4.6F, y, z}, {9.2F, 0, 0}, {0, 0, i + 1 < count ? -0.5F : -6.0F});
        if (i > 0) risers.quad({-4.6F, y - rise, z}, {9.2F, 0, 0}, {0, rise, 0});
    }
    treads.quad({-9, 0, 9}, {18, 0, 0}, {0, 0, -6.8F});
    scene.things.push_back({treads, glm::mat4(1), stone});
    scene.things.push_back({risers, glm::mat4(1), 0.58F * stone});
    const glm::vec3 middle(0, 1.2F, -1.4F);
    for (int course = 0; course < 6; ++course) {
        const float low = 0.45F * static_cast<float>(course);
        scene.things.push_back(
            {niche(middle, 3.6F, low, low + 0.45F, false), glm::mat4(1), (course % 2 == 0 ? 0.95F : 0.62F) * stone});
    }
    scene.things.push_back({niche(middle, 3.6F, 0, 2.7F, true), glm::mat4(1), 0.8F * stone});
    for (const float side : {-1.0F, 1.0F})
        scene.things.push_back(
            {plane({side * 3.6F, 0, -1.4F}, {side * 6, 0, 0}, {0, 9, 0}), glm::mat4(1), 0.45F * stone});
    scene.projector = projector_at({-2.4F, 6.0F, 8.0F}, {0.25F, 1.45F, -1.2F}, 33);
    scene.projector.lamp = glm::vec3(1.75F, 1.6F, 1.4F);
    scene.projector.ambient = {0.115F, 0.110F, 0.130F};
    scene.eye = {1.7F, 3.0F, 8.6F};
    scene.target = {0, 1.75F, -1};
    scene.fovy_degrees = 36;
    return scene;
}

/// The projector straight before a wall: the slide as it is, upright.
inline Scene wall()
{
    Scene scene;
    scene.things.push_back({plane({-3, -2.5F, 0}, {6, 0, 0}, {0, 5, 0}), glm::mat4(1), glm::vec3(0.9F)});
    scene.projector = projector_at({0.3F, 0.2F, 4}, {0.3F, 0.2F, 0}, 45, 1.4F);
    scene.eye = {0, 0, 6};
    return scene;
}

/// The projector in the middle of a corridor whose walls all face it: one of the two ends has the picture.
inline Scene corridor()
{
    Scene scene;
    const auto add = [&](const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up) {
        scene.things.push_back({plane(corner, along, up), glm::mat4(1), glm::vec3(0.85F)});
    };
    add({-2, -1, -6}, {4, 0, 0}, {0, 3, 0});   // the far end
    add({2, -1, 6}, {-4, 0, 0}, {0, 3, 0});    // the near one, behind the viewer
    add({-2, -1, 6}, {0, 0, -12}, {0, 3, 0});  // left
    add({2, -1, -6}, {0, 0, 12}, {0, 3, 0});   // right
    add({-2, -1, 6}, {4, 0, 0}, {0, 0, -12});  // floor
    scene.projector = projector_at({0, 0.4F, 0}, {0.4F, 0.2F, 4}, 62);
    scene.projector.ambient = glm::vec3(0.12F);
    scene.projector.lamp = glm::vec3(1.4F);
    scene.eye = {0, 0.6F, 5.9F};
    scene.target = {0, 0.4F, 0};
    scene.fovy_degrees = 62;
    return scene;
}

/// A low projector over a floor of two triangles that reaches behind it.
inline Scene floor_of_two_triangles()
{
    Scene scene;
    scene.things.push_back({plane({-7, 0, 7}, {14, 0, 0}, {0, 0, -14}), glm::mat4(1), glm::vec3(0.85F)});
    scene.projector = projector_at({-1.5F, 1.6F, 3.4F}, {0.5F, 0, 0.2F}, 38);
    scene.projector.lamp = glm::vec3(2.2F);
    scene.eye = {0, 6.5F, 6};
    scene.target = {0, 0, 0.3F};
    return scene;
}

/// Balls that are stretched and turned: half of each faces away from the projector. One has few faces: between its
/// vertices the interpolated normals are much shorter than at them. The triangles of every second ball run the other
/// way round: normals say which side is lit, and the order of the corners does not.
inline Scene stretched_balls()
{
    Scene scene;
    const shapes::Shape ball = shapes::sphere(64, 32);
    const shapes::Shape few_faces = shapes::sphere(8, 4);
    for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<float>(i);
        const glm::mat4 at = glm::rotate(glm::translate(glm::mat4(1), {1.5F * k - 2.25F, 0, 0}), 0.7F * k + 0.3F,
                                         glm::normalize(glm::vec3(0.3F, 0.4F, 1)));
        shapes::Shape shape = i == 1 ? few_faces : ball;
        if (i % 2 == 0)
            for (std::size_t first = 0; first < shape.indices.size(); first += 3)
                std::swap(shape.indices[first], shape.indices[first + 1]);
        scene.things.push_back({shape, glm::scale(at, {0.35F + 0.1F * k, 0.95F, 0.65F - 0.1F * k}), glm::vec3(0.9F)});
    }
    scene.projector = projector_at({3, 3.2F, 4.0F}, {0, 0, 0}, 50);
    scene.projector.lamp = glm::vec3(1.3F);
    scene.eye = {0, 0.6F, 6.5F};
    return scene;
}

/// An asymmetric frustum: the axis does not go through the middle of the slide.
inline Scene shifted_lens()
{
    Scene scene = wall();
    scene.projector.projection = glm::frustum(-0.02F, 0.07F, -0.05F, 0.015F, 0.1F, 20.0F);
    return scene;
}

/// A scene that is written down, varied: it is seen from another side, and the slide is turned and has other light.
/// As written unless inputs are to vary.
inline Scene varied(Variation& vary, Scene scene)
{
    if (!vary) return scene;
    scene.eye = other_eye(vary, scene.eye, scene.target, 0.25F);
    scene.projector.view = glm::mat4(vary.turn({0, 0, 1}, 0.8F)) * scene.projector.view;
    scene.projector.lamp *= vary.near(glm::vec3(0.85F), 0.15F);
    return scene;
}

}
