#pragma once

#include <array>
#include <cmath>
#include <kit/numbers_changed.hpp>
#include <string>
#include <utility>
#include <vector>

#include "../rays.hpp"
#include "directions.hpp"
#include "room.hpp"

/// What the unit is asked beside its pictures.
namespace umbral::raytracing {

/// A place of a lamp, seen from a point.
struct LampView {
    glm::vec3 point;
    AreaLamp lamp;
    glm::vec3 on_lamp;
};

inline std::vector<std::pair<glm::vec3, glm::vec3>> cosines_by_hand(Variation& vary)
{
    const auto [a, b] = vary.one_of(
        std::pair{0.6F, 0.8F},
        std::array{std::pair{5.0F / 13, 12.0F / 13}, std::pair{8.0F / 17, 15.0F / 17}, std::pair{0.28F, 0.96F}});
    return {{{0, 0, 1}, {0, 0, 1}}, {{0, 1, 0}, {a, b, 0}},  {{0, 0, -1}, {0, b, -a}}, {{0, 0, 1}, {0, 0, -1}},
            {{1, 0, 0}, {0, a, b}}, {{0, 1, 0}, {b, -a, 0}}, {{a, 0, b}, {1, 0, 0}},   {{a, 0, b}, {0, 0, 1}}};
}

/// From above and below, from beside, with edges of several lengths that are not always perpendicular.
inline std::vector<LampView> lamps_by_hand(Variation& vary)
{
    const AreaLamp unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}};
    const AreaLamp wide{{-1, 2, -1}, {4, 0, 0}, {0, 0, 2}, {5, 5, 5}};
    const AreaLamp slanted{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 1}};
    const glm::vec3 middle(0.5F, 0.5F, 0);
    std::vector<LampView> views{
        {{0.5F, 0.5F, 1}, unit, middle},  {{0.5F, 0.5F, 3}, unit, middle},  {{0.5F, 0.5F, -2}, unit, middle},
        {{3.5F, 4.5F, 12}, unit, middle}, {{0.5F, 4.5F, 3}, unit, middle},  {{0, 0, 0}, wide, {0, 2, 0}},
        {{1, 0, 0}, wide, {1, 2, 0}},     {{-1, 3.5F, 1}, wide, {1, 2, 1}}, {{2, 1, 2}, slanted, {2, 0.5F, 0}}};
    // Lamps grow or shrink about the place that is looked at: exactly, by a power of two.
    const float size = vary.one_of(1.0F, std::array{0.25F, 0.5F, 2.0F, 4.0F});
    for (auto& [point, lamp, on_lamp] : views)
        lamp = {on_lamp + size * (lamp.corner - on_lamp), size * lamp.edge_a, size * lamp.edge_b, lamp.radiance};
    return views;
}

inline std::vector<LampView> random_lamps(Random& random, int count)
{
    std::vector<LampView> views;
    for (int i = 0; i < count; ++i) {
        const float scale = std::exp2(random.uniform(-6, 6));
        AreaLamp lamp{scale * random.in_cube(), scale * random.uniform(0.5F, 2) * random.unit_vector(), {}, {1, 1, 1}};
        // Edges at an angle of 50 degrees at least, and the line to the point at 70 degrees from the normal at most.
        const glm::vec3 along = normalize(lamp.edge_a);
        const glm::vec3 across(perpendicular_to(along, random));
        lamp.edge_b = scale * random.uniform(0.3F, 1.5F) * normalize(across + random.uniform(-0.8F, 0.8F) * along);
        const float a = random.uniform();
        const glm::vec3 place = lamp.corner + a * lamp.edge_a + random.uniform() * lamp.edge_b;
        const glm::vec3 normal = (random.below(2) == 0 ? 1.0F : -1.0F) * normalize(cross(along, across));
        const glm::vec3 aside(perpendicular_to(normal, random));
        const glm::vec3 direction = normalize(normal + random.uniform(0, 2.7F) * aside);
        views.push_back({place + scale * random.uniform(1, 5) * direction, lamp, place});
    }
    return views;
}

/// The same direction about one normal after the other, and the same normal with one direction after the other; unit
/// vectors in the planes of two axes, and equal ones.
inline std::vector<std::pair<glm::vec3, glm::vec3>> cosines_changed(Random& random)
{
    const auto in_plane = [&](int axis) {
        const float angle = random.uniform(0, 6.2831853F);
        glm::vec3 found(0);
        found[(axis + 1) % 3] = std::cos(angle);
        found[(axis + 2) % 3] = std::sin(angle);
        return found;
    };
    std::vector<std::pair<glm::vec3, glm::vec3>> all;
    for (int i = 0; i < 18; ++i) {
        const glm::vec3 normal = in_plane(i);
        const glm::vec3 direction = random.unit_vector();
        const glm::vec3 another = in_plane(i / 3);
        for (const auto& pair : {std::pair(normal, direction),
                                 {normal, another},
                                 {direction, another},
                                 {direction, direction},
                                 {normal, direction}})
            all.push_back(pair);
    }
    return all;
}

/// The same lamp and place from points with one coordinate changed; then, each as the one before but for one thing,
/// another place of the lamp, longer edges, and other light, which takes no part.
inline std::vector<LampView> changed_views(Random& random, LampView view)
{
    // The line to the point is at 70 degrees from the normal at most, and neither short nor long.
    const float size = length(view.lamp.edge_a);
    const auto allowed = [&](const glm::vec3& point, const glm::vec3& on_lamp) {
        const glm::vec3 way = point - on_lamp;
        const glm::vec3 normal = normalize(cross(view.lamp.edge_a, view.lamp.edge_b));
        return length(way) > 0.5F * size && length(way) < 10 * size && std::abs(dot(normalize(way), normal)) > 0.34F;
    };
    std::vector<LampView> all;
    for (const glm::vec3& point : numbers_changed(
             random, view.point, 3, [&](const glm::vec3& changed) { return allowed(changed, view.on_lamp); }))
        all.push_back({point, view.lamp, view.on_lamp});
    view = all.back();
    const glm::vec3 another = glm::mix(view.on_lamp, view.lamp.corner, random.uniform(0.2F, 1));
    if (allowed(view.point, another)) view.on_lamp = another;
    all.push_back(view);
    // From the same corner on, so that the place remains one of the lamp's.
    for (glm::vec3* const edge : {&view.lamp.edge_a, &view.lamp.edge_b}) {
        *edge *= random.uniform(1.25F, 2);
        all.push_back(view);
    }
    view.lamp.radiance = {random.below(2) == 0 ? 0 : random.uniform(), random.uniform(0, 9), random.uniform()};
    all.push_back(view);
    return all;
}

/// Where no reflected light takes part: straight at what shines, or with no surface that reflects.
struct SeenRay {
    Ray ray;
    int bounces;
    int samples;
    bool black;
};

/// A lamp that hangs over a floor that shines a little, and the sky.
inline DiffuseRoom lamp_and_floor(const glm::vec3& floor, const glm::vec3& lamp)
{
    DiffuseRoom room({{0.25F, 0.5F, 1}, {0.5F, 0.75F, 0}});
    room.add(SolidQuad{{-2, 0, -2}, {0, 0, 4}, {4, 0, 0}}, Paint{floor, {0.5F, 0.25F, 0.125F}});
    room.add_lamp({{-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, {4, 8, 2}}, lamp);
    return room;
}
inline DiffuseRoom open_room() { return lamp_and_floor({0.75F, 0.5F, 0.25F}, glm::vec3(0.5F)); }
inline DiffuseRoom black_room() { return lamp_and_floor(glm::vec3(0), glm::vec3(0)); }

inline std::vector<SeenRay> seen_rays(Random& random)
{
    std::vector<SeenRay> rays;
    for (int i = 0; i < 96; ++i) {
        const float x = random.uniform(-0.9F, 0.9F);
        const glm::vec3 above(x, 2, random.uniform(-0.9F, 0.9F));
        const glm::vec3 eye = i % 4 == 1 ? above + random.uniform(0.5F, 2) * glm::vec3(0.25F, 1, 0.5F)
                                         : glm::vec3(3 * random.uniform(-0.6F, 0.6F), 1, x);
        const glm::vec3 floor(x, 0, above.z);
        const glm::vec3 sky = eye + glm::vec3(x > 0 ? 3 : -3, random.uniform(0, 2), above.z);
        const glm::vec3 target = i % 4 == 2 ? floor : i % 4 == 3 ? sky : above;
        const bool black = i / 4 % 2 == 1;
        constexpr std::array bounces{1, 4, all_bounces};
        constexpr std::array samples{1, 3, 16};
        const float length = i % 3 == 0 ? 1.0F : random.uniform(0.2F, 3);
        rays.push_back({Ray{eye, length * normalize(target - eye)}, black ? bounces[random.below(3)] : 0,
                        samples[random.below(3)], black});
    }
    return rays;
}

/// One question to path_light, asked again and again.
struct RoomView {
    const char* name;
    DiffuseRoom room;
    Ray ray;
    int bounces;
    int samples;
    bool takes_turns = false;  ///< at an address where other rooms were before
};

/// The views with their rooms in other light, if inputs are to vary.
inline std::vector<RoomView> varied(Variation& vary, std::vector<RoomView> views)
{
    for (RoomView& view : views) view.room = view.room.varied(vary);
    return views;
}

inline std::string names_of_views(const std::vector<RoomView>& views)
{
    std::vector<std::string> all;
    for (const RoomView& view : views)
        for (const char* colour : {"red", "green", "blue"})
            all.push_back(std::string("The ") + colour + " light of " + view.name);
    return numbered_names(all);
}

/// A floor of albedo (0.8, 0.5, 0.2) under lamps and sky, and where it is looked at.
inline RoomView floor_view(const char* name, const RoomSky& sky, const std::vector<AreaLamp>& lamps)
{
    RoomView view{name, DiffuseRoom(sky), Ray{{1, 1.5F, 2}, {-1, -1.5F, -2}}, 1, 16};
    view.room.add(SolidQuad{{-8, 0, -8}, {0, 0, 16}, {16, 0, 0}}, Paint{{0.8F, 0.5F, 0.2F}});
    for (const AreaLamp& lamp : lamps) view.room.add_lamp(lamp);
    return view;
}

/// Twenty lamps in four rows that shine down, in several colours.
inline std::vector<AreaLamp> rows_of_lamps()
{
    std::vector<AreaLamp> lamps;
    for (int i = 0; i < 20; ++i) {
        const glm::vec3 colour(1.0F + static_cast<float>(i % 3), 4.0F - static_cast<float>(i % 4), 2);
        const glm::vec3 corner(0.5F * static_cast<float>(i % 5) - 1.25F, 0.7F, 0.5F * static_cast<float>(i / 5) - 1.4F);
        lamps.push_back({corner, {0.4F, 0, 0}, {0, 0, 0.4F}, 0.5F * colour});
    }
    return lamps;
}

/// Light that is reflected once, or few times: each view has an answer of its own.
inline std::vector<RoomView> one_bounce()
{
    const AreaLamp over{{-0.75F, 1, -0.5F}, {1.5F, 0, 0}, {0, 0, 1}, {2, 3, 4}};
    const AreaLamp aside{{-1.5F, 0.5F, -1.25F}, {0, 1.5F, 0}, {0, 0, 2.5F}, {5, 2, 3}};
    AreaLamp turned = over;
    std::swap(turned.edge_a, turned.edge_b);
    std::vector<RoomView> views{
        floor_view("the sky on the floor", {{0.2F, 0.4F, 0.6F}, {1.5F, 1, 0.5F}}, {}),
        floor_view("a lamp overhead", {}, {over}), floor_view("two lamps", {}, {aside, over}),
        floor_view("a lamp that is turned away, under the sky", {glm::vec3(0.3F), glm::vec3(0.9F)}, {turned}),
        floor_view("a lamp behind a screen", {}, {over}), floor_view("a glowing ball beside a lamp", {}, {over}),
        floor_view("a lamp that mirrors the floor's light", {}, {}),
        floor_view("a small strong lamp near the floor", {},
                   {{{-0.15F, 0.5F, -0.15F}, {0.3F, 0, 0}, {0, 0, 0.3F}, {200, 120, 160}}}),
        floor_view("twenty lamps", {}, rows_of_lamps()),
        floor_view("a ceiling that is one lamp", {}, {{{-4, 1.6F, -4}, {8, 0, 0}, {0, 0, 8}, {0.5F, 0.3F, 0.7F}}}),
        // Walls that shine on each other, of which one bounce knows nothing.
        floor_view("a lamp between walls", {}, {over})};
    views[4].room.add(SolidQuad{{-2, 0.5F, -2}, {1.75F, 0, 0}, {0, 0, 4}}, Paint{glm::vec3(0)});
    views[5].room.add(SolidBall{{1.2F, 0.8F, -0.3F}, 0.7F}, Paint{glm::vec3(0.5F), {1, 2, 0.5F}});
    views[6].room.add_lamp(over, {0.9F, 0.6F, 0.3F});
    views[6].bounces = 3;
    for (const float x : {-0.9F, 1.1F})
        views[10].room.add(SolidQuad{{x, 0, -2}, {0, 2, 0}, {0, 0, 4}}, Paint{glm::vec3(0.9F)});
    return views;
}

/// Views whose estimates all differ a little, without long tails, however they are made: lamps may be missed.
inline std::vector<RoomView> promised_views()
{
    std::vector<RoomView> views{floor_view("the sky on the floor", {{0.2F, 0.4F, 0.6F}, {1.5F, 1, 0.5F}}, {}),
                                floor_view("a sky with a dark zenith", {{1, 0.8F, 0.9F}, {0.1F, 0.2F, 0.3F}}, {})};
    views[1].bounces = all_bounces;
    return views;
}

}
