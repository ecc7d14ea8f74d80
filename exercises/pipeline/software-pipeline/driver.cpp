#include <kit/varied.hpp>
#include <limits>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "borders.hpp"
#include "laws.hpp"
#include "scenery.hpp"
#include "settings.hpp"

namespace umbral {
namespace {

using namespace pipeline;

std::vector<Call> by_hand()
{
    std::vector<Call> calls = {
        on_paper({{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0.5F}}),
        on_paper({{-0.75F, 0.75F, -1}, {-0.75F, -0.5F, 0}, {0.75F, 0.75F, 1}}),
        on_paper(
            {{-1, -1, 0.5F}, {1, -1, 0.5F}, {0, 1, 0.5F}, {-1, 0.5F, 0}, {0, -1, 0}, {1, 0.5F, 0}}),  // the second one
                                                                                                      // in front
        on_paper(
            {{-1, 0.5F, 0}, {0, -1, 0}, {1, 0.5F, 0}, {-1, -1, 0.5F}, {1, -1, 0.5F}, {0, 1, 0.5F}}),  // … and drawn
                                                                                                      // first
        on_paper(
            {{-1, -1, -0.5F}, {1, -1, -0.5F}, {0, 1, 0.5F}, {-1, 0.5F, 0}, {0, -1, 0}, {1, 0.5F, 0}}),  // through each
                                                                                                        // other
        on_paper({{-1.5F, -0.5F, 0}, {1, -1.75F, 0}, {0.5F, 1.5F, 0}}),  // beyond the sides
    };
    // w in a column: the right corner four times as far as the others.
    Call far = on_paper({{-1, -1, 0}, {1, 0, 0}, {-1, 1, 0}});
    far.state.to_clip[0] = {2.5F, 0, 0, 1.5F};
    far.state.to_clip[3] = {1.5F, 0, 0, 2.5F};
    calls.push_back(far);
    // Shared vertices, in any order.
    Call shared = on_paper({{-1, -1, 0}, {0.75F, -0.75F, 0.25F}, {0.5F, 1, 0}, {-0.5F, 0.75F, 0}});
    shared.triangles = {{2, 0, 1}, {0, 2, 3}};
    calls.push_back(shared);
    return calls;
}

/// Calls on a square picture, mirrored or turned about its middle, in another order.
std::vector<Call> varied(Variation& vary, std::vector<Call> calls)
{
    const PlaneMap map = plane_map(vary);
    for (Call& call : calls)
        for (ColoredVertex& vertex : call.vertices)
            vertex.position = glm::vec3(map.place(glm::vec2(vertex.position)), vertex.position.z);
    return in_random_order(vary, std::move(calls));
}

/// The same with so many vertices before its own: 16 bits may not count them.
Call behind_others(Call call, unsigned others)
{
    call.vertices.insert(call.vertices.begin(), others, {{0, 0, -2}, {1, 1, 1}});
    for (glm::uvec3& triangle : call.triangles) triangle += others;
    return call;
}

/// Needles of thousands of pixels in the largest viewport, on multiples of 1/256 pixel, which float holds exactly.
Call needles(Random& random)
{
    constexpr float half = 8192;
    std::vector<glm::vec3> places;
    for (int i = 0; i < 6; ++i)
        for (const glm::vec2& corner : needle(random, 32, 24, 2000, true))
            places.emplace_back(corner.x / half, -corner.y / half, random.uniform(-0.9F, 0.9F));
    Call call = on_paper(places);
    call.width = 32;
    call.height = 24;
    call.state.viewport = {-8192, -8192, 16384, 16384, 0, 1};
    return call;
}

// All three ways in turn, in all three modes, in front of the camera, about it, and needles; every other call in flat
// colours.
std::vector<Call> culling(Random& random)
{
    return several(27, [&](int i) {
        Call call = i < 9    ? resized(random, in_front(random, 5))
                    : i < 18 ? resized(random, about_the_camera(random, 5))
                             : needles(random);
        call.state.culling =
            std::array{Culling::back, Culling::front, Culling::none}.at(static_cast<std::size_t>(i % 3));
        call.state.mode = modes.at(static_cast<std::size_t>(i / 3 % 3));
        call.state.shading = i % 2 == 0 ? ShadeModel::flat : ShadeModel::smooth;
        return call;
    });
}

// Of every fourth call all triangles reach to the horizon: what is seen of them has nearly the weights of one corner.
// Half of the calls have depths of other kinds; flat colours are none of this check's, but come too.
std::vector<Call> nets(Random& random, PolygonMode mode, int count)
{
    return several(count, [&](int i) {
        Call call = resized(random, i % 4 == 0 ? in_front(random, 4) : about_the_camera(random, 4));
        if (i / 4 % 2 == 1) call = with_depths(random, std::move(call));
        if (random.below(5) == 0) call.state.shading = ShadeModel::flat;
        for (std::size_t k = 0; i % 4 == 1 && k < call.vertices.size(); ++k)
            if (k % 3 != 0) call.vertices[k].position *= 10'000.0F;
        call.state.mode = mode;
        return call;
    });
}

// Functions, formats and ranges, in three modes; a layer of depth to begin with that some fragments pass and others do
// not. A quarter of the calls draws over the same triangles in other colours, so that there are equal depths, and one
// over others.
std::vector<Call> depths(Random& random)
{
    return several(32, [&](int i) {
        Call call = resized(random, in_front(random, 6));
        call.state.mode = modes.at(i / 8 == 2 ? 1 + random.below(2) : 0);
        call.state.depth.function = static_cast<DepthFunction>(i % 8);
        call.state.depth.format = static_cast<DepthFormat>(i % 3);
        call.state.depth.writes = i % 5 != 4;
        call.state.depth.enabled = i % 8 != 6;
        const bool reversed = random.below(2) == 0;
        call.state.viewport.near_depth = reversed ? 1 : random.uniform(0.1F, 0.4F);
        call.state.viewport.far_depth = reversed ? random.uniform(0, 0.1F) : 0.75F;
        call.clear_depth = stored_depth(call.state.depth.format, reversed ? 0.15F : 0.7F);
        return i / 8 % 2 == 0 ? call : over_others(random, call, i / 8 == 1);
    });
}

std::vector<Call> viewports(Random& random)
{
    return several(16, [&](int i) {
        Call call = i % 4 == 3 ? about_the_camera(random, 4) : in_front(random, 4);
        const auto offset = [&] { return static_cast<int>(random.below(25)) - 12; };
        call.state.viewport.left = offset();
        call.state.viewport.top = offset();
        call.state.viewport.width = 12 + static_cast<int>(random.below(40));
        call.state.viewport.height = 12 + static_cast<int>(random.below(30));
        call.state.mode = modes.at(static_cast<std::size_t>(i % 3));
        return call;
    });
}

// Meshes that reach beyond the view volume on all sides, each triangle in a colour of its own: along their sides pixels
// belong to one of two.
std::vector<Call> seams(Random& random)
{
    return several(6, [&](int) {
        Call call = about_the_camera(random, 0);
        constexpr unsigned cells = 6;
        for (unsigned y = 0; y <= cells; ++y)
            for (unsigned x = 0; x <= cells; ++x) {
                const glm::vec2 moved(random.uniform(-0.4F, 0.4F), random.uniform(-0.4F, 0.4F));
                const glm::vec2 at = glm::vec2(x, y) - 0.5F * cells + moved;
                call.vertices.push_back({{3 * at.x, 1.2F * at.y - 0.3F, 2.5F * at.y - 1}, random_color(random)});
            }
        for (unsigned y = 0; y < cells; ++y)
            for (unsigned x = 0; x < cells; ++x) {
                const unsigned corner = y * (cells + 1) + x;
                call.triangles.emplace_back(corner, corner + 1, corner + cells + 2);
                call.triangles.emplace_back(corner, corner + cells + 2, corner + cells + 1);
            }
        call.state.shading = ShadeModel::flat;
        call.state.depth.function = DepthFunction::always;
        return call;
    });
}

void record_picture(Recorder& out)
{
    const Layer layer = scenery(out, 480, 320);
    out.image("colours", encoded(layer.colors));
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record(out, varied(c.vary, by_hand())); }},
    {"random",
     [](Case& c, Recorder& out) {
         record(out, several(20, [&](int i) {
                    Call call = resized(c.random, in_front(c.random, 6));
                    if (i % 2 == 1) call = shared(c.random, std::move(call));
                    return behind_others(std::move(call), i % 4 == 3 ? 70'000 : 0);
                }));
     }},
    {"about the camera",
     [](Case& c, Recorder& out) {
         record(out, several(20, [&](int i) {
                    const Call call = resized(c.random, about_the_camera(c.random, 5));
                    return i % 4 == 2 ? with_holes(c.random, call) : call;
                }));
     }},
    {"culling", [](Case& c, Recorder& out) { record(out, culling(c.random)); }},
    {"lines", [](Case& c, Recorder& out) { record(out, nets(c.random, PolygonMode::line, 16)); }},
    {"points", [](Case& c, Recorder& out) { record(out, nets(c.random, PolygonMode::point, 40)); }},
    {"borders", [](Case& c, Recorder& out) { record(out, borders(c.random)); }},
    {"depth", [](Case& c, Recorder& out) { record(out, depths(c.random)); }},
    {"viewports", [](Case& c, Recorder& out) { record(out, viewports(c.random)); }},
    {"seams", [](Case& c, Recorder& out) { record(out, seams(c.random)); }},
    {"laws",
     [](Case& c, Recorder& out) {
         record_order_and_place(c.random, out);
         record_halves(c.random, out);
     }},
    {"picture", [](Case&, Recorder& out) { record_picture(out); }},
};

}
