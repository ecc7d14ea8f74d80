#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/random.hpp>
#include <umbral/core/ray.hpp>
#include <umbral/raytracing/area_lamp.hpp>
#include <vector>

namespace umbral::raytracing {

/// A camera with a thin lens and a shutter. It looks along -back; right, up and back are unit and perpendicular.
struct LensCamera {
    glm::vec3 eye;         ///< the middle of the lens
    glm::vec3 right;       ///< of the picture
    glm::vec3 up;          ///< of the picture
    glm::vec3 back;        ///< against the view
    float half_height;     ///< at the depth 1, the picture is as high as 2 * half_height
    float lens_radius;     ///< 0 for a pinhole
    float focus_depth;     ///< sharp is what lies in the plane at this depth: its distance from the eye along -back
    float shutter_opens;   ///< time at which light begins to count …
    float shutter_closes;  ///< … and ends to; not before it begins
};

/// A picture's width and height in pixels.
struct PictureSize {
    int width;
    int height;
};

/// A point of a diffuse surface, as a ray has met it.
struct LitPoint {
    glm::vec3 position;  ///< a little off the surface, on the side from which it was met: rays may start here
    glm::vec3 normal;    ///< unit, to that side
    glm::vec3 albedo;    ///< share of the light that is reflected
    glm::vec3 emitted;   ///< radiance of its own light, to that side
};

/// A scene in which things move, as pixel_light() sees it. All functions may be called as often as you like, and give
/// the same answers each time.
class MovingScene {
public:
    virtual ~MovingScene() = default;

    /// The first surface along the ray at that time; nothing if the ray leaves the scene. Directions need not be unit.
    [[nodiscard]] virtual std::optional<LitPoint> first_hit(const Ray& ray, float time) const = 0;

    /// Does anything stand between two points at that time? What lies within 1e-3 of `to` does not count, so that `to`
    /// may lie on a lamp. `from` is a LitPoint's position.
    [[nodiscard]] virtual bool blocked(const glm::vec3& from, const glm::vec3& to, float time) const = 0;

    /// What a ray sees that leaves the scene.
    [[nodiscard]] virtual glm::vec3 sky(const glm::vec3& direction) const = 0;

    /// Light that arrives everywhere: a surface reflects albedo * ambient() of it.
    [[nodiscard]] virtual glm::vec3 ambient() const = 0;

    /// The lamps, perhaps none; they do not move. They are surfaces of the scene too.
    [[nodiscard]] virtual const std::vector<AreaLamp>& lamps() const = 0;
};

/// A point drawn uniformly over the area of the unit disc: x² + y² <= 1, but for rounding. Successive ones are
/// independent.
[[nodiscard]] glm::vec2 disc_point(Random& random);

/// The ray that reaches a place of the picture through a point of the lens, of unit direction.
///
/// `place` counts in pixels, x to the right and y down: (0, 0) is the picture's upper left corner, and the middle of
/// pixel (x, y) is (x + 0.5, y + 0.5); pixels are square. `lens` lies in the unit disc: the ray starts at
/// eye + lens_radius * (lens.x * right + lens.y * up). All rays of a place meet at the depth focus_depth, where the ray
/// from the eye does. t_min is 0 and t_max infinite.
/// Guarantee of the reference: origin and direction are within 2e-6 of the exact ones, relative to 1 and to the
/// coordinates.
[[nodiscard]] Ray lens_ray(const LensCamera& camera, PictureSize size, glm::vec2 place, glm::vec2 lens);

/// An estimate of how much of a lamp's light a white diffuse surface reflects: the integral over the lamp's points y of
/// V cos(theta) cos(theta_y) / (pi r²) dy. That is a number in [0, 1], but an estimate may be above 1: clamping it
/// would make the mean too small.
///
/// r is the distance of y; theta its angle with `at.normal`, and theta_y the angle between the lamp's normal and the
/// line back; of each, only positive cosines count. V is 0 if something stands between at `time`, and 1 otherwise. The
/// mean of `samples` (> 0) points of the lamp; **unbiased**, however they are chosen. at.albedo and at.emitted and the
/// lamp's radiance take no part.
[[nodiscard]] float lamp_light(const MovingScene& scene, const LitPoint& at, const AreaLamp& lamp, float time,
                               int samples, Random& random);

/// An estimate of a pixel's light: the mean over the square of the pixel, the area of the lens, and the time from
/// shutter_opens to shutter_closes, each uniform and independent of the others, from `samples` (> 0) rays.
///
/// What a ray sees is the sky, or the surface's emitted + albedo * (ambient + sum over the lamps of radiance *
/// lamp_light). **Unbiased**: its expectation is exactly that mean, whatever `samples` is. How samples are chosen is
/// free. Pixel (0, 0) is the upper left one.
///
/// All random numbers come from `random`, so that a seed gives the same picture again; how many are drawn is free, and
/// calls keep nothing for the next one. Course: distributed ray tracing (Cook 1984).
[[nodiscard]] glm::vec3 pixel_light(const MovingScene& scene, const LensCamera& camera, PictureSize size,
                                    glm::ivec2 pixel, int samples, Random& random);

}
