#pragma once

#include <array>
#include <cmath>
#include <umbral/core/grid.hpp>
#include <umbral/raytracing/path_tracing.hpp>
#include <utility>
#include <vector>

#include "../painted_solids.hpp"

/// Rooms of diffuse walls, blocks and balls, with lamps and a sky.
namespace umbral::raytracing {

/// A sky whose light grows from the horizon (direction.y = 0) to the zenith; below, it is that of the horizon.
struct RoomSky {
    glm::vec3 horizon{0};
    glm::vec3 zenith{0};
};

class DiffuseRoom final : public DiffuseScene, public PaintedSolids {
public:
    explicit DiffuseRoom(const RoomSky& sky = {}) : sky_(sky) {}

    [[nodiscard]] std::optional<DiffusePoint> first_hit(const Ray& ray) const override
    {
        const std::optional<PaintedHit> hit = painted_hit(ray);
        if (!hit) return std::nullopt;
        return DiffusePoint{hit->solid.position, hit->solid.normal, hit->albedo, hit->emitted, hit->lamp};
    }
    [[nodiscard]] bool blocked(const glm::vec3& from, const glm::vec3& to) const override { return between(from, to); }
    [[nodiscard]] glm::vec3 sky(const glm::vec3& direction) const override
    {
        return glm::mix(sky_.horizon, sky_.zenith, std::max(0.0F, direction.y / length(direction)));
    }
    [[nodiscard]] const std::vector<AreaLamp>& lamps() const override { return all_lamps(); }

    /// The room in other light and other paint, if inputs are to vary.
    [[nodiscard]] DiffuseRoom varied(Variation& vary) const
    {
        DiffuseRoom other = *this;
        const glm::vec3 share = share_of_light(vary);
        other.sky_ = {share * sky_.horizon, share * sky_.zenith};
        other.darken(vary);
        return other;
    }

private:
    RoomSky sky_;
};

/// The five walls that a camera sees of a box from (-1, 0, -1) to (1, 2, 1), the front open.
struct WallPaints {
    glm::vec3 floor;
    glm::vec3 left;
    glm::vec3 right;
    glm::vec3 back;
    glm::vec3 ceiling;
};

inline void add_walls(DiffuseRoom& room, const WallPaints& paints)
{
    const glm::vec3 x(2, 0, 0);
    const glm::vec3 y(0, 2, 0);
    const glm::vec3 z(0, 0, 2);
    const glm::vec3 corner(-1, 0, -1);
    room.add(SolidQuad{corner, z, x}, Paint{paints.floor});
    room.add(SolidQuad{corner, y, z}, Paint{paints.left});
    room.add(SolidQuad{corner + x, z, y}, Paint{paints.right});
    room.add(SolidQuad{corner, x, y}, Paint{paints.back});
    room.add(SolidQuad{corner + y, x, z}, Paint{paints.ceiling});
}

/// The box of the goal picture.
inline DiffuseRoom cornell_room()
{
    constexpr glm::vec3 plaster(0.74F, 0.72F, 0.68F);
    DiffuseRoom room({{0.32F, 0.36F, 0.42F}, {0.32F, 0.36F, 0.42F}});
    add_walls(room, {plaster, {0.66F, 0.12F, 0.07F}, {0.07F, 0.30F, 0.42F}, plaster, plaster});
    room.add_lamp({{-0.55F, 1.99F, -0.5F}, {1.1F, 0, 0}, {0, 0, 1.0F}, {7.5F, 6, 4.1F}}, glm::vec3(0.7F));
    const auto [tall_x, tall_z] = turned_base(0.58F, 0.32F);
    room.add_block({-0.76F, 0, -0.55F}, tall_x, tall_z, 1.16F, Paint{plaster});
    const auto [low_x, low_z] = turned_base(0.56F, -0.3F);
    room.add_block({0.1F, 0, 0.02F}, low_x, low_z, 0.5F, Paint{{0.78F, 0.60F, 0.30F}});
    room.add(SolidBall{{0.45F, 0.76F, 0.22F}, 0.26F}, Paint{plaster});
    room.add(SolidBall{{-0.30F, 0.17F, 0.62F}, 0.17F}, Paint{{0.25F, 0.55F, 0.24F}});
    return room;
}

inline glm::vec3 random_albedo(Random& random)
{
    const float red = random.uniform(0.1F, 0.85F);
    const float green = random.uniform(0.1F, 0.85F);
    return {red, green, random.uniform(0.1F, 0.85F)};
}

/// A box with other colours, lamps, blocks and a window to the sky for every seed.
inline DiffuseRoom random_room(Random& random)
{
    const auto colour = [&] { return random_albedo(random); };
    DiffuseRoom room({glm::vec3(0.3F) + 0.4F * colour(), glm::vec3(0.2F) + 0.8F * colour()});
    const glm::vec3 floor = colour();
    const glm::vec3 left = colour();
    const glm::vec3 right = colour();
    add_walls(room, {floor, left, right, colour(), colour()});
    for (int i = 0; i < 2; ++i) {
        const float x = random.uniform(-0.95F, -0.8F) + 0.95F * static_cast<float>(i);
        const float z = random.uniform(-0.8F, 0.1F);
        const glm::vec3 light = 0.4F + 1.0F * colour();
        const glm::vec3 albedo = colour();
        room.add_lamp(
            {{x, random.uniform(1.4F, 1.75F), z}, {0.8F, random.uniform(-0.2F, 0.2F), 0}, {0, 0, 0.8F}, light}, albedo);
        const auto [side_x, side_z] = turned_base(random.uniform(0.3F, 0.6F), random.uniform(-0.6F, 0.6F));
        const float height = random.uniform(0.3F, 1.0F);
        room.add_block({x, 0, z - 0.1F}, side_x, side_z, height, Paint{colour()});
    }
    // A ball that shines, and is no lamp of the list.
    const float place = random.uniform(-0.6F, 0.6F);
    const glm::vec3 glow = 0.4F * colour();
    room.add(SolidBall{{place, 0.2F, 0.65F}, 0.2F}, Paint{colour(), glow});
    return room;
}

}
