#pragma once

#include "questions.hpp"

/// Scenes in which light goes on for long, and lamps that are switched on and off.
namespace umbral::raytracing {

/// Inside a closed surface that shines everywhere alike, E with the albedo a, all that is seen is
/// E (1 + a + … + a^bounces).
inline RoomView furnace(const char* name, const glm::vec3& albedo, int bounces, int samples,
                        const glm::vec3& shining = {0.5F, 1, 0.75F})
{
    RoomView view{name, DiffuseRoom(), Ray{{0.3F, -0.2F, 0.1F}, {0.3F, 0.5F, -0.7F}}, bounces, samples};
    view.room.add(SolidBall{{0, 0, 0}, 1}, Paint{albedo, shining});
    return view;
}

/// Light that was reflected often is much of the light: paths must not stop. Paint is not varied here: were it darker,
/// paths would be shorter.
inline std::vector<RoomView> long_paths(Variation& vary)
{
    // Paths go on for as long as red paint has them go on, and what they bring is green and blue: the thirteenth
    // reflection is still a twentieth of it. That red has no light of its own keeps the variance finite, for uniform
    // directions and survival by albedo too.
    return {furnace("a furnace that shines green and blue, all bounces", {0.95F, 0.8F, 0.75F}, all_bounces, 40,
                    share_of_light(vary) * glm::vec3(0, 1, 0.75F)),
            furnace("a bright furnace, twenty bounces", {0.9F, 0.85F, 0.88F}, 20, 16,
                    share_of_light(vary) * glm::vec3(0.75F, 0.5F, 1))};
}

/// One room at one address, in which a lamp is off at first, and then on: what is kept of its lamps is wrong then.
inline std::vector<RoomView> switched_lamps()
{
    const AreaLamp over{{-0.75F, 1, -0.5F}, {1.5F, 0, 0}, {0, 0, 1}, glm::vec3(0)};
    const AreaLamp aside{{-1.5F, 0.5F, -1.25F}, {0, 1.5F, 0}, {0, 0, 2.5F}, {5, 2, 3}};
    AreaLamp lit = over;
    lit.radiance = {3, 4, 2.5F};
    std::vector<RoomView> views{floor_view("two lamps, one of them off", {}, {over, aside}),
                                floor_view("the same lamps, both on", {}, {lit, aside})};
    for (RoomView& view : views) view.takes_turns = true;
    return views;
}

/// Albedos stay below 3/4 where all bounces count: with uniform directions and survival by albedo, the variance of an
/// estimate is infinite beyond.
inline std::vector<RoomView> furnaces()
{
    std::vector<RoomView> views{furnace("a furnace, one bounce", {0.8F, 0.5F, 0.2F}, 1, 8),
                                furnace("a furnace, two bounces", {0.4F, 0.8F, 0.6F}, 2, 8),
                                furnace("a furnace, six bounces", {0.7F, 0.5F, 0.6F}, 6, 8),
                                furnace("a furnace, all bounces", {0.6F, 0.3F, 0.5F}, all_bounces, 8),
                                furnace("a furnace of red and blue, six bounces", {0.45F, 0, 0.3F}, 6, 8),
                                furnace("a furnace of green and blue, six bounces", {0, 0.45F, 0.3F}, 6, 8),
                                furnace("a furnace of red and green, six bounces", {0.3F, 0.45F, 0}, 6, 8)};
    // The sky's light above all, found by long paths and by short ones, which leave in other directions.
    RoomView niche{"a deep niche under the sky, all bounces", DiffuseRoom({{0.5F, 0.75F, 1}, {2, 1, 0.5F}}),
                   Ray{{0.1F, 1, 0.5F}, {-0.3F, -0.2F, -1}}, all_bounces, 256};
    add_walls(niche.room, {glm::vec3(0.7F), {0.7F, 0.6F, 0.5F}, {0.5F, 0.6F, 0.7F}, glm::vec3(0.7F), glm::vec3(0.7F)});
    niche.room.add_lamp({{-0.2F, 1.9F, -0.2F}, {0.4F, 0, 0}, {0, 0, 0.4F}, {0.3F, 0.4F, 0.2F}}, glm::vec3(0.5F));
    views.push_back(niche);
    // Two colours that shine on each other, and a lamp among them.
    RoomView box{"a closed box, all bounces", DiffuseRoom(), Ray{{0.2F, 0.9F, 0.8F}, {-0.5F, -0.6F, -1}}, all_bounces,
                 8};
    add_walls(box.room,
              {{0.6F, 0.3F, 0.5F}, {0.6F, 0.2F, 0.2F}, {0.2F, 0.6F, 0.4F}, glm::vec3(0.6F), glm::vec3(0.65F)});
    box.room.add(SolidQuad{{-1, 0, 1}, {2, 0, 0}, {0, 2, 0}}, Paint{glm::vec3(0.5F)});
    box.room.add_lamp({{-0.7F, 1.99F, -0.7F}, {1.4F, 0, 0}, {0, 0, 1.4F}, {3, 3, 3}}, glm::vec3(0.6F));
    views.push_back(box);
    return views;
}

}
