#include <umbral/raytracing/cylinder_cone.hpp>
#include <umbral/raytracing/disc.hpp>
#include <umbral/raytracing/intersect.hpp>
#include <umbral/raytracing/path_tracing.hpp>
#include <umbral/raytracing/reflect_refract.hpp>
#include <umbral/raytracing/shadow_polygons.hpp>
#include <umbral/raytracing/sphere_tracing.hpp>
#include <umbral/raytracing/triangle.hpp>

#include "../calls.hpp"
#include "../plain_call.hpp"

namespace umbral::bench {
namespace {

using namespace stability;
using namespace raytracing;

Ray ray(Numbers x) { return {v_at(x, 0), v_at(x, 3)}; }

}

std::vector<Call> raytracing_calls()
{
    return {
        {"raytracing::intersect sphere", "{vv}{vf}",
         [](Numbers x) {
             return numbers(intersect(ray(x), Sphere{v_at(x, 6), x[9]}));
         }},
        {"raytracing::intersect disc", "{vv}{vvf}",
         [](Numbers x) {
             return numbers(intersect(ray(x), Disc{v_at(x, 6), v_at(x, 9), x[12]}));
         }},
        {"raytracing::intersect triangle", "{vv}{vvv}",
         [](Numbers x) {
             const auto hit = intersect(ray(x), Triangle{v_at(x, 6), v_at(x, 9), v_at(x, 12)});
             return hit ? Answer{hit->t} : Answer{};
         }},
        call<unit_cylinder_field>("raytracing::unit_cylinder_field"),
        call<unit_cone_field>("raytracing::unit_cone_field"),
        call<raytracing::mirrored_direction>("raytracing::mirrored_direction"),
        call<critical_angle>("raytracing::critical_angle"),
        {"raytracing::intersect_unit_cylinder", "{vv}",
         [](Numbers x) { return numbers(intersect_unit_cylinder(ray(x))); }},
        {"raytracing::intersect_unit_cone", "{vv}", [](Numbers x) { return numbers(intersect_unit_cone(ray(x))); }},
        call<cosine_density>("raytracing::cosine_density"),
        call<refracted_direction>("raytracing::refracted_direction"),
        call<mirror_matrix>("raytracing::mirror_matrix"),
        call<mirrored_view>("raytracing::mirrored_view"),
        call<sdf::ball_distance>("raytracing::sdf::ball_distance"),
        call<sdf::box_distance>("raytracing::sdf::box_distance"),
        call<sdf::torus_distance>("raytracing::sdf::torus_distance"),
        call<sdf::capsule_distance>("raytracing::sdf::capsule_distance"),
    };
}

}
