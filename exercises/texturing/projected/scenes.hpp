#pragma once

#include <kit/magnitude.hpp>
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
/// vertices the interpolated normals are much shorter than at them.
inline Scene stretched_balls()
{
    Scene scene;
    const shapes::Shape ball = shapes::sphere(64, 32);
    const shapes::Shape few_faces = shapes::sphere(8, 4);
    for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<float>(i);
        const glm::mat4 at = glm::rotate(glm::translate(glm::mat4(1), {1.5F * k - 2.25F, 0, 0}), 0.7F * k + 0.3F,
                                         glm::normalize(glm::vec3(0.3F, 0.4F, 1)));
        scene.things.push_back(
            {i == 1 ? few_faces : ball, glm::scale(at, {0.35F + 0.1F * k, 0.95F, 0.65F - 0.1F * k}), glm::vec3(0.9F)});
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

/// Turned, stretched and moved.
inline glm::mat4 random_model(Random& random)
{
    glm::mat4 matrix = glm::translate(glm::mat4(1), 3.0F * random.in_cube());
    matrix = glm::rotate(matrix, random.uniform(0, 6.28F), random.unit_vector());
    return glm::scale(matrix, glm::vec3(1.1F) + 0.6F * random.in_cube());
}

inline Projector random_projector(Random& random)
{
    const glm::vec3 position = 4.0F * random.in_cube();
    const glm::vec3 target = position + random.unit_vector();
    const float fovy = random.uniform(20, 100);
    Projector projector = projector_at(position, target, fovy, random.uniform(0.6F, 1.6F));
    projector.lamp = glm::vec3(0.6F) + 0.4F * random.in_cube();
    projector.ambient = glm::vec3(0.15F) + 0.1F * random.in_cube();
    return projector;
}

/// A point that the projector has at (x, y) of its picture, both in [-1, 1], and that far along its axis; behind it if
/// that is negative, where x and y are mirrored.
inline glm::vec3 at_picture(const Projector& projector, glm::vec2 place, float distance)
{
    const glm::mat4& p = projector.projection;
    const glm::vec3 eye((place.x + p[2][0]) * distance / p[0][0], (place.y + p[2][1]) * distance / p[1][1], -distance);
    return glm::vec3(inverse(projector.view) * glm::vec4(eye, 1));
}

/// The same point with lengths in another unit: its colour is the same.
inline Point in_unit(Point point, float unit)
{
    point.projector.position *= unit;
    point.place *= unit;
    for (glm::mat4* const matrix : {&point.projector.view, &point.model})
        (*matrix)[3] = glm::vec4(unit * glm::vec3((*matrix)[3]), 1);
    return point;
}

/// In the beam, beside it, and behind the projector, 2 % from the beam's border at least, in any unit of length.
inline std::vector<Point> random_points(Random& random, int count)
{
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        Point point;
        point.projector = random_projector(random);
        const bool beside = random.below(4) == 0;
        glm::vec2 place = 0.98F * glm::vec2(random.in_cube());
        const float outside = random.uniform(1.02F, 2);
        if (beside) place[random.below(2) == 0 ? 0 : 1] = random.below(2) == 0 ? outside : -outside;
        const float distance = random.uniform(0.3F, 8) * (random.below(3) == 0 ? -1.0F : 1.0F);
        point.place = at_picture(point.projector, place, distance);
        point.normal =
            glm::normalize(random.unit_vector() + 1.3F * glm::normalize(point.projector.position - point.place));
        point.color = glm::vec3(0.6F) + 0.35F * random.in_cube();
        point.model = random_model(random);
        points.push_back(in_unit(point, random_unit(random, -10, 10)));
    }
    return points;
}

/// Where a quotient has no value, or a term vanishes, and on the beam's border; between them ordinary points.
inline std::vector<Point> edges()
{
    std::vector<Point> points;
    const Projector projector = projector_at({0, 0, 0}, {0, 0, -1}, 90);
    const auto add = [&](const glm::vec3& place, const glm::vec3& normal) {
        points.push_back({projector, place, normal, {0.8F, 0.6F, 0.4F}, glm::mat4(1)});
    };
    // Its clip coordinates are x, y and -z without any rounding.
    Projector exact = projector;
    exact.projection = glm::frustum(-1.0F, 1.0F, -1.0F, 1.0F, 1.0F, 3.0F);
    const auto add_at_border = [&](const glm::vec3& place) {
        points.push_back({exact, place, {0, 0, 1}, {0.8F, 0.6F, 0.4F}, glm::mat4(1)});
    };
    const glm::vec3 back(0, 0, 1);
    for (const float x : {-0.5F, 0.25F}) {
        add({2 * x, 0.5F, -2}, back);                         // ordinary
        add({2 * x, 0.5F, 2}, -back);                         // its mirror image behind the projector
        add({x, 1, 0}, glm::vec3(0, -1, 0));                  // on the projector's plane: w = 0
        add({0, 0, 0}, back);                                 // where the projector is
        add({2 * x, 0.5F, -2}, -back);                        // faces away
        add({x, 0, -1}, glm::normalize(glm::vec3(1, 0, x)));  // grazing
        add({0.02F * x, 0.01F, -0.03F}, back);                // nearer than the projector's near plane
        add({2e-4F * x, 1e-4F, -3e-4F}, back);                // … all but in it
        add({100 * x, 20, -160}, back);                       // farther than its far plane
        add({1e4F * x, 2e3F, -1.6e4F}, back);                 // much farther
        add({30 * x, 0, -1}, back);                           // beside the beam, far
        add({0, -30 * x, -1}, back);
        for (const float beyond : {1.0F, 1.0078125F}) {  // on the border, and 1/128 beyond it
            add_at_border({std::copysign(2 * beyond, x), x, -2});
            add_at_border({x, std::copysign(2 * beyond, x), -2});
        }
    }
    return points;
}

}
