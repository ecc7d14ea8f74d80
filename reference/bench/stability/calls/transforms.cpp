#include <umbral/meshes/area.hpp>
#include <umbral/transforms/about_a_point.hpp>
#include <umbral/transforms/affinity.hpp>
#include <umbral/transforms/basic_matrices.hpp>
#include <umbral/transforms/frames.hpp>
#include <umbral/transforms/gram_matrix.hpp>
#include <umbral/transforms/hook.hpp>
#include <umbral/transforms/normal_matrix.hpp>
#include <umbral/transforms/perpendicular.hpp>
#include <umbral/transforms/rotation.hpp>
#include <umbral/transforms/vectors.hpp>

#include "../calls.hpp"
#include "../plain_call.hpp"

namespace umbral::bench {
namespace {

using namespace stability;
using namespace transforms;

AxisAngle turn_at(Numbers x, std::size_t at) { return {v_at(x, at), x[at + 3]}; }
Frame frame_at(Numbers x, std::size_t at) { return {v_at(x, at), v_at(x, at + 3), v_at(x, at + 6), v_at(x, at + 9)}; }

}

std::vector<Call> transforms_calls()
{
    return {
        call<dot_product>("transforms::dot_product"),
        call<cross_product>("transforms::cross_product"),
        call<length_of>("transforms::length_of"),
        call<normalised>("transforms::normalised"),
        call<angle_between>("transforms::angle_between"),
        call<parallel_part>("transforms::parallel_part"),
        call<perpendicular_part>("transforms::perpendicular_part"),
        {"transforms::rotate_vector", "v{vf}",
         [](Numbers x) { return numbers(rotate_vector(v_at(x, 0), turn_at(x, 3))); }},
        {"transforms::rotation_matrix", "{vf}", [](Numbers x) { return numbers(rotation_matrix(turn_at(x, 0))); }},
        {"transforms::rotation_about_point", "v{vf}",
         [](Numbers x) { return numbers(rotation_about_point(v_at(x, 0), turn_at(x, 3))); }},
        call<scaling_about_point>("transforms::scaling_about_point"),
        call<scaling_along>("transforms::scaling_along"),
        call<reflection_in_line>("transforms::reflection_in_line"),
        call<reflection_in_plane>("transforms::reflection_in_plane"),
        call<alignment>("transforms::alignment"),
        call<placed_along>("transforms::placed_along"),
        {"transforms::parallelogram_defect", "{v,v,v,v}",
         [](Numbers x) {
             return numbers(parallelogram_defect({v_at(x, 0), v_at(x, 3), v_at(x, 6), v_at(x, 9)}));
         }},
        call<gram_matrix>("transforms::gram_matrix"),
        {"transforms::inverse_of_frame", "{vvvv}", [](Numbers x) { return numbers(inverse_of_frame(frame_at(x, 0))); }},
        {"transforms::between_frames", "{vvvv}{vvvv}",
         [](Numbers x) { return numbers(between_frames(frame_at(x, 0), frame_at(x, 12))); }},
        {"transforms::orientation", "{vvvv}",
         [](Numbers x) { return numbers(static_cast<float>(orientation(frame_at(x, 0)))); }},
        call<transformed_normal>("transforms::transformed_normal"),
        call<meshes::triangle_area>("meshes::triangle_area"),
        call<reflection_in_point>("transforms::reflection_in_point"),
        call<translation_matrix>("transforms::translation_matrix"),
        call<scaling_matrix>("transforms::scaling_matrix"),
        call<rotation_about_x>("transforms::rotation_about_x"),
        call<rotation_about_y>("transforms::rotation_about_y"),
        call<rotation_about_z>("transforms::rotation_about_z"),
        call<transform_point>("transforms::transform_point"),
        call<transform_vector>("transforms::transform_vector"),
        call<dot_from_gram>("transforms::dot_from_gram"),
        call<area_from_gram>("transforms::area_from_gram"),
        call<cross_in_basis>("transforms::cross_in_basis"),
        call<hook_matrix>("transforms::hook_matrix"),
        call<normal_matrix>("transforms::normal_matrix"),
        call<turn_left>("transforms::turn_left"),
        call<turn_right>("transforms::turn_right"),
        call<rotate_in_plane>("transforms::rotate_in_plane"),
        call<plane_rotation_matrix>("transforms::plane_rotation_matrix"),
        call<across>("transforms::across"),
        call<across_matrix>("transforms::across_matrix"),
    };
}

}
