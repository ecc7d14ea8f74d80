#include <umbral/texturing/bump.hpp>
#include <umbral/texturing/coordinates.hpp>
#include <umbral/texturing/environment.hpp>
#include <umbral/texturing/mipmap.hpp>

#include "../calls.hpp"

namespace umbral::bench {
namespace {

using namespace stability;
using namespace texturing;

}

std::vector<Call> texturing_calls()
{
    return {
        {"texturing::planar_coordinates", "v{vvv}",
         [](Numbers x) {
             return numbers(planar_coordinates(v_at(x, 0), {v_at(x, 3), v_at(x, 6), v_at(x, 9)}));
         }},
        {"texturing::spherical_coordinates", "v", [](Numbers x) { return numbers(spherical_coordinates(v_at(x, 0))); }},
        {"texturing::cylindrical_coordinates", "vff",
         [](Numbers x) { return numbers(cylindrical_coordinates(v_at(x, 0), x[3], x[4])); }},
        {"texturing::mirrored_direction", "vv",
         [](Numbers x) { return numbers(texturing::mirrored_direction(v_at(x, 0), v_at(x, 3))); }},
        {"texturing::box_place", "v", [](Numbers x) { return numbers(box_place(v_at(x, 0)).uv); }},
        {"texturing::panorama_place", "v", [](Numbers x) { return numbers(panorama_place(v_at(x, 0))); }},
        {"texturing::panorama_direction", "u", [](Numbers x) { return numbers(panorama_direction(u_at(x, 0))); }},
        {"texturing::sphere_place", "v", [](Numbers x) { return numbers(sphere_place(v_at(x, 0))); }},
        {"texturing::sphere_direction", "u", [](Numbers x) { return numbers(sphere_direction(u_at(x, 0))); }},
        {"texturing::level_at_distance", "ff", [](Numbers x) { return numbers(level_at_distance(x[0], x[1])); }},
        {"texturing::level_of_step", "uu{1024,1024}",
         [](Numbers x) {
             return numbers(level_of_step(u_at(x, 0), u_at(x, 2), {1024, 1024}));
         }},
        {"texturing::bumped_normal", "v{vv}u",
         [](Numbers x) {
             return numbers(bumped_normal(v_at(x, 0), {v_at(x, 3), v_at(x, 6)}, u_at(x, 9)));
         }},
    };
}

}
