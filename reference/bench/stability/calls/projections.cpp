#include <umbral/interaction/camera_animation.hpp>
#include <umbral/interaction/keyframes.hpp>
#include <umbral/projections/curved.hpp>
#include <umbral/projections/frustum.hpp>
#include <umbral/projections/oblique.hpp>
#include <umbral/projections/orthographic.hpp>
#include <umbral/projections/perspective.hpp>
#include <umbral/projections/stereo.hpp>
#include <umbral/projections/view.hpp>
#include <umbral/projections/view_frame.hpp>

#include "../calls.hpp"
#include "../plain_call.hpp"

namespace umbral::bench {
namespace {

using namespace stability;
using namespace projections;

ViewVolume volume(Numbers x) { return {x[0], x[1], x[2], x[3], x[4], x[5]}; }
Lens lens(Numbers x) { return {x[0], x[1], x[2], x[3]}; }
Answer curved(const std::optional<CurvedPoint>& point)
{
    return point ? joined(point->place, point->distance) : Answer{};
}
Answer framed(const std::optional<ViewFrame>& frame)
{
    return frame ? joined(frame->x, frame->y, frame->z, frame->origin) : Answer{};
}
interaction::CameraFlight flight(Numbers x) { return {v_at(x, 0), v_at(x, 3), v_at(x, 6), v_at(x, 9), x[12]}; }

}

std::vector<Call> projections_calls()
{
    return {
        {"projections::frustum_matrix", "{ffffff}", [](Numbers x) { return numbers(frustum_matrix(volume(x))); }},
        {"projections::orthographic_matrix", "{ffffff}",
         [](Numbers x) { return numbers(orthographic_matrix(volume(x))); }},
        {"projections::inverse_orthographic_matrix", "{ffffff}",
         [](Numbers x) { return numbers(inverse_orthographic_matrix(volume(x))); }},
        {"projections::perspective_matrix", "{ffff}", [](Numbers x) { return numbers(perspective_matrix(lens(x))); }},
        {"projections::reversed_perspective_matrix", "{ffff}",
         [](Numbers x) { return numbers(reversed_perspective_matrix(lens(x))); }},
        call<vertical_field_of_view>("projections::vertical_field_of_view"),
        call<foreshortening_of>("projections::foreshortening_of"),
        {"projections::oblique_shear", "{ff}",
         [](Numbers x) {
             return numbers(oblique_shear({x[0], x[1]}));
         }},
        {"projections::projector_direction", "{ff}",
         [](Numbers x) {
             return numbers(projector_direction({x[0], x[1]}));
         }},
        {"projections::spherical_projection", "v", [](Numbers x) { return curved(spherical_projection(v_at(x, 0))); }},
        {"projections::cylindrical_projection", "v",
         [](Numbers x) { return curved(cylindrical_projection(v_at(x, 0))); }},
        call<visual_angle>("projections::visual_angle"),
        {"projections::parallax", "{ffffff}f",
         [](Numbers x) {
             return numbers(parallax({x[0], x[1], x[2], x[3], x[4], x[5]}, x[6]));
         }},
        call<view_matrix>("projections::view_matrix"),
        {"projections::view_frame", "{vvv}",
         [](Numbers x) {
             return framed(view_frame({v_at(x, 0), v_at(x, 3), v_at(x, 6)}));
         }},
        {"interaction::flight_pose", "{vvvvf}f",
         [](Numbers x) {
             const auto pose = interaction::flight_pose(flight(x), x[13]);
             return joined(pose.eye, pose.target);
         }},
        call<project_point>("projections::project_point"),
        {"projections::view_from", "vffff",
         [](Numbers x) {
             const ViewParameters view = view_from(v_at(x, 0), x[3], x[4], x[5], x[6]);
             return joined(view.target, view.up, view.normal);
         }},
        {"interaction::rolling_turn", "uf",
         [](Numbers x) {
             const auto turn = interaction::rolling_turn(u_at(x, 0), x[2]);
             return joined(turn.w, turn.v);
         }},
    };
}

}
