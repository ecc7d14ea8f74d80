#pragma once

#include <array>
#include <cmath>
#include <string>
#include <umbral/core/random.hpp>
#include <umbral/raytracing/distributed.hpp>
#include <vector>

#include "../painted_solids.hpp"

/// Scenes in which balls move, and cameras for them.
namespace umbral::raytracing {

/// The sky's light, from the horizon (direction.y = 0) to the zenith, and what reaches every surface.
struct StageLight {
    glm::vec3 horizon{0};
    glm::vec3 zenith{0};
    glm::vec3 ambient{0};
};

class StillLife final : public MovingScene, public PaintedSolids {
public:
    explicit StillLife(const StageLight& light = {}) : light_(light) {}

    [[nodiscard]] std::optional<LitPoint> first_hit(const Ray& ray, float time) const override
    {
        const std::optional<PaintedHit> hit = painted_hit(ray, time);
        if (!hit) return std::nullopt;
        return LitPoint{hit->solid.position, hit->solid.normal, hit->albedo, hit->emitted};
    }
    [[nodiscard]] bool blocked(const glm::vec3& from, const glm::vec3& to, float time) const override
    {
        return between(from, to, time);
    }
    [[nodiscard]] glm::vec3 sky(const glm::vec3& direction) const override
    {
        return glm::mix(light_.horizon, light_.zenith, std::max(0.0F, direction.y / length(direction)));
    }
    [[nodiscard]] glm::vec3 ambient() const override { return light_.ambient; }
    [[nodiscard]] const std::vector<AreaLamp>& lamps() const override { return all_lamps(); }

    /// The scene in other light and other paint, if inputs are to vary.
    [[nodiscard]] StillLife varied(Variation& vary) const
    {
        StillLife other = *this;
        // A sky that is the same everywhere remains so.
        const glm::vec3 share = share_of_light(vary);
        other.light_ = {share * light_.horizon, share * light_.zenith, share_of_light(vary) * light_.ambient};
        other.darken(vary);
        return other;
    }

private:
    StageLight light_;
};

/// What a lens and a shutter do to a camera.
struct Optics {
    float lens_radius = 0;
    float focus_depth = 1;
    float shutter_opens = 0;
    float shutter_closes = 0;
};

/// A camera at `eye` that looks at `target`, with y up.
inline LensCamera camera_towards(const glm::vec3& eye, const glm::vec3& target, float half_height, const Optics& optics)
{
    const glm::vec3 back = normalize(eye - target);
    const glm::vec3 right = normalize(cross(glm::vec3(0, 1, 0), back));
    return {eye,
            right,
            cross(back, right),
            back,
            half_height,
            optics.lens_radius,
            optics.focus_depth,
            optics.shutter_opens,
            optics.shutter_closes};
}

/// The still life of the goal picture: a row of balls, of which one is sharp, one that falls, and lights far behind.
inline StillLife goal_still_life()
{
    StillLife life({{0.012F, 0.016F, 0.035F}, {0.03F, 0.04F, 0.09F}, glm::vec3(0.035F, 0.04F, 0.06F)});
    Paint table{glm::vec3(0.62F, 0.54F, 0.45F)};
    table.second = {0.30F, 0.20F, 0.15F};
    table.checks = 0.5F;
    life.add(SolidQuad{{-40, 0, -40}, {0, 0, 60}, {80, 0, 0}}, table);
    constexpr std::array colours{glm::vec3(0.80F, 0.13F, 0.08F), glm::vec3(0.88F, 0.50F, 0.06F),
                                 glm::vec3(0.80F, 0.72F, 0.20F), glm::vec3(0.14F, 0.52F, 0.26F),
                                 glm::vec3(0.08F, 0.30F, 0.60F)};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const auto n = static_cast<float>(i);
        life.add(SolidBall{{-1.15F + 0.72F * n, 0.34F, 1.75F - 1.2F * n}, 0.34F}, Paint{colours[i]});
    }
    life.add(SolidBall{{-0.45F, 1.75F, -0.4F}, 0.26F, {0.3F, -0.95F, 0}}, Paint{glm::vec3(0.85F)});
    const auto [x, z] = turned_base(0.62F, 0.5F);
    life.add_block({0.95F, 0, 0.75F}, x, z, 0.62F, Paint{glm::vec3(0.62F, 0.60F, 0.66F)});
    life.add(SolidBall{{1.38F, 0.86F, 0.88F}, 0.24F}, Paint{{0.62F, 0.24F, 0.50F}});
    for (int i = 0; i < 13; ++i) {
        const auto n = static_cast<float>(i);
        const float place = 2.0F * (n - 6) + 0.7F * std::sin(7 * n);
        const glm::vec3 glow = i % 3 == 0   ? glm::vec3(1, 0.42F, 0.12F)
                               : i % 3 == 1 ? glm::vec3(1, 0.78F, 0.38F)
                                            : glm::vec3(0.25F, 0.5F, 1);
        life.add(SolidBall{{place, 1.2F + 0.9F * std::sin(2.4F * n), -14 + 1.5F * std::cos(3 * n)}, 0.16F},
                 Paint{glm::vec3(0), 7.0F * glow});
    }
    life.add_lamp({{-3.4F, 2.9F, 0.9F}, {0.75F, 0.9F, 0}, {0.2F, 0, 1.1F}, glm::vec3(46, 39, 30)});
    return life;
}

inline LensCamera goal_camera()
{
    return camera_towards({0.45F, 2.0F, 5.0F}, {0.08F, 0.70F, -0.2F}, 0.38F, {0.11F, 4.75F, 0, 0.4F});
}

inline glm::vec3 random_colour(Random& random, float low, float high)
{
    const float red = random.uniform(low, high);
    const float green = random.uniform(low, high);
    return {red, green, random.uniform(low, high)};
}

/// Balls that move, a block, two lamps over a table, with other numbers for every seed.
inline StillLife random_still_life(Random& random)
{
    const glm::vec3 horizon = random_colour(random, 0.1F, 0.5F);
    const glm::vec3 zenith = random_colour(random, 0.1F, 0.7F);
    StillLife life({horizon, zenith, random_colour(random, 0.05F, 0.3F)});
    Paint table{random_colour(random, 0.4F, 0.8F)};
    table.second = random_colour(random, 0.05F, 0.3F);
    table.checks = 0.6F;
    life.add(SolidQuad{{-8, 0, -8}, {0, 0, 16}, {16, 0, 0}}, table);
    for (int i = 0; i < 4; ++i) {
        const float radius = random.uniform(0.25F, 0.4F);
        const glm::vec3 place(-1.2F + 0.8F * static_cast<float>(i), radius, random.uniform(-2.0F, 1.5F));
        const glm::vec3 velocity = (i % 2 == 0 ? 0.0F : 0.6F) * random.unit_vector();
        life.add(SolidBall{place + 0.5F * glm::abs(velocity), radius, velocity},
                 Paint{random_colour(random, 0.1F, 0.9F), 0.3F * random_colour(random, 0, 1)});
    }
    const auto [x, z] = turned_base(random.uniform(0.3F, 0.7F), random.uniform(-0.7F, 0.7F));
    const float height = random.uniform(0.3F, 1.0F);
    life.add_block({random.uniform(-0.8F, 0.4F), 0, -0.8F}, x, z, height, Paint{random_colour(random, 0.2F, 0.8F)});
    for (int i = 0; i < 2; ++i) {
        const float side = i == 0 ? -2.5F : 1.2F;
        const glm::vec3 light = random_colour(random, 2, 7);
        life.add_lamp({{side, random.uniform(2, 3), random.uniform(-1, 0.5F)}, {1.2F, 0, 0}, {0, 0.2F, 1.3F}, light});
    }
    return life;
}

inline LensCamera random_still_life_camera(Random& random)
{
    const glm::vec3 eye(random.uniform(-0.8F, 0.8F), random.uniform(0.9F, 1.6F), 4);
    const glm::vec3 target(0, 0.5F, random.uniform(-0.5F, 0.5F));
    // Wide: what is out of focus is spread over many of the few pixels of the picture.
    const float radius = random.uniform(0.2F, 0.45F);
    const float focus = random.uniform(2.5F, 5);
    return camera_towards(eye, target, random.uniform(0.3F, 0.45F), {radius, focus, random.uniform(-0.3F, 0), 0.6F});
}

}
