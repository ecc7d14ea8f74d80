#pragma once

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <umbral/raytracing/whitted.hpp>
#include <umbral/record/literal.hpp>
#include <utility>
#include <vector>

/// Worlds of balls and panels, which count the rays that are sent into them.
namespace umbral::raytracing::whitted {

struct Ball {
    glm::vec3 centre;
    float radius;
    Material material;
    float relief = 0;  ///< by how much waves on it bend the normal
};

/// A parallelogram, seen from both sides; its normal is that of u x v.
struct Panel {
    glm::vec3 corner;
    glm::vec3 u;
    glm::vec3 v;
    Material material;
};

/// A sky that no two directions share.
inline glm::vec3 coloured_sky(const glm::vec3& direction)
{
    if (direction == glm::vec3(0)) return glm::vec3(1);
    const glm::vec3 d = normalize(direction);
    return {0.5F + 0.4F * d.x, 0.6F - 0.3F * d.y + 0.1F * d.x, 0.5F + 0.35F * d.z};
}

/// Smooth textures, each number another, which do not repeat themselves.
inline glm::vec3 smooth_texture(std::uint32_t texture, const glm::vec2& uv)
{
    if (texture == 0) return {5, 6, 7};  // there is none
    const float turns = 4.9F * uv.x + 2.3F * static_cast<float>(texture);
    return {0.6F + 0.3F * std::sin(turns), 0.5F + 0.4F * std::cos(5.6F * uv.y), 0.35F + 0.2F * std::cos(turns)};
}

class BuiltWorld : public World {
public:
    static constexpr std::uint32_t most_rays = 5000;  ///< for one question

    std::vector<Ball> balls{};
    std::vector<Panel> panels{};
    std::vector<lighting::Light> sources{};
    glm::vec3 global{0};
    int levels = 5;
    glm::vec3 (*sky)(const glm::vec3& direction) = coloured_sky;
    glm::vec3 (*texture)(std::uint32_t texture, const glm::vec2& uv) = smooth_texture;

    [[nodiscard]] std::optional<Hit> first_hit(const Ray& ray) const override
    {
        if (++rays_ > most_rays) throw std::length_error("more than 5000 rays for one: does the recursion end?");
        double end = ray.t_max;
        const Panel* panel = nullptr;
        const Ball* ball = nullptr;
        for (const Panel& each : panels)
            if (const double t = meeting(each, ray, end); t < end) {
                end = t;
                panel = &each;
            }
        for (const Ball& each : balls)
            if (const double t = meeting(each, ray, end); t < end) {
                end = t;
                ball = &each;
            }
        if (ball != nullptr) return hit_of(*ball, ray, end);
        if (panel != nullptr) return hit_of(*panel, ray, end);
        return std::nullopt;
    }
    [[nodiscard]] glm::vec3 background(const glm::vec3& direction) const override { return sky(direction); }
    [[nodiscard]] glm::vec3 texture_color(std::uint32_t number, const glm::vec2& uv) const override
    {
        return texture(number, uv);
    }
    [[nodiscard]] std::span<const lighting::Light> lights() const override { return sources; }
    [[nodiscard]] glm::vec3 ambient() const override { return global; }
    [[nodiscard]] int max_level() const override { return levels; }

    /// How many rays were sent since this was called last.
    [[nodiscard]] std::uint32_t take_rays() const { return std::exchange(rays_, 0); }

private:
    static constexpr double nowhere = std::numeric_limits<double>::infinity();

    static glm::dvec3 at(const Ray& ray, double t) { return glm::dvec3(ray.origin) + t * glm::dvec3(ray.direction); }

    static glm::dvec2 coordinates(const Panel& panel, const glm::dvec3& place)
    {
        const glm::dvec3 across = cross(glm::dvec3(panel.u), glm::dvec3(panel.v));
        const glm::dvec3 from = place - glm::dvec3(panel.corner);
        return glm::dvec2(dot(cross(from, glm::dvec3(panel.v)), across),
                          dot(cross(glm::dvec3(panel.u), from), across)) /
               dot(across, across);
    }

    /// The t in (ray.t_min, end) at which the ray meets it; infinity if there is none.
    static double meeting(const Panel& panel, const Ray& ray, double end)
    {
        const glm::dvec3 across = cross(glm::dvec3(panel.u), glm::dvec3(panel.v));
        const double t =
            dot(across, glm::dvec3(panel.corner) - glm::dvec3(ray.origin)) / dot(across, glm::dvec3(ray.direction));
        if (!(double{ray.t_min} < t && t < end)) return nowhere;
        const glm::dvec2 uv = coordinates(panel, at(ray, t));
        return uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1 ? t : nowhere;
    }

    static double meeting(const Ball& ball, const Ray& ray, double end)
    {
        const glm::dvec3 along(ray.direction);
        const glm::dvec3 from = glm::dvec3(ray.origin) - glm::dvec3(ball.centre);
        const double a = dot(along, along);
        const double middle = -dot(from, along) / a;
        const glm::dvec3 nearest = from + middle * along;
        const double rest = double{ball.radius} * double{ball.radius} - dot(nearest, nearest);
        if (!(rest >= 0)) return nowhere;
        const double half = std::sqrt(rest / a);
        for (const double t : {middle - half, middle + half})
            if (double{ray.t_min} < t && t < end) return t;
        return nowhere;
    }

    static Hit hit_of(const Panel& panel, const Ray& ray, double t)
    {
        const glm::vec3 normal = normalize(cross(panel.u, panel.v));
        const glm::dvec3 place = at(ray, t);
        return {static_cast<float>(t), glm::vec3(place), normal, glm::vec2(coordinates(panel, place)), panel.material};
    }

    static Hit hit_of(const Ball& ball, const Ray& ray, double t)
    {
        const glm::vec3 outwards((at(ray, t) - glm::dvec3(ball.centre)) / double{ball.radius});
        const glm::vec2 uv(std::atan2(outwards.x, outwards.z) / 6.2831853F + 0.5F,
                           std::acos(std::clamp(outwards.y, -1.0F, 1.0F)) / std::numbers::pi_v<float>);
        return {static_cast<float>(t), ball.centre + ball.radius * outwards, bent(outwards, ball.relief), uv,
                ball.material};
    }

    /// Waves round three skew axes.
    static glm::vec3 bent(const glm::vec3& normal, float relief)
    {
        if (relief == 0) return normal;
        glm::vec3 sum = normal;
        for (const glm::vec3 axis : {glm::vec3(9, 2, 4), {-3, 10, 1}, {2, -4, 9}})
            sum += relief * std::sin(dot(axis, normal)) * normalize(axis);
        return normalize(sum);
    }

    mutable std::uint32_t rays_ = 0;
};

/// The world as a line of code, for reports: it is the driver's, under a name that a student can follow.
inline std::string world_in_words(const BuiltWorld& world)
{
    const auto text = [](const auto& value) { return literal::of_value(value, false, literal::in_full); };
    return "// world: balls " + text(world.balls) + ", panels " + text(world.panels) + ", lights " +
           text(world.sources) + ", ambient() " + text(world.global) + ", max_level() " + text(world.levels);
}

}
