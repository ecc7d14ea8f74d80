#pragma once

#include <cmath>
#include <kit/varied.hpp>
#include <optional>
#include <string>
#include <umbral/core/random.hpp>
#include <umbral/raytracing/area_lamp.hpp>
#include <utility>
#include <vector>

#include "solids.hpp"

/// Solids with diffuse paint, and lamps among them.
namespace umbral::raytracing {

/// The paint of a solid; with `checks` above 0, every second square of that size in x and z has the albedo `second`.
struct Paint {
    glm::vec3 albedo;
    glm::vec3 emitted{0};
    glm::vec3 second{0};
    float checks = 0;
};

struct PaintedHit {
    SolidHit solid;
    glm::vec3 albedo;
    glm::vec3 emitted;
    int lamp;  ///< its place among the lamps, -1 for what is none
};

/// What is left of light, if inputs are to vary: so little of each channel that no estimate is near what it was.
inline glm::vec3 share_of_light(Variation& vary) { return shares(vary, 0.35F, 0.65F); }

/// A base of scenes: what they look like is added solid by solid.
class PaintedSolids {
public:
    template <class Solid>
    void add(const Solid& solid, const Paint& paint)
    {
        solids_.add(solid);
        looks_.push_back({paint, -1});
    }
    /// A lamp is dark from behind, and reflects what `albedo` says on both sides.
    void add_lamp(const AreaLamp& lamp, const glm::vec3& albedo = glm::vec3(0))
    {
        solids_.add(SolidQuad{lamp.corner, lamp.edge_a, lamp.edge_b});
        looks_.push_back({Paint{albedo, lamp.radiance}, static_cast<int>(lamps_.size())});
        lamps_.push_back(lamp);
    }
    /// A block without a floor: four sides and a lid. `x` and `z` lie in the floor, and cross(z, x) points up.
    void add_block(const glm::vec3& corner, const glm::vec3& x, const glm::vec3& z, float height, const Paint& paint)
    {
        const glm::vec3 up(0, height, 0);
        add(SolidQuad{corner + up, z, x}, paint);
        add(SolidQuad{corner, up, x}, paint);
        add(SolidQuad{corner + z, x, up}, paint);
        add(SolidQuad{corner, z, up}, paint);
        add(SolidQuad{corner + x, up, z}, paint);
    }
    /// Other light and other paint, if inputs are to vary. Paint becomes a little darker, so that no path is longer.
    void darken(Variation& vary)
    {
        for (Look& look : looks_) {
            look.paint.albedo *= shares(vary, 0.75F, 0.95F);
            look.paint.second *= shares(vary, 0.75F, 0.95F);
            look.paint.emitted *= share_of_light(vary);
            if (look.lamp >= 0) lamps_[static_cast<std::size_t>(look.lamp)].radiance = look.paint.emitted;
        }
    }

protected:
    [[nodiscard]] std::optional<PaintedHit> painted_hit(const Ray& ray, float time = 0) const
    {
        const std::optional<SolidHit> hit = solids_.nearest(ray, time);
        if (!hit) return std::nullopt;
        const auto& [paint, lamp] = looks_[hit->index];
        const bool shines = lamp < 0 || hit->front;
        return PaintedHit{*hit, albedo_at(paint, hit->position), shines ? paint.emitted : glm::vec3(0), lamp};
    }
    [[nodiscard]] bool between(const glm::vec3& from, const glm::vec3& to, float time = 0) const
    {
        return solids_.between(from, to, time);
    }
    [[nodiscard]] const std::vector<AreaLamp>& all_lamps() const { return lamps_; }

private:
    struct Look {
        Paint paint;
        int lamp;
    };
    static glm::vec3 albedo_at(const Paint& paint, const glm::vec3& place)
    {
        if (paint.checks <= 0) return paint.albedo;
        const float column = std::floor(place.x / paint.checks);
        const float row = std::floor(place.z / paint.checks);
        return std::fmod(std::abs(column + row), 2.0F) < 0.5F ? paint.albedo : paint.second;
    }

    Solids solids_;
    std::vector<Look> looks_;
    std::vector<AreaLamp> lamps_;
};

/// Two vectors in the floor, turned by an angle, for add_block().
inline std::pair<glm::vec3, glm::vec3> turned_base(float size, float angle)
{
    return {size * glm::vec3(std::cos(angle), 0, -std::sin(angle)),
            size * glm::vec3(std::sin(angle), 0, std::cos(angle))};
}

/// A generator for one estimate, so that estimates are independent of each other, whatever becomes of its numbers.
inline Random own_random(Random& random)
{
    const std::uint64_t high = random.bits();
    return Random(high << 32U | random.bits());
}

/// What reports call the components of a table, in their order.
inline std::string numbered_names(const std::vector<std::string>& names)
{
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) text += std::to_string(i) + ' ' + names[i] + '\n';
    return text;
}

}
