#pragma once

#include <kit/varied.hpp>

#include "paper.hpp"

/// Lines and points that end on centres or borders of pixels, or hardly beside them, and triangles of hardly any area.
namespace umbral::pipeline {

/// A viewport that is larger than the picture and begins left of it and above it: rows 13 to 18 of it are shown.
inline Call above_and_beside_the_picture()
{
    Call call = on_paper({{-0.5F, -0.875F, 0}, {0, -0.875F, 0}, {-0.25F, -0.375F, 0}});
    call.width = call.height = 12;
    call.state.viewport = {-4, -6, 20, 20, 0, 1};
    return call;
}

/// A line from (9001, 10419) to (11102, 11587), in 1/256 pixel: at the centre of column 37 it lies 1/256 of 1/2101
/// pixel above row 42, less than a float can tell.
inline Call past_whole_rows()
{
    const auto ndc = [](float x, float y) { return glm::vec3(x / 8192 - 1, 1 - y / 8192, 0); };
    Call call = on_paper({ndc(9001, 10419), ndc(11102, 11587), ndc(9216, 10752)});
    call.width = call.height = 64;
    call.state.viewport = {0, 0, 64, 64, 0, 1};
    call.state.mode = PolygonMode::line;
    return call;
}

/// A triangle's sides from 1,024 to 4,096 in front of the camera: 1/w hardly changes, and the colours' shares do.
inline Call far_away()
{
    constexpr float near = 1024;
    Call call = on_paper({{-near / 2, 0, -near}, {2 * near, 0, -4 * near}, {0, near / 2, -near}});
    call.width = call.height = 32;
    call.state.viewport = {0, 0, 32, 32, 0, 1};
    call.state.to_clip[2] = {0, 0, -1, -1};
    call.state.to_clip[3] = {0, 0, -2, 0};
    call.state.mode = PolygonMode::line;
    return call;
}

/// A filled triangle that reaches beyond all four sides of the viewport, which cuts it to seven corners on multiples of
/// a pixel; mirrored in x and y by -1.
inline Call of_seven_corners(float x, float y)
{
    return on_paper({{0, 1.5F * y, 0.25F}, {-5.5F * x, -4 * y, 0.25F}, {11 * x / 6, -y / 3, 0.25F}});
}

/// Halves of a pixel, from border to border of 8, or, every third, beside them by 1/512 pixel, which is a tie, or less:
/// rounded to 1/256 they are halves again.
inline float beside_a_half(Random& random)
{
    const float half = 0.5F * static_cast<float>(random.below(17));
    const float off = static_cast<float>(1 + random.below(2)) / 1024;
    const std::uint32_t side = random.below(6);
    return glm::clamp(side == 0 ? half - off : side == 1 ? half + off : half, 0.0F, 8.0F);
}

/// A triangle without area: three corners in a line, in any order, in halves of a pixel. It shows its back.
inline std::vector<glm::vec3> without_area(Random& random)
{
    const auto half = [&](std::uint32_t count) { return 0.5F * static_cast<float>(random.below(count)); };
    const float x = half(4);
    const glm::vec3 first(x, half(4), random.uniform(-0.9F, 0.9F));
    const float along = 0.5F + half(3);
    const glm::vec3 step(along, half(4), 0);
    const auto far = static_cast<float>(2 + random.below(2));
    std::vector<glm::vec3> places = in_random_order(random, std::vector{first, first + step, first + far * step});
    if (random.below(2) == 0)
        for (glm::vec3& place : places) place.x = 8 - place.x;
    return places;
}

/// A triangle with a corner that lies beside the viewport by some millionths of a pixel: it is cut there, and the two
/// new corners are one to a float, or nearly.
inline std::vector<glm::vec3> hardly_outside(Random& random)
{
    const auto half = [&](std::uint32_t least, std::uint32_t count) {
        return 0.5F * static_cast<float>(least + random.below(count));
    };
    const float y = half(2, 13);
    const glm::vec3 corner(8 + std::exp2(-19 - 2 * random.uniform()), y, random.uniform(-0.9F, 0.9F));
    const float left = half(1, 6);
    const glm::vec3 upper(left, half(0, 3), random.uniform(-0.9F, 0.9F));
    const float right = half(1, 6);
    return in_random_order(random, std::vector{corner, upper, glm::vec3(right, half(13, 4), upper.z)});
}

/// In a viewport of 8 x 8 pixels within a picture of 12 x 12: corners in halves of a pixel or beside them. So ends of
/// lines lie on centres, and sides and points on the viewport's own borders. Every third call is culled. Two calls have
/// other viewports, and some show what lies far away or is cut at all sides. Then triangles that show their back
/// because they have no area, and others that hardly need clipping.
inline std::vector<Call> borders(Random& random)
{
    const auto in_viewport = [](const std::vector<glm::vec3>& places, int i) {
        std::vector<glm::vec3> ndc;
        for (const glm::vec3& place : places) ndc.emplace_back(place.x / 4 - 1, 1 - place.y / 4, place.z);
        Call call = on_paper(ndc);
        call.width = call.height = 12;
        call.state.viewport.left = 2;
        call.state.viewport.top = 1;
        call.state.mode = i % 4 == 3 ? PolygonMode::point : PolygonMode::line;
        call.state.culling = i % 3 != 2 ? Culling::none : i % 2 == 0 ? Culling::back : Culling::front;
        return call;
    };
    std::vector<Call> calls = {
        in_viewport({{1.5F, 1.5F, 0}, {5.5F, 1.5F, 0}, {5.5F, 5.5F, 0}}, 0),
        in_viewport({{6.5F, 3.5F, 0}, {0.5F, 0.5F, 0}, {2.5F, 7.5F, 0}}, 1),
        in_viewport({{8, 1, 0}, {8, 7, 0}, {3, 4, 0}}, 0), in_viewport({{1, 8, 0}, {7, 8, 0}, {4, 3, 0}}, 1),
        in_viewport({{8, 1, 0}, {3, 8, 0}, {0, 0, 0}}, 3),
        // Triangles of half a pixel show a face too: lines, once either face is culled.
        in_viewport({{3, 3, 0}, {3.5F, 4, 0}, {4, 3, 0}}, 2), in_viewport({{3, 3, 0}, {4, 3, 0}, {3.5F, 4, 0}}, 5),
        // So do those of a hundredth of a pixel: points.
        in_viewport({{3, 3, 0}, {3 + 2.0F / 256, 3 + 4.0F / 256, 0}, {3 + 4.0F / 256, 3, 0}}, 11),
        in_viewport({{3, 3, 0}, {3 + 4.0F / 256, 3, 0}, {3 + 2.0F / 256, 3 + 4.0F / 256, 0}}, 11),
        above_and_beside_the_picture(), past_whole_rows(), far_away(), of_seven_corners(1, 1), of_seven_corners(-1, 1),
        of_seven_corners(1, -1), of_seven_corners(-1, -1)};
    for (int i = 0; i < 24; ++i) {
        std::vector<glm::vec3> places(6);
        for (glm::vec3& place : places) {
            place.x = beside_a_half(random);
            place.y = beside_a_half(random);
            place.z = random.uniform(-0.9F, 0.9F);
        }
        calls.push_back(in_viewport(places, i));
    }
    for (int i = 0; i < 16; ++i) {
        Call call = in_viewport(i % 2 == 0 ? without_area(random) : hardly_outside(random), i / 2);
        call.state.culling = std::array{Culling::front, Culling::back, Culling::none}[random.below(3)];
        call.state.shading = ShadeModel::flat;
        call.state.depth.function = DepthFunction::always;
        calls.push_back(call);
    }
    return calls;
}

}
