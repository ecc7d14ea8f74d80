#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/ray.hpp>
#include <umbral/lighting/light.hpp>

/// Whitted's ray tracing. Light is linear RGB, at least 0, without an upper bound: nothing is clamped. All directions
/// that are passed on are unit vectors.
namespace umbral::raytracing::whitted {

/// Rays that begin on a surface must not find that surface at once: they begin so far from its point.
inline constexpr float clearance = 1e-4F;

/// How a surface looks: what it reflects of the lights, what it mirrors, and what it lets through.
struct Material {
    lighting::Material local;      ///< M_E; k_a M_A, k_d M_D and k_s M_S as one colour each; e, here 1 to 100
    float mirrored = 0;            ///< k_ps, in [0, 1]
    glm::vec3 mirrored_color{1};   ///< M_PS
    float refracted = 0;           ///< k_t, in [0, 1]
    glm::vec3 refracted_color{1};  ///< M_T
    float index = 1;               ///< of refraction inside, over that outside; > 0
    std::uint32_t texture = 0;     ///< its colour multiplies the ambient and the diffuse reflectance; 0: none
};

/// The first point of a surface on a ray.
struct Hit {
    float t;  ///< along the ray, in lengths of its direction
    glm::vec3 position;
    /// Unit, **outward**: seen from inside, as within a glass ball, it points away from the viewer. Where the surface
    /// has a bump map this is the bent normal.
    glm::vec3 normal;
    glm::vec2 uv;  ///< texture coordinates
    Material material;
};

/// What rays are sent into: surfaces, lights, and what lies behind all of it.
class World {
public:
    virtual ~World() = default;

    /// The first surface on a ray, with t in (t_min, t_max). Directions need not be unit here.
    [[nodiscard]] virtual std::optional<Hit> first_hit(const Ray& ray) const = 0;
    /// The light that comes from a direction in which there is no surface.
    [[nodiscard]] virtual glm::vec3 background(const glm::vec3& direction) const = 0;
    /// The colour of a texture, whose number is not 0.
    [[nodiscard]] virtual glm::vec3 texture_color(std::uint32_t texture, const glm::vec2& uv) const = 0;

    [[nodiscard]] virtual std::span<const lighting::Light> lights() const = 0;
    [[nodiscard]] virtual glm::vec3 ambient() const = 0;  ///< A_G, which every surface sends, whatever its colour
    [[nodiscard]] virtual int max_level() const = 0;      ///< of rays; those from the camera have level 1
};

/// What a surface sends towards v of a light of colour (1, 1, 1) in direction l, if nothing stands between:
///
///     k_a M_A + k_d M_D max(0, n·l) + k_s M_S d max(0, r·v)^e
///
/// where r = 2 (n·l) n - l mirrors **l**, and d is 1 if n·l > 0, and 0 otherwise. The normal n, v and l are unit; they
/// point away from the surface. Right to 1e-4. Course: DIRECTA(p, v, l).
[[nodiscard]] glm::vec3 direct_light(const lighting::Material& material, const glm::vec3& normal, const glm::vec3& v,
                                     const glm::vec3& l);

/// The light that the point of a hit sends towards v, by a ray of this level:
///
///     M_E + A_G + Σ Sᵢ direct_light(…, lᵢ), of the lights that are visible
///         + k_ps M_PS light_along(r) + k_t M_T light_along(t)
///
/// n is the hit's normal, **turned to the side of v**; the texture multiplies the ambient and the diffuse reflectance.
/// A light is visible if no surface, transparent or not, lies between the position and it: from `clearance` on up to
/// the light, or without end if it is directional. n·lᵢ may be negative.
/// r mirrors v. t refracts it: with q = 1 / index, or index if v is inside (hit.normal·v < 0),
/// t = (q n·v - √(1 - q² (1 - (n·v)²))) n - q v. Where the root would be of a negative number there is no t, and the
/// term is 0 (total internal reflection).
/// Both have level + 1, and begin with t_min = `clearance`. Each is asked for once, and only if its k is greater than
/// 0 and that level does not exceed max_level(); all else is so at any level. Course: EVALUAMILREC(O, p, v, n).
[[nodiscard]] glm::vec3 light_towards(const World& world, const Hit& hit, const glm::vec3& v, int level);

/// The light that comes along a ray, and its rays' rays, against its direction: of the first surface that it meets, or
/// of the background; (0, 0, 0) if level > max_level(), and then nothing is asked of the world. The ray's direction is
/// unit. Course: RAYTRACING(o, u, n).
[[nodiscard]] glm::vec3 light_along(const World& world, const Ray& ray, int level);

}
