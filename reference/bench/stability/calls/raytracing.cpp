#include <umbral/raytracing/cylinder_cone.hpp>
#include <umbral/raytracing/disc.hpp>
#include <umbral/raytracing/intersect.hpp>
#include <umbral/raytracing/reflect_refract.hpp>
#include <umbral/raytracing/triangle.hpp>

#include "../calls.hpp"

namespace umbral::bench {
namespace {

using namespace stability;
using namespace raytracing;

Answer some(const std::optional<float>& value) { return value ? Answer{*value} : Answer{}; }
Ray ray(Numbers x) { return {v_at(x, 0), v_at(x, 3)}; }

}

std::vector<Call> raytracing_calls()
{
    return {
        {"raytracing::intersect sphere", "{vv}{vf}",
         [](Numbers x) {
             return some(intersect(ray(x), Sphere{v_at(x, 6), x[9]}));
         }},
        {"raytracing::intersect disc", "{vv}{vvf}",
         [](Numbers x) {
             return some(intersect(ray(x), Disc{v_at(x, 6), v_at(x, 9), x[12]}));
         }},
        {"raytracing::intersect triangle", "{vv}{vvv}",
         [](Numbers x) {
             const auto hit = intersect(ray(x), Triangle{v_at(x, 6), v_at(x, 9), v_at(x, 12)});
             return hit ? Answer{hit->t} : Answer{};
         }},
        {"raytracing::unit_cylinder_field", "v", [](Numbers x) { return numbers(unit_cylinder_field(v_at(x, 0))); }},
        {"raytracing::unit_cone_field", "v", [](Numbers x) { return numbers(unit_cone_field(v_at(x, 0))); }},
        {"raytracing::mirrored_direction", "vv",
         [](Numbers x) { return numbers(raytracing::mirrored_direction(v_at(x, 0), v_at(x, 3))); }},
        {"raytracing::critical_angle", "ff", [](Numbers x) { return some(critical_angle(x[0], x[1])); }},
    };
}

}
