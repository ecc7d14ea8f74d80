#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/random.hpp>
#include <umbral/core/ray.hpp>
#include <umbral/raytracing/area_lamp.hpp>
#include <vector>

namespace umbral::raytracing {

/// A point of a diffuse surface, as a ray has met it.
struct DiffusePoint {
    glm::vec3 position;  ///< a little off the surface, on the side from which it was met: rays may start here
    glm::vec3 normal;    ///< unit, to that side
    glm::vec3 albedo;    ///< share of the light that is reflected, in [0, 1]; equally bright in all directions
    glm::vec3 emitted;   ///< radiance of the surface's own light, to that side
    int lamp = -1;       ///< its place in DiffuseScene::lamps(), if it is one of them; -1 otherwise
};

/// A scene whose surfaces are all diffuse, as path_light() sees it. All functions may be called as often as you like,
/// and give the same answers each time.
class DiffuseScene {
public:
    virtual ~DiffuseScene() = default;

    /// The first surface along the ray, whose direction need not be unit; nothing if it leaves the scene.
    [[nodiscard]] virtual std::optional<DiffusePoint> first_hit(const Ray& ray) const = 0;

    /// Does anything stand between two points? What lies within 1e-3 of `to` does not count, so that `to` may lie on a
    /// lamp. `from` is a DiffusePoint's position.
    [[nodiscard]] virtual bool blocked(const glm::vec3& from, const glm::vec3& to) const = 0;

    /// The radiance that comes from far away against `direction`, which need not be unit: what a ray finds that leaves
    /// the scene.
    [[nodiscard]] virtual glm::vec3 sky(const glm::vec3& direction) const = 0;

    /// The lamps, perhaps none. They are surfaces of the scene too: rays hit them, and `emitted` is their `radiance` on
    /// the bright side, and 0 behind. Other surfaces may shine as well, and are not listed here.
    [[nodiscard]] virtual const std::vector<AreaLamp>& lamps() const = 0;
};

/// Light however often it was reflected.
inline constexpr int all_bounces = std::numeric_limits<int>::max();

/// A unit direction on the side of the unit vector `normal`, drawn with the density cos(theta) / pi per steradian,
/// where theta is its angle with the normal. Works for every unit normal. Successive ones are independent.
[[nodiscard]] glm::vec3 cosine_direction(const glm::vec3& normal, Random& random);

/// That density at `direction`, per steradian: cos(theta) / pi, and 0 on the other side. Both vectors are unit.
[[nodiscard]] float cosine_density(const glm::vec3& normal, const glm::vec3& direction);

/// The density per steradian, seen from `point`, of the directions to places of the lamp that are drawn uniformly over
/// its area: r² / (area |cos|), where r is the distance of `on_lamp` and |cos| the cosine of the angle between the line
/// to it and the lamp's normal, of either sign. `point` does not lie in the lamp's plane.
/// Guarantee of the reference: relative error below 1e-5 for cosines above 0.05.
[[nodiscard]] float lamp_density(const glm::vec3& point, const AreaLamp& lamp, const glm::vec3& on_lamp);

/// An estimate of the radiance that comes back along `ray`: the mean of `samples` (> 0) paths.
///
/// Counted is the light of surfaces and sky that was reflected at most `bounces` times (>= 0) on its way: with 0 what
/// shines by itself, with 1 also what that light makes of other surfaces, and so on; with all_bounces everything.
/// **Unbiased**: its expectation is exactly that radiance, whatever `samples` is. How directions are chosen, and how
/// paths end, is free. With all_bounces, albedos are below 1 or rays leave the scene, so that paths can end.
///
/// All random numbers come from `random`, so that a seed gives the same picture again; how many are drawn is free, and
/// calls keep nothing for the next one. Course: path tracing (Kajiya 1986).
[[nodiscard]] glm::vec3 path_light(const DiffuseScene& scene, const Ray& ray, int bounces, int samples, Random& random);

}
