#include <umbral/lighting/blinn_phong.hpp>
#include <umbral/lighting/brightest_point.hpp>
#include <umbral/lighting/color.hpp>
#include <umbral/lighting/diffuse.hpp>
#include <umbral/lighting/light_direction.hpp>
#include <umbral/lighting/phong.hpp>

#include "../calls.hpp"
#include "../plain_call.hpp"

namespace umbral::bench {
namespace {

using namespace stability;
using namespace lighting;

}

std::vector<Call> lighting_calls()
{
    return {
        call<half_vector>("lighting::half_vector"),
        call<blinn_highlight>("lighting::blinn_highlight"),
        call<phong_highlight>("lighting::phong_highlight"),
        call<lighting::mirrored_direction>("lighting::mirrored_direction"),
        {"lighting::direction_to_light", "{{v,1}}v",
         [](Numbers x) {
             return numbers(direction_to_light({glm::vec4(v_at(x, 0), 1), glm::vec3(1)}, v_at(x, 3)));
         }},
        {"lighting::light_direction", "{ff}",
         [](Numbers x) {
             return numbers(light_direction({x[0], x[1]}));
         }},
        {"lighting::light_angles", "v",
         [](Numbers x) {
             const LightAngles angles = light_angles(v_at(x, 0));
             return joined(angles.longitude_degrees, angles.latitude_degrees);
         }},
        call<encode_srgb>("lighting::encode_srgb"),
        call<decode_srgb>("lighting::decode_srgb"),
        {"lighting::brightest_diffuse", "{vf}{{v,1}}",
         [](Numbers x) {
             return numbers(brightest_diffuse({v_at(x, 0), x[3]}, {glm::vec4(v_at(x, 4), 1), glm::vec3(1)}));
         }},
    };
}

}
