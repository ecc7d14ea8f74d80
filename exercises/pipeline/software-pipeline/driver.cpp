#include <kit/varied.hpp>
#include <limits>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "laws.hpp"
#include "scenery.hpp"

namespace umbral {
namespace {

using namespace pipeline;

constexpr std::array<glm::vec3, 6> paints = {glm::vec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};

/// Eight by eight pixels, the identity for a matrix: x = -1 is the left border, x = -0.75 one pixel from it.
Call on_paper(const std::vector<glm::vec3>& places)
{
    Call call;
    call.width = call.height = 8;
    call.state.viewport = {0, 0, 8, 8, 0, 1};
    for (std::size_t i = 0; i < places.size(); ++i) call.vertices.push_back({places[i], paints[i % paints.size()]});
    for (unsigned i = 0; i + 2 < places.size(); i += 3) call.triangles.emplace_back(i, i + 1, i + 2);
    return call;
}

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

template <class Make>
std::vector<Call> several(int count, const Make& make)
{
    std::vector<Call> calls;
    for (int i = 0; i < count; ++i) calls.push_back(make(i));
    return calls;
}

/// The same with so many vertices before its own: 16 bits may not count them.
Call behind_others(Call call, unsigned others)
{
    call.vertices.insert(call.vertices.begin(), others, {{0, 0, -2}, {1, 1, 1}});
    for (glm::uvec3& triangle : call.triangles) triangle += others;
    return call;
}

constexpr std::array modes = {PolygonMode::fill, PolygonMode::line, PolygonMode::point};

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
        Call call = i < 9 ? in_front(random, 5) : i < 18 ? about_the_camera(random, 5) : needles(random);
        call.state.culling =
            std::array{Culling::back, Culling::front, Culling::none}.at(static_cast<std::size_t>(i % 3));
        call.state.mode = modes.at(static_cast<std::size_t>(i / 3 % 3));
        call.state.shading = i % 2 == 0 ? ShadeModel::flat : ShadeModel::smooth;
        return call;
    });
}

// Of every fourth call all triangles reach to the horizon: what is seen of them has nearly the weights of one corner.
std::vector<Call> nets(Random& random, PolygonMode mode, int count)
{
    return several(count, [&](int i) {
        Call call = i % 4 == 0 ? in_front(random, 4) : about_the_camera(random, 4);
        for (std::size_t k = 0; i % 4 == 1 && k < call.vertices.size(); ++k)
            if (k % 3 != 0) call.vertices[k].position *= 10'000.0F;
        call.state.mode = mode;
        return call;
    });
}

/// A viewport that is larger than the picture and begins left of it and above it: rows 13 to 18 of it are shown.
Call above_and_beside_the_picture()
{
    Call call = on_paper({{-0.5F, -0.875F, 0}, {0, -0.875F, 0}, {-0.25F, -0.375F, 0}});
    call.width = call.height = 12;
    call.state.viewport = {-4, -6, 20, 20, 0, 1};
    return call;
}

/// A line from (9001, 10419) to (11102, 11587), in 1/256 pixel: at the centre of column 37 it lies 1/256 of 1/2101
/// pixel above row 42, less than a float can tell.
Call past_whole_rows()
{
    const auto ndc = [](float x, float y) { return glm::vec3(x / 8192 - 1, 1 - y / 8192, 0); };
    Call call = on_paper({ndc(9001, 10419), ndc(11102, 11587), ndc(9216, 10752)});
    call.width = call.height = 64;
    call.state.viewport = {0, 0, 64, 64, 0, 1};
    call.state.mode = PolygonMode::line;
    return call;
}

/// Halves of a pixel, from border to border of 8, or, every third, beside them by 1/512 pixel, which is a tie, or less:
/// rounded to 1/256 they are halves again.
float beside_a_half(Random& random)
{
    const float half = 0.5F * static_cast<float>(random.below(17));
    const float off = static_cast<float>(1 + random.below(2)) / 1024;
    const std::uint32_t side = random.below(6);
    return glm::clamp(side == 0 ? half - off : side == 1 ? half + off : half, 0.0F, 8.0F);
}

// In a viewport of 8 x 8 pixels within a picture of 12 x 12: corners in halves of a pixel or beside them. So ends of
// lines lie on centres, and sides and points on the viewport's own borders. Every third call is culled. Two calls have
// other viewports.
std::vector<Call> borders(Random& random)
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
        above_and_beside_the_picture(), past_whole_rows()};
    for (int i = 0; i < 24; ++i) {
        std::vector<glm::vec3> places(6);
        for (glm::vec3& place : places) {
            place.x = beside_a_half(random);
            place.y = beside_a_half(random);
            place.z = random.uniform(-0.9F, 0.9F);
        }
        calls.push_back(in_viewport(places, i));
    }
    return calls;
}

// Functions, formats and ranges; a layer of depth to begin with that some fragments pass and others do not.
std::vector<Call> depths(Random& random)
{
    return several(24, [&](int i) {
        Call call = in_front(random, 6);
        call.state.depth.function = static_cast<DepthFunction>(i % 8);
        call.state.depth.format = static_cast<DepthFormat>(i % 3);
        call.state.depth.writes = i % 5 != 4;
        call.state.depth.enabled = i % 11 != 10;
        const bool reversed = i % 2 == 1;
        call.state.viewport.near_depth = reversed ? 1 : 0.25F;
        call.state.viewport.far_depth = reversed ? 0 : 0.75F;
        call.clear_depth = stored_depth(call.state.depth.format, reversed ? 0.1F : 0.7F);
        return call;
    });
}

std::vector<Call> viewports(Random& random)
{
    return several(16, [&](int i) {
        Call call = i % 4 == 3 ? about_the_camera(random, 4) : in_front(random, 4);
        const auto offset = [&] { return static_cast<int>(random.below(25)) - 12; };
        call.state.viewport.left = offset();
        call.state.viewport.top = offset();
        call.state.viewport.width = 12 + static_cast<int>(random.below(20));
        call.state.viewport.height = 12 + static_cast<int>(random.below(20));
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
         record(out, several(20, [&](int i) { return behind_others(in_front(c.random, 6), i % 4 == 3 ? 70'000 : 0); }));
     }},
    {"about the camera",
     [](Case& c, Recorder& out) { record(out, several(20, [&](int) { return about_the_camera(c.random, 5); })); }},
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
