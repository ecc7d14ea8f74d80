#include <umbral/lighting/blinn_phong.hpp>
#include <umbral/lighting/brightest_point.hpp>
#include <umbral/lighting/color.hpp>
#include <umbral/lighting/diffuse.hpp>
#include <umbral/lighting/light_direction.hpp>
#include <umbral/lighting/phong.hpp>

#include "../calls.hpp"

namespace umbral::bench {
namespace {

using namespace stability;
using namespace lighting;

}

std::vector<Call> lighting_calls()
{
    return {
        {"lighting::half_vector", "vv",
         [](Numbers x) {
             const auto half = half_vector(v_at(x, 0), v_at(x, 3));
             return half ? numbers(*half) : Answer{};
         }},
        {"lighting::blinn_highlight", "vvvf",
         [](Numbers x) { return numbers(blinn_highlight(v_at(x, 0), v_at(x, 3), v_at(x, 6), x[9])); }},
        {"lighting::phong_highlight", "vvvf",
         [](Numbers x) { return numbers(phong_highlight(v_at(x, 0), v_at(x, 3), v_at(x, 6), x[9])); }},
        {"lighting::mirrored_direction", "vv",
         [](Numbers x) { return numbers(lighting::mirrored_direction(v_at(x, 0), v_at(x, 3))); }},
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
        {"lighting::encode_srgb", "f", [](Numbers x) { return numbers(encode_srgb(x[0])); }},
        {"lighting::decode_srgb", "f", [](Numbers x) { return numbers(decode_srgb(x[0])); }},
        {"lighting::brightest_diffuse", "{vf}{{v,1}}",
         [](Numbers x) {
             return numbers(brightest_diffuse({v_at(x, 0), x[3]}, {glm::vec4(v_at(x, 4), 1), glm::vec3(1)}));
         }},
    };
}

}
