#include <kit/varied.hpp>
#include <umbral/record/driver.hpp>

#include "gallery.hpp"
#include "sequences.hpp"

namespace umbral {
namespace {

using namespace pipeline;
using enum PrimitiveType;

/// Vertices in their order; varied, others, in any order.
void record_sequences(Variation& vary, Recorder& out, std::initializer_list<PrimitiveType> types,
                      std::initializer_list<std::uint32_t> counts)
{
    for (const PrimitiveType type : types)
        for (const std::uint32_t count : counts) {
            std::vector<std::uint32_t> sequence = in_random_order(vary, counted(count));
            const std::uint32_t first = vary.one_of(0U, std::array{3U, 7U, 20U});
            for (std::uint32_t& vertex : sequence) vertex += first;
            record_assembly(out, type, sequence);
        }
    if (std::ranges::find(types, polygon) != types.end()) {
        record_assembly(out, polygon, {0, 1, 2, 3, 0});
        record_assembly(out, polygon, {2, 5, 5, 6, 1, 2});
    }
    name_assembly(out);
}

// All types, complete and not, with indices that repeat.
void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 80; ++i) {
        const auto type = static_cast<PrimitiveType>(i % 10);
        const std::uint32_t count = random.below(type == polygon ? 10 : 15);
        // Twenty vertices, the first ones or some of a large mesh: more than 16 bits or a float can number, or the last
        // ones that there are.
        std::vector<std::uint32_t> sequence = random_sequence(random, count, 20);
        // Whose last corner is its first one has it twice.
        if (i % 10 == 9 && i / 10 % 2 == 0 && count > 3) sequence.back() = sequence.front();
        record_assembly(out, type, sequence, i / 10 % 4);
    }
    name_assembly(out);
}

void record_side(Recorder& out, const std::vector<glm::vec2>& corners)
{
    out.append("front", ask<is_front_facing>(out, corners));
}

// A face and the same one backwards, in either order.
void record_both_sides(Random& random, Recorder& out, std::vector<glm::vec2> corners)
{
    if (random.below(2) == 0) std::reverse(corners.begin(), corners.end());
    record_side(out, corners);
    std::reverse(corners.begin(), corners.end());
    record_side(out, corners);
}

std::vector<glm::vec2> random_face(Random& random, std::size_t count)
{
    const auto left = static_cast<float>(random.below(600));
    const glm::vec2 centre(left, static_cast<float>(random.below(400)));
    const float radius = random.uniform(5, 200);
    std::vector<glm::vec2> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const float angle = 6.2831853F * (static_cast<float>(i) + random.uniform(0, 0.7F)) / static_cast<float>(count);
        const float reach = radius * (count < 5 ? 1.0F : random.uniform(0.2F, 1));  // of five or more: a star
        corners.push_back(centre + reach * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

// Faces without area show their back: each beside one that shows its front.
void record_sides(Random& random, Recorder& out)
{
    for (std::size_t i = 0; i < 150; ++i) record_both_sides(random, out, random_face(random, 3 + i % 5));
    // Hardly any area, but some: thousandths of a pixel wide, in the first pixel.
    for (std::size_t i = 0; i < 60; ++i) {
        std::vector<glm::vec2> corners = random_face(random, 3 + i % 5);
        const glm::vec2 first = corners[0];
        for (glm::vec2& corner : corners) corner = 0.02F + 0x1p-18F * (corner - first);
        record_both_sides(random, out, corners);
    }
    for (int i = 0; i < 50; ++i) {
        const std::vector<glm::vec2> places = random_places(random, 2);
        const glm::vec2 a = round(places[0]);
        const glm::vec2 b = round(places[1]);
        const std::vector<glm::vec2> flat[] = {{a, b, a}, {a, b, 2.0F * b - a}, {a, a, b}, {b, b, b}, {a, b}, {a}, {}};
        std::vector<glm::vec2> front = {a, a + glm::vec2(3, 0), a + glm::vec2(1, 2)};
        const bool swapped = random.below(2) == 0;
        record_side(out, swapped ? front : flat[i % 7]);
        record_side(out, swapped ? flat[i % 7] : front);
    }
}

// From near the origin to thousands of pixels away: differences of corners have more digits than a float.
std::vector<glm::vec2> from_the_origin(Random& random)
{
    const glm::vec2 a(random.uniform(0.25F, 1), random.uniform(0.25F, 1));
    const glm::vec2 along(random.uniform(0.5F, 1), random.uniform(0.5F, 1));
    return {a, a + random.uniform(4000, 8000) * along, a + random.uniform(8000, 16000) * along};
}

// Needles thousands of pixels long: twice their area is some 1/65536 of a pixel.
void record_needles(Random& random, Recorder& out)
{
    for (const int reach : {30, 200, 1000, 4000, 16000})
        for (int i = 0; i < 100; ++i) {
            const auto corners = needle(random, 640, 480, reach, true);
            record_both_sides(random, out, {corners.begin(), corners.end()});
        }
    for (int i = 0; i < 300; ++i) record_both_sides(random, out, from_the_origin(random));
}

constexpr PrimitiveType all_types[] = {points,         lines,        line_strip, line_loop,  triangles,
                                       triangle_strip, triangle_fan, quads,      quad_strip, polygon};

// What a draw is asked to assemble, and where its vertices lie.
struct Vertices {
    std::vector<std::uint32_t> sequence;
    std::vector<glm::vec2> places;
};

// So many vertices in their order, on the whole screen.
Vertices in_order(Random& random, std::uint32_t count) { return {counted(count), random_places(random, count)}; }

// A sequence of any of a few vertices, so that many faces name one twice.
Vertices of_few(Random& random, std::uint32_t count, std::uint32_t vertices)
{
    return {random_sequence(random, count, vertices), random_places(random, vertices)};
}

// The same at the end of a large mesh: 16 bits do not number its vertices.
Vertices behind_a_mesh(Random& random, std::uint32_t count)
{
    Vertices result = of_few(random, count, count);
    constexpr std::uint32_t before = 70'000;
    for (std::uint32_t& vertex : result.sequence) vertex += before;
    result.places.insert(result.places.begin(), before, glm::vec2(320, 240));
    return result;
}

void record_modes(Random& random, Recorder& out)
{
    int draw = 0;
    for (const PrimitiveType type : all_types)
        for (const PolygonMode mode : {PolygonMode::point, PolygonMode::line, PolygonMode::fill})
            for (const Vertices& vertices : {in_order(random, 9), of_few(random, 9, 5), behind_a_mesh(random, 9)})
                record_draw(out, draw++,
                            ask<draw_list>(out, type, vertices.sequence, vertices.places, Culling::none, mode), 30);
    out.text("list.names", draw_names(draw));
}

// More corners than a byte counts, and more vertices than 16 bits.
void record_long(Random& random, Recorder& out)
{
    int draw = 0;
    for (const PolygonMode mode : {PolygonMode::fill, PolygonMode::line}) {
        const std::uint32_t count = 258 + random.below(80);
        record_draw(out, draw++,
                    ask<draw_list>(out, polygon, counted(count), random_places(random, count), Culling::none, mode),
                    count);
    }
    for (const PrimitiveType type : {points, line_loop, triangle_strip, quads})
        record_long_assembly(out, type, random_sequence(random, 65'540 + random.below(300), 70'000));
    out.text("list.names", draw_names(draw));
    name_assembly(out);
}

// Corners of needles, which are triangles; of others they make large faces.
Vertices of_needles(Random& random)
{
    Vertices result{counted(12), {}};
    for (int i = 0; i < 4; ++i)
        for (const glm::vec2& corner : needle(random, 640, 480, 4000, true)) result.places.push_back(corner);
    return result;
}

// Vertices in their order; of a few; of many on a coarse grid, so that faces without area are among them; within a
// pixel or two; of needles; and behind a mesh.
Vertices culled(Random& random, int kind)
{
    Vertices result;
    switch (kind) {
        case 0: return in_order(random, 12);
        case 1: return of_few(random, 12, 5);
        case 2:
            result = of_few(random, 24, 30);
            for (glm::vec2& place : result.places) place = 128.0F * glm::round(place / 128.0F);
            return result;
        case 3:
            result = of_few(random, 12, 12);
            for (glm::vec2& place : result.places) place = 200.0F + place / 256.0F;
            return result;
        case 4: return of_needles(random);
        default: return behind_a_mesh(random, 12);
    }
}

void record_culling(Random& random, Recorder& out)
{
    int draw = 0;
    // As many vertices as make no primitive or hardly one; of each face both sides are culled in turn.
    for (std::uint32_t count = 0; count < 5; ++count)
        for (const PrimitiveType type : all_types) {
            const Vertices vertices = in_order(random, count);
            const auto mode = static_cast<PolygonMode>(random.below(3));
            for (const Culling culling : {Culling::back, Culling::front})
                record_draw(out, draw++, ask<draw_list>(out, type, vertices.sequence, vertices.places, culling, mode),
                            40);
        }
    for (int i = 0; i < 12; ++i)
        for (const PrimitiveType type : all_types) {
            const Vertices vertices = culled(random, i % 6);
            const auto culling = static_cast<Culling>(1 + random.below(2));
            const auto mode = static_cast<PolygonMode>(random.below(3));
            record_draw(out, draw++, ask<draw_list>(out, type, vertices.sequence, vertices.places, culling, mode), 40);
        }
    out.text("list.names", draw_names(draw));
}

// Strips of zigzags, joined by repeating vertices: an odd or an even number of triangles without area between them.
void record_joined(Random& random, Recorder& out)
{
    int draw = 0;
    for (int i = 0; i < 12; ++i) {
        std::vector<glm::vec2> places;
        std::vector<std::uint32_t> sequence;
        for (int strip = 0; strip < 3; ++strip) {
            const std::uint32_t length = 4 + random.below(4);
            const auto first = static_cast<std::uint32_t>(places.size());
            if (strip > 0) sequence.insert(sequence.end(), {sequence.back(), first});
            if (random.below(2) == 0) sequence.push_back(first);
            for (std::uint32_t k = 0; k < length; ++k) {
                places.emplace_back(10 * static_cast<float>(k / 2),
                                    100 * static_cast<float>(strip) + (k % 2 == 0 ? 10.0F : 0.0F));
                sequence.push_back(first + k);
            }
        }
        const auto mode = i % 3 == 0 ? PolygonMode::line : PolygonMode::fill;
        record_draw(
            out, draw++,
            ask<draw_list>(out, triangle_strip, sequence, places, i % 2 == 0 ? Culling::back : Culling::none, mode),
            3 * sequence.size());
    }
    out.text("list.names", draw_names(draw));
}

}

const Driver driver = {
    {"points and lines",
     [](Case& c, Recorder& out) {
         record_sequences(c.vary, out, {points, lines, line_strip, line_loop}, {0, 1, 2, 3, 6, 7});
     }},
    {"triangles",
     [](Case& c, Recorder& out) {
         record_sequences(c.vary, out, {triangles, triangle_strip, triangle_fan}, {0, 2, 3, 4, 7, 9});
     }},
    {"quads and polygons",
     [](Case& c, Recorder& out) {
         record_sequences(c.vary, out, {quads, quad_strip, polygon}, {0, 2, 3, 4, 6, 8, 9});
     }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"sides", [](Case& c, Recorder& out) { record_sides(c.random, out); }},
    {"needles", [](Case& c, Recorder& out) { record_needles(c.random, out); }},
    {"long", [](Case& c, Recorder& out) { record_long(c.random, out); }},
    {"modes", [](Case& c, Recorder& out) { record_modes(c.random, out); }},
    {"culling", [](Case& c, Recorder& out) { record_culling(c.random, out); }},
    {"joined strips", [](Case& c, Recorder& out) { record_joined(c.random, out); }},
    {"gallery", [](Case& c, Recorder& out) { out.image("pictures", gallery(c.vary, out)); }},
};

}
