#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/numbers_changed.hpp>
#include <tuple>
#include <umbral/projections/stereo.hpp>

/// Screens, pairs of cameras, and chains of questions about them in which one number changes.
namespace umbral::projections {

/// A screen from a telephone to a cinema, seen by eyes of 1 to 20 % of its width.
inline StereoScreen random_screen(Random& random)
{
    const float width = std::pow(10.0F, random.uniform(-1, 1));
    const float height = width * random.uniform(0.4F, 2);
    const float distance = width * random.uniform(0.5F, 4);
    const float separation = width * random.uniform(0.01F, 0.2F);
    const float near_plane = distance * random.uniform(0.05F, 1.5F);
    return {width, height, distance, separation, near_plane, near_plane * std::pow(10.0F, random.uniform(0.2F, 4))};
}

/// The same in another unit of length.
inline StereoScreen in_units(const StereoScreen& s, float unit)
{
    return {unit * s.width,          unit * s.height,     unit * s.distance,
            unit * s.eye_separation, unit * s.near_plane, unit * s.far_plane};
}

/// One in three in a unit of length in which all numbers are tiny: a tolerance that is a length is wrong there.
inline StereoScreen in_some_units(const StereoScreen& screen, int i, Random& random)
{
    return in_units(screen, i % 3 == 0 ? std::pow(10.0F, random.uniform(-9, -5)) : 1.0F);
}

/// A pair of cameras as somebody has set them up: turned inwards and against each other, one a little higher. Not the
/// student's, so that a wrong pair does not hide a wrong disparity.
inline StereoPair given_pair(const StereoScreen& s, Random& random)
{
    const auto eye = [&](float x) {
        const glm::vec3 target(0.1F * s.distance * random.in_cube() - glm::vec3(0, 0, s.distance));
        const glm::vec3 up(random.uniform(-0.1F, 0.1F), 1, 0);
        const float aside = random.uniform(-0.2F, 0.2F);
        return EyeMatrices{glm::lookAt(glm::vec3(x, 0, 0), target, up),
                           glm::frustum(aside - 0.5F, aside + 0.5F, -0.4F, 0.4F, 1.0F, 1000.0F)};
    };
    const EyeMatrices left = eye(-s.eye_separation / 2);
    return {left, eye(s.eye_separation / 2)};
}

/// A point that both eyes have before them.
inline glm::vec3 point_before(const StereoScreen& s, Random& random)
{
    const float depth = s.distance * random.uniform(0.5F, 10);
    return depth * glm::vec3(random.uniform(-0.5F, 0.5F), random.uniform(-0.5F, 0.5F), -1);
}

/// Screens as random ones are, but that one number differs from the one before.
inline std::vector<StereoScreen> changed_screens(Random& random)
{
    return numbers_changed(random, random_screen(random), 6, [](const StereoScreen& s) {
        return s.width > 0 && s.height > 0 && s.distance > 0.1F * s.width && s.eye_separation > 0 && s.near_plane > 0 &&
               s.far_plane > 1.5F * s.near_plane;
    });
}

using ScreenAndNumber = std::tuple<StereoScreen, float>;

/// A point's distance that changes alone, or the screen. Not next to the screen's: that is asked by itself.
inline std::vector<ScreenAndNumber> changed_distances(Random& random)
{
    const StereoScreen screen = random_screen(random);
    const ScreenAndNumber first(screen, screen.distance * random.uniform(1.2F, 8));
    return numbers_changed(random, first, 7, [](const ScreenAndNumber& question) {
        const auto& [s, distance] = question;
        const float share = distance / s.distance;
        return s.distance > 0 && s.eye_separation > 0 && s.eye_separation < 2 && share > 0.1F &&
               std::abs(share - 1) > 0.05F;
    });
}

/// Likewise a parallax, which is 0, too.
inline std::vector<ScreenAndNumber> changed_parallaxes(Random& random)
{
    const StereoScreen screen = random_screen(random);
    const ScreenAndNumber first(screen, screen.eye_separation * random.uniform(-4, 0.8F));
    return numbers_changed(random, first, 7, [](const ScreenAndNumber& question) {
        const auto& [s, parallax] = question;
        return s.distance > 0 && s.eye_separation > 0 && parallax < 0.9F * s.eye_separation &&
               parallax > -8 * s.eye_separation;
    });
}

/// Points that both eyes have before them, in the middle of one coordinate or of both among them.
inline std::vector<glm::vec3> changed_points(Random& random, const StereoScreen& screen)
{
    return numbers_changed(random, point_before(screen, random), 3, [&](const glm::vec3& point) {
        return point.z < -0.5F * screen.distance && std::abs(point.x) < -0.5F * point.z &&
               std::abs(point.y) < -0.5F * point.z;
    });
}

}
