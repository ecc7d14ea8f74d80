#include <umbral/texturing/bump.hpp>
#include <umbral/texturing/coordinates.hpp>
#include <umbral/texturing/environment.hpp>
#include <umbral/texturing/mipmap.hpp>

#include "../calls.hpp"
#include "../plain_call.hpp"

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
        call<spherical_coordinates>("texturing::spherical_coordinates"),
        call<cylindrical_coordinates>("texturing::cylindrical_coordinates"),
        call<texturing::mirrored_direction>("texturing::mirrored_direction"),
        {"texturing::box_place", "v", [](Numbers x) { return numbers(box_place(v_at(x, 0)).uv); }},
        call<panorama_place>("texturing::panorama_place"),
        call<panorama_direction>("texturing::panorama_direction"),
        call<sphere_place>("texturing::sphere_place"),
        call<sphere_direction>("texturing::sphere_direction"),
        call<level_at_distance>("texturing::level_at_distance"),
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
