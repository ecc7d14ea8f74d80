#include <umbral/meshes/area.hpp>
#include <umbral/transforms/about_a_point.hpp>
#include <umbral/transforms/affinity.hpp>
#include <umbral/transforms/frames.hpp>
#include <umbral/transforms/gram_matrix.hpp>
#include <umbral/transforms/normal_matrix.hpp>
#include <umbral/transforms/rotation.hpp>
#include <umbral/transforms/vectors.hpp>

#include "../calls.hpp"

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
        {"transforms::dot_product", "vv", [](Numbers x) { return numbers(dot_product(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::cross_product", "vv", [](Numbers x) { return numbers(cross_product(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::length_of", "v", [](Numbers x) { return numbers(length_of(v_at(x, 0))); }},
        {"transforms::normalised", "v", [](Numbers x) { return numbers(normalised(v_at(x, 0))); }},
        {"transforms::angle_between", "vv", [](Numbers x) { return numbers(angle_between(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::parallel_part", "vv", [](Numbers x) { return numbers(parallel_part(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::perpendicular_part", "vv",
         [](Numbers x) { return numbers(perpendicular_part(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::rotate_vector", "v{vf}",
         [](Numbers x) { return numbers(rotate_vector(v_at(x, 0), turn_at(x, 3))); }},
        {"transforms::rotation_matrix", "{vf}", [](Numbers x) { return numbers(rotation_matrix(turn_at(x, 0))); }},
        {"transforms::rotation_about_point", "v{vf}",
         [](Numbers x) { return numbers(rotation_about_point(v_at(x, 0), turn_at(x, 3))); }},
        {"transforms::scaling_about_point", "vv",
         [](Numbers x) { return numbers(scaling_about_point(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::scaling_along", "vvf",
         [](Numbers x) { return numbers(scaling_along(v_at(x, 0), v_at(x, 3), x[6])); }},
        {"transforms::reflection_in_line", "vv",
         [](Numbers x) { return numbers(reflection_in_line(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::reflection_in_plane", "vv",
         [](Numbers x) { return numbers(reflection_in_plane(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::alignment", "vv", [](Numbers x) { return numbers(alignment(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::placed_along", "vv", [](Numbers x) { return numbers(placed_along(v_at(x, 0), v_at(x, 3))); }},
        {"transforms::parallelogram_defect", "{v,v,v,v}",
         [](Numbers x) {
             return numbers(parallelogram_defect({v_at(x, 0), v_at(x, 3), v_at(x, 6), v_at(x, 9)}));
         }},
        {"transforms::gram_matrix", "m", [](Numbers x) { return numbers(gram_matrix(m_at(x, 0))); }},
        {"transforms::inverse_of_frame", "{vvvv}", [](Numbers x) { return numbers(inverse_of_frame(frame_at(x, 0))); }},
        {"transforms::between_frames", "{vvvv}{vvvv}",
         [](Numbers x) { return numbers(between_frames(frame_at(x, 0), frame_at(x, 12))); }},
        {"transforms::orientation", "{vvvv}",
         [](Numbers x) { return numbers(static_cast<float>(orientation(frame_at(x, 0)))); }},
        {"transforms::transformed_normal", "Mv",
         [](Numbers x) { return numbers(transformed_normal(M_at(x, 0), v_at(x, 16))); }},
        {"meshes::triangle_area", "vvv",
         [](Numbers x) { return numbers(meshes::triangle_area(v_at(x, 0), v_at(x, 3), v_at(x, 6))); }},
    };
}

}
