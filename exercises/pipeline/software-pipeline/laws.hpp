#pragma once

#include <numeric>
#include <string>

#include "scenes.hpp"

/// Draws that must give the same picture as others of the student's own: no right answer is needed to judge them.
namespace umbral::pipeline {

/// Rows [call, x, y, red, green, blue] of the pixels that changed.
inline void record_colours(Recorder& out, std::string_view name, const std::vector<Call>& calls)
{
    out.text(std::string(name) + ".names", "call");
    for (std::size_t i = 0; i < calls.size(); ++i) {
        const Layer layer = drawn(out, calls[i]);
        for (int y = 0; y < std::min(calls[i].height, layer.colors.height); ++y)
            for (int x = 0; x < std::min(calls[i].width, layer.colors.width); ++x)
                if (const glm::vec3 color = layer.colors.at(x, y); color != untouched)
                    out.append(name,
                               std::span<const float>(std::array{static_cast<float>(i), static_cast<float>(x),
                                                                 static_cast<float>(y), color.r, color.g, color.b}));
    }
}

/// Triangles that hide each other, and the same ones in another order; half of them; and all in a viewport 9 pixels
/// further right and 6 down.
inline void record_order_and_place(Random& random, Recorder& out)
{
    std::vector<Call> in_order;
    std::vector<Call> permuted;
    std::vector<Call> half;
    std::vector<Call> moved;
    for (int i = 0; i < 6; ++i) {
        Call call = i % 3 == 2 ? about_the_camera(random, 6) : in_front(random, 6);
        call.width = 48;
        call.height = 40;
        call.state.viewport.left = 3;
        call.state.viewport.top = 2;
        in_order.push_back(call);
        half.push_back(call);
        half.back().triangles.resize(2);
        moved.push_back(call);
        moved.back().state.viewport.left += 9;
        moved.back().state.viewport.top += 6;
        permuted.push_back(call);
        std::vector<glm::uvec3>& triangles = permuted.back().triangles;
        for (std::size_t k = triangles.size(); k > 1; --k)
            std::swap(triangles[k - 1], triangles[random.below(static_cast<std::uint32_t>(k))]);
        if (triangles == call.triangles) std::reverse(triangles.begin(), triangles.end());
    }
    record_colours(out, "in order", in_order);
    record_colours(out, "permuted", permuted);
    record_colours(out, "half of them", half);
    record_colours(out, "moved", moved);
}

/// One triangle a call, whole; cut in two from its last corner to the middle of the side opposite; and one of the
/// halves. Without perspective, and with places in multiples of 1/64 pixel, the middle is exact.
inline void record_halves(Random& random, Recorder& out)
{
    std::vector<Call> whole;
    std::vector<Call> halves;
    std::vector<Call> one;
    for (int i = 0; i < 12; ++i) {
        Call call;
        call.width = call.height = 32;
        call.state.viewport = {0, 0, 32, 32, 0, 1};
        const auto coordinate = [&] { return static_cast<float>(static_cast<int>(random.below(961)) - 480) / 512; };
        for (int corner = 0; corner < 3; ++corner) {
            const float x = coordinate();
            const float y = coordinate();
            call.vertices.push_back({{x, y, coordinate()}, random_color(random)});
        }
        const auto& [a, b] = std::pair(call.vertices[0], call.vertices[1]);
        call.vertices.push_back({0.5F * (a.position + b.position), 0.5F * (a.color + b.color)});
        call.triangles = {{0, 1, 2}};
        whole.push_back(call);
        call.triangles = {{0, 3, 2}, {3, 1, 2}};
        halves.push_back(call);
        call.triangles.pop_back();
        one.push_back(call);
    }
    record_colours(out, "whole", whole);
    record_colours(out, "two halves", halves);
    record_colours(out, "one half", one);
}

}
