#include <kit/drawing.hpp>
#include <kit/varied.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "buffers.hpp"
#include "fetches.hpp"
#include "layouts.hpp"

namespace umbral {
namespace {

using namespace pipeline;

/// Attributes that are written down, in another order, some with a component more or less.
std::vector<VertexAttribute> varied(Variation& vary, std::vector<VertexAttribute> attributes)
{
    for (VertexAttribute& attribute : attributes)
        attribute.components = std::clamp(vary.near(attribute.components, 1U), 1U, 4U);
    return in_random_order(vary, std::move(attributes));
}

void record_course(Variation& vary, Recorder& out)
{
    for (const std::uint64_t written : {1U, 8U, 1000U})
        for (const std::vector<VertexAttribute>& attributes :
             {course_vertex, {floats(3)}, {floats(2), floats(3)}, {floats(4), floats(1), floats(3)}}) {
            const std::uint64_t vertices = vary.near(written, written / 4);
            record_layouts(out, varied(vary, attributes), vertices);
        }
}

// Small numbers beside large ones, as a C++ struct would have them.
void record_mixed(Variation& vary, Recorder& out)
{
    using enum ComponentType;
    const std::vector<std::vector<VertexAttribute>> all = {
        {{float64, 3}, {unsigned_byte, 4, true}, floats(3)},
        {floats(3), {unsigned_byte, 1}, {unsigned_short, 2, true}},
        {{unsigned_byte, 3}, {float64, 2}, {unsigned_byte, 1}},
        {{float64, 1}, {unsigned_short, 1}},
        {{unsigned_short, 3}, {unsigned_int, 1}, {unsigned_byte, 2}},
        {{unsigned_byte, 4, true}, {unsigned_short, 4}},
        {floats(3), {float64, 2}, floats(1)},
        {{unsigned_byte, 1}, {unsigned_short, 1}, {unsigned_byte, 2}, floats(2), {unsigned_byte, 3}},
        {{unsigned_short, 3}, {unsigned_short, 1}, {unsigned_byte, 1}, {unsigned_byte, 3, true}},
    };
    for (const std::vector<VertexAttribute>& attributes : all)
        for (const std::uint64_t written : {1U, 3U, 5U}) {
            const std::uint64_t vertices =
                written == 1 ? 1 : vary.one_of(written, std::array{written + 4, written + 6});
            record_layouts(out, varied(vary, attributes), vertices);
        }
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const std::vector<VertexAttribute> attributes = random_attributes(random, 7);
        record_layouts(out, attributes, 1 + random.below(i % 4 == 0 ? 2 : 5000));
    }
}

/// Where numbers are floats, some that arithmetic does not leave as they are: -0, infinity, NaN of both kinds.
void put_odd_number(Random& random, std::vector<std::byte>& source, const VertexAttribute& attribute,
                    std::uint64_t place)
{
    constexpr std::uint32_t floats[] = {0x80000000, 0x7f800000, 0xffc00001, 0x7fa00001};
    constexpr std::uint64_t doubles[] = {1ULL << 63U, 0x7ffULL << 52U, 0xfff8000000000001, 0x7ff4000000000001};
    const std::uint32_t which = random.below(4);
    if (attribute.type == ComponentType::float32) put(source, place, floats[which]);
    if (attribute.type == ComponentType::float64) put(source, place, doubles[which]);
}

/// What repack makes of them: so many bytes at the beginning of each stretch of the result.
void record_repacked(Random& random, Recorder& out, const std::vector<VertexAttribute>& attributes,
                     std::uint64_t vertices, const VertexLayout& from, const VertexLayout& to, std::uint64_t bytes = 1,
                     std::uint64_t stretch = 1)
{
    std::vector<std::byte> source = random_bytes(random, from.bytes);
    for (std::size_t i = 0; i < attributes.size(); ++i)
        put_odd_number(random, source, attributes[i], from.places[i].offset);
    const std::vector<std::byte> result = ask<repack>(out, source, from, to, attributes, vertices);
    for (std::size_t i = 0; i < to.bytes; ++i)
        if (i % stretch < bytes)
            out.append("bytes", i < result.size()
                                    ? std::optional<float>(static_cast<float>(std::to_integer<int>(result[i])))
                                    : std::nullopt);
}

// The course's vertex between the two layouts, written out here.
void record_conversions(Random& random, Recorder& out)
{
    const VertexLayout interleaved{{{0, 44}, {12, 44}, {24, 44}, {36, 44}}, 352};
    const VertexLayout separate{{{0, 12}, {96, 12}, {192, 12}, {288, 8}}, 352};
    record_repacked(random, out, course_vertex, 8, interleaved, separate);
    record_repacked(random, out, course_vertex, 8, separate, interleaved);
}

// Every other one also from a layout of wide gaps to itself: what stands in them stays behind.
void record_any_layout(Random& random, Recorder& out, bool zeros)
{
    for (int i = 0; i < 12; ++i) {
        const std::vector<VertexAttribute> attributes = random_attributes(random, 5);
        const std::uint64_t vertices = 2 + random.below(5);
        const VertexLayout from = some_layout(random, attributes, vertices, zeros ? 1 : 6, zeros && i % 3 != 0);
        const VertexLayout to = some_layout(random, attributes, vertices, zeros ? 1 : 6, zeros && i % 3 != 1);
        record_repacked(random, out, attributes, vertices, from, to);
        if (zeros || i % 2 != 0) continue;
        const VertexLayout kept = some_layout(random, attributes, vertices, 24, false);
        record_repacked(random, out, attributes, vertices, kept, kept);
    }
}

// Vertices as far from each other as 16 bits do not tell, and more of them than 16 bits number.
void record_far_vertices(Random& random, Recorder& out)
{
    const std::vector<VertexAttribute> attributes = {{ComponentType::unsigned_byte, 1 + random.below(4), true},
                                                     {ComponentType::unsigned_short, 1 + random.below(2)}};
    const std::uint64_t second = tuple_bytes(attributes[0]);
    const std::uint64_t stride = second + tuple_bytes(attributes[1]);
    const std::uint64_t apart = 65'536 + stride + random.below(5'000);
    const VertexLayout narrow{{{0, stride}, {second, stride}}, 2 * stride};
    const VertexLayout wide{{{0, apart}, {second, apart}}, 2 * apart};
    record_repacked(random, out, attributes, 2, wide, narrow);
    record_repacked(random, out, attributes, 2, narrow, wide, 25, apart);

    const std::vector<VertexAttribute> bytes = {{ComponentType::unsigned_byte, 1}};
    const std::uint64_t vertices = 65'600 + random.below(1000);
    record_repacked(random, out, bytes, vertices, {{{0, 1}}, vertices}, {{{3, 1}}, vertices + 3}, 60, 65'537);

    for (const ComponentType type : {ComponentType::unsigned_short, ComponentType::float64}) {
        const VertexAttribute attribute{type, 1 + random.below(4)};
        const std::vector<std::byte> buffer = random_bytes(random, apart + tuple_bytes(attribute));
        for (const std::uint64_t vertex : {0U, 1U}) record_fetch(out, buffer, attribute, {0, apart}, vertex);
    }
    const std::vector<std::byte> many = random_bytes(random, vertices);
    for (const std::uint64_t vertex : {65'535U, 65'536U + random.below(60)})
        record_fetch(out, many, bytes[0], {0, 1}, vertex);
}

// Vertices of 11 floats: a star, its colours and the rest.
std::vector<std::byte> star(std::uint64_t vertices)
{
    std::vector<std::byte> bytes(44 * vertices);
    for (std::uint64_t i = 0; i < vertices; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(vertices);
        const double radius = i % 2 == 0 ? 1 : 0.55;
        put(bytes, 12 * i, static_cast<float>(radius * std::sin(angle)));
        put(bytes, 12 * i + 4, static_cast<float>(radius * std::cos(angle)));
        for (std::uint64_t c = 0; c < 3; ++c)
            put(bytes, 12 * (vertices + i) + 4 * c,
                static_cast<float>(0.55 + 0.4 * std::cos(angle - 2.1 * static_cast<double>(c))));
        put(bytes, 24 * vertices + 12 * i + 8, 1.0F);
    }
    return bytes;
}

// Which attribute a byte belongs to in a layout, and whose vertex: one small square for each float, 22 in a row.
void draw_memory(Drawing& drawing, const VertexLayout& layout, std::uint64_t vertices, glm::dvec2 corner)
{
    const glm::vec3 inks[] = {ink::blue, ink::orange, ink::green, ink::pink};
    const auto cell = [&](std::uint64_t word) {
        return corner + glm::dvec2(static_cast<double>(word % 22), -static_cast<double>(word / 22));
    };
    const auto square = [&](std::uint64_t word, glm::vec3 color, double alpha) {
        const glm::dvec2 p = cell(word);
        drawing.area(
            std::vector<glm::dvec2>{p + 0.06, p + glm::dvec2(0.94, 0.06), p + 0.94, p + glm::dvec2(0.06, 0.94)}, color,
            alpha);
    };
    for (std::uint64_t word = 0; word < 11 * vertices; ++word) square(word, ink::slate, 0.5);
    for (std::size_t i = 0; i < std::min(layout.places.size(), course_vertex.size()); ++i)
        for (std::uint64_t vertex = 0; vertex < vertices; ++vertex)
            for (std::uint64_t c = 0; c < course_vertex[i].components; ++c) {
                const std::uint64_t byte = layout.places[i].offset + vertex * layout.places[i].stride + 4 * c;
                if (byte < 44 * vertices) square(byte / 4, inks[i], vertex % 2 == 0 ? 1 : 0.62);
            }
}

// Left: the two layouts in memory. Right: a star whose vertices were interleaved, and then fetched.
Image picture(Variation& vary, Recorder& out)
{
    const std::uint64_t vertices = vary.one_of<std::uint64_t>(16, std::array<std::uint64_t, 3>{10, 12, 14});
    Drawing drawing(660, 340, {-1, -9.5}, {40, 11.6});
    draw_memory(drawing, ask<interleaved_layout>(out, course_vertex, vertices), vertices, {0, 9.2});
    draw_memory(drawing, ask<separate_layout>(out, course_vertex, vertices), vertices, {0, -1.2});

    const VertexLayout separate{{{0, 12}, {12 * vertices, 12}, {24 * vertices, 12}, {36 * vertices, 8}}, 44 * vertices};
    const VertexLayout interleaved{{{0, 44}, {12, 44}, {24, 44}, {36, 44}}, 44 * vertices};
    std::vector<std::byte> buffer = ask<repack>(out, star(vertices), separate, interleaved, course_vertex, vertices);
    buffer.resize(44 * vertices);
    const auto place = [&](std::uint64_t vertex) {
        return glm::dvec2(31, 1) + 7.8 * glm::dvec2(ask<fetch_attribute>(out, buffer, course_vertex[0],
                                                                         interleaved.places[0], vertex % vertices));
    };
    const auto color = [&](std::uint64_t vertex) {
        return glm::vec3(ask<fetch_attribute>(out, buffer, course_vertex[1], interleaved.places[1], vertex % vertices));
    };
    for (std::uint64_t i = 0; i < vertices; ++i) {
        drawing.area(std::vector<glm::dvec2>{{31, 1}, place(i), place(i + 1)}, 0.5F * (color(i) + color(i + 1)));
        drawing.line(place(i), place(i + 1), ink::white, 1.5);
    }
    for (std::uint64_t i = 0; i < vertices; ++i) drawing.disc(place(i), 5, color(i));
    return drawing.picture();
}

}

const Driver driver = {
    {"course vertex", [](Case& c, Recorder& out) { record_course(c.vary, out); }},
    {"mixed types", [](Case& c, Recorder& out) { record_mixed(c.vary, out); }},
    {"nothing", [](Case& c, Recorder& out) { record_nothing(c.random, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"large", [](Case& c, Recorder& out) { record_large(c.random, out); }},
    {"huge", [](Case& c, Recorder& out) { record_huge(c.random, out); }},
    {"conversions", [](Case& c, Recorder& out) { record_conversions(c.random, out); }},
    {"any layout", [](Case& c, Recorder& out) { record_any_layout(c.random, out, false); }},
    {"far apart", [](Case& c, Recorder& out) { record_far_vertices(c.random, out); }},
    {"fetched floats", [](Case& c, Recorder& out) { record_fetches(c.random, out, false, false); }},
    {"fetched whole numbers", [](Case& c, Recorder& out) { record_fetches(c.random, out, true, false); }},
    {"stride zero",
     [](Case& c, Recorder& out) {
         record_any_layout(c.random, out, true);
         record_fetches(c.random, out, false, true);
     }},
    {"picture", [](Case& c, Recorder& out) { out.image("memory", picture(c.vary, out)); }},
};

}
