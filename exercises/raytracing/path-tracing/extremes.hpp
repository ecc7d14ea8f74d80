#pragma once

#include "questions.hpp"

/// Light in places where shortcuts show that elsewhere cost next to nothing: near, dark and far ones.
namespace umbral::raytracing {

/// Paths whose share of the light is small bring all that is seen, or lamps and surfaces are next to the floor. Nothing
/// is nearer than three thousandths: whoever starts rays a thousandth away, to keep them off their own surface, loses
/// nothing. So many samples are asked for that survival by albedo finds the light about once in each row.
inline std::vector<RoomView> near_and_dark()
{
    constexpr RoomSky bright{{1, 0.8F, 0.6F}, {6, 8, 10}};
    RoomView dark = floor_view("a dark floor under a bright sky", {}, {});
    dark.room = DiffuseRoom(bright);
    dark.room.add(SolidQuad{{-8, 0, -8}, {0, 0, 16}, {16, 0, 0}}, Paint{{0.018F, 0.014F, 0.010F}});
    dark.samples = 128;

    // The floor's patch lies above all that shines, and sees it by the roof alone.
    RoomView roof{"a dark floor below a dark roof, two bounces", DiffuseRoom(),
                  Ray{{0.4F, 0.6F, 0.8F}, {-1, -1.5F, -2}}, 2, 768};
    roof.room.add(SolidQuad{{-0.25F, 0, -0.25F}, {0, 0, 0.5F}, {0.5F, 0, 0}}, Paint{{0.08F, 0.05F, 0.06F}});
    roof.room.add(SolidQuad{{-1, 1, -1}, {2, 0, 0}, {0, 0, 2}}, Paint{{0.06F, 0.05F, 0.04F}});
    roof.room.add(SolidQuad{{-1, -0.05F, -1}, {0, 0, 2}, {2, 0, 0}}, Paint{glm::vec3(0), {400, 600, 500}});

    RoomView green = floor_view("a floor without red under the sky", {}, {});
    green.room = DiffuseRoom(bright);
    green.room.add(SolidQuad{{-8, 0, -8}, {0, 0, 16}, {16, 0, 0}}, Paint{{0, 0.6F, 0.4F}});

    RoomView plates = floor_view("a floor three thousandths below a plate that shines", {}, {});
    plates.room.add(SolidQuad{{-4, 0.003F, -4}, {8, 0, 0}, {0, 0, 8}}, Paint{glm::vec3(0), {1, 2, 3}});
    plates.ray = Ray{{0.1F, 0.0015F, 0.2F}, {-1, -0.015F, -2}};

    // All of it is nearer than a tenth.
    const AreaLamp lamp{{-0.06F, 0.04F, -0.06F}, {0.08F, 0, 0}, {0, 0, 0.08F}, {3, 4, 5}};
    return {dark, roof, green, plates, floor_view("a floor right below a small lamp", {}, {lamp})};
}

/// A corridor between two walls, in which each reflection carries the light a step on, whatever its direction: only
/// from a step on the walls shine. So a path sees light after just so many reflections, however it is estimated.
class Corridor final : public DiffuseScene {
public:
    Corridor(int shines_from, const glm::vec3& light) : shines_from_(static_cast<float>(shines_from)), light_(light) {}

    [[nodiscard]] std::optional<DiffusePoint> first_hit(const Ray& ray) const override
    {
        const float step = std::floor(ray.origin.x + 1.5F);
        const bool up = ray.direction.y > 0;
        return DiffusePoint{
            {step, up ? 1 : 0, 0}, {0, up ? -1 : 1, 0}, glm::vec3(0.95F), step < shines_from_ ? glm::vec3(0) : light_};
    }
    [[nodiscard]] bool blocked(const glm::vec3& /*from*/, const glm::vec3& /*to*/) const override { return false; }
    [[nodiscard]] glm::vec3 sky(const glm::vec3& /*direction*/) const override { return glm::vec3(0); }
    [[nodiscard]] const std::vector<AreaLamp>& lamps() const override { return no_lamps_; }

    /// From before the step 0.
    [[nodiscard]] static Ray entrance() { return Ray{{-1, 0.5F, 0}, {0, -1, 0}}; }

private:
    float shines_from_;
    glm::vec3 light_;
    std::vector<AreaLamp> no_lamps_;
};

/// Whether any light is found in a corridor.
struct CorridorQuestion {
    const char* name;
    Corridor corridor;
    int bounces;
    int samples;
};

/// With light behind 66 reflections, and without. Of ten thousand paths that go on with a chance of 0.9 from the fifth
/// reflection on, 16 see it: all miss it once in ten million times. With a chance of 0.95 it is nearly three hundred.
inline std::vector<CorridorQuestion> corridors(Case& c)
{
    constexpr int steps = 66;
    const auto light = [&] { return 20.0F * share_of_light(c.vary); };
    const Corridor shining(steps, light());
    return in_random_order(
        c.random, std::vector<CorridorQuestion>{{"corridor", shining, all_bounces, 10000},
                                                {"corridor", Corridor(steps, light()), all_bounces, 10000},
                                                {"dark_corridor", Corridor(steps, glm::vec3(0)), all_bounces, 100},
                                                {"corridor", shining, steps - 1, 100}});
}

}
