#include "sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "inputs.hpp"
#include "measure.hpp"

namespace stability {
namespace {

using List = std::vector<float>;

void same(List&) {}
void negated(List& x)
{
    for (float& value : x) value = -value;
}
void doubled(List& x)
{
    for (float& value : x) value *= 2;
}
void swapped_threes(List& x) { std::rotate(x.begin(), x.begin() + 3, x.begin() + 6); }
// x, y, z of every vector become y, z, x: an exact rotation about (1, 1, 1).
void turned(List& x)
{
    for (std::size_t at = 0; at + 3 <= x.size(); at += 3)
        std::rotate(x.begin() + static_cast<std::ptrdiff_t>(at), x.begin() + static_cast<std::ptrdiff_t>(at + 1),
                    x.begin() + static_cast<std::ptrdiff_t>(at + 3));
}
void turned_corners(List& x) { std::rotate(x.begin(), x.begin() + 3, x.begin() + 9); }
// Whole numbers of up to 12 bits stay exact when 2^23 / 2^12 is added.
void far_away(List& x)
{
    for (float& value : x) value += 2048;
}
void quadrupled(List& x)
{
    for (float& value : x) value *= 4;
}

std::vector<Relation> relations()
{
    return {
        {"transforms::dot_product", "swapped vectors: the same", swapped_threes, same, 0},
        {"transforms::dot_product", "axes permuted: the same", turned, same, 1},
        {"transforms::dot_product", "both negated: the same", negated, same, 0},
        {"transforms::dot_product", "both doubled: four times", doubled, quadrupled, 0},
        {"transforms::cross_product", "swapped vectors: negated", swapped_threes, negated, 0},
        {"transforms::cross_product", "axes permuted: permuted", turned, turned, 0},
        {"transforms::cross_product", "both doubled: four times", doubled, quadrupled, 0},
        {"transforms::length_of", "negated: the same", negated, same, 0},
        {"transforms::length_of", "axes permuted: the same", turned, same, 1},
        {"transforms::length_of", "doubled: doubled", doubled, doubled, 0},
        {"transforms::normalised", "doubled: the same", doubled, same, 0},
        {"transforms::normalised", "negated: negated", negated, negated, 0},
        {"transforms::angle_between", "swapped vectors: the same", swapped_threes, same, 1},
        {"transforms::angle_between", "both doubled: the same", doubled, same, 0},
        {"transforms::angle_between", "axes permuted: the same", turned, same, 1},
        {"transforms::perpendicular_part", "axes permuted: permuted", turned, turned, 1},
        {"transforms::perpendicular_part", "both doubled: doubled", doubled, doubled, 0},
        {"transforms::orientation", "axes permuted: the same", turned, same, 0},
        {"transforms::orientation", "negated: the opposite", negated, negated, 0},
        {"transforms::orientation", "two vectors swapped: the opposite", swapped_threes, negated, 0},
        {"meshes::triangle_area", "corners permuted: the same", turned_corners, same, 2},
        {"meshes::triangle_area", "two corners swapped: the same", swapped_threes, same, 2},
        {"meshes::triangle_area", "axes permuted: the same", turned, same, 2},
        {"meshes::triangle_area", "doubled: four times", doubled, quadrupled, 0},
        {"meshes::triangle_area", "moved far away, exactly: the same", far_away, same, 2},
        {"projections::visual_angle", "swapped ends: the same", swapped_threes, same, 1},
        {"projections::visual_angle", "doubled: the same", doubled, same, 0},
        {"lighting::half_vector", "swapped directions: the same", swapped_threes, same, 2},
        {"lighting::half_vector", "doubled: the same", doubled, same, 0},
        {"lighting::light_angles", "doubled: the same", doubled, same, 0},
        {"texturing::spherical_coordinates", "doubled: the same", doubled, same, 0},
        {"texturing::box_place", "doubled: the same", doubled, same, 0},
        {"texturing::panorama_place", "doubled: the same", doubled, same, 0},
    };
}

}

std::vector<SweepResult> swept(std::uint32_t count, std::uint64_t seed)
{
    const std::vector<Call> calls = reference_calls();
    const std::vector<Row> rows = all_rows();
    std::vector<SweepResult> results;
    for (const Relation& relation : relations()) {
        const auto call =
            std::ranges::find_if(calls, [&](const Call& one) { return std::string(one.name) == relation.function; });
        if (call == calls.end()) throw std::logic_error(std::string("no call of the name ") + relation.function);
        const auto row =
            std::ranges::find_if(rows, [&](const Row& one) { return std::string(one.name) == relation.function; });
        if (row == rows.end()) throw std::logic_error(std::string("no row of the name ") + relation.function);
        SweepResult result{relation, 0, 0, {}};
        umbral::Random random(seed);
        for (std::uint32_t i = 0; i < count; ++i) {
            std::vector<float> x = drawn_numbers(call->shape, random);
            if (row->repair != nullptr) row->repair(x, random);
            if (relation.change == far_away)
                for (float& value : x) value = static_cast<float>(random.below(4096)) - 2048;
            Answer expected = call->answer(x);
            std::vector<float> changed = x;
            relation.change(changed);
            const Answer given = call->answer(changed);
            relation.expect(expected);
            // Denormal results round at another place when doubled.
            if (!is_finite(expected) ||
                std::ranges::any_of(expected, [](float value) { return value != 0 && std::abs(value) < 1e-37F; }))
                continue;
            ++result.asked;
            const double error = error_of(Unit::ulps_of_largest, given, expected);
            if (error > result.worst || result.x.empty()) {
                result.worst = error;
                result.x = x;
            }
        }
        results.push_back(result);
    }
    return results;
}

}
