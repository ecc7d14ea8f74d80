#pragma once

#include <algorithm>
#include <string>

#include "recording_pipeline.hpp"

/// What a recording pipeline took down, as tables for the judges.
namespace umbral::transforms {

/// A code, nine numbers, a colour, a line width, and the depth of the stack.
using EventRow = std::array<float, 15>;

inline constexpr std::string_view drawn_event_names =
    "1 a copy of the figure: x axis/3, y axis/3, origin/3, colour/3, line width, -\n"
    "2 a line: from/3, to/3, -/3, colour/3, line width, -\n"
    "3 push\n"
    "4 pop\n"
    "5 pop of an empty stack\n"
    "6 set_view: x axis/3, y axis/3, origin/3, colour/3, line width, -\n"
    "7 triangles: x axis/3, y axis/3, origin/3, colour/3, line width, -\n"
    "8 a solid: x axis/3, y axis/3, origin/3, colour/3, line width, -\n"
    "9 afterwards: x axis/3, y axis/3, origin/3, colour/3, line width, depth of the stack\n";

inline glm::dvec3 seen_at(const glm::dmat4& modelview, glm::vec2 place)
{
    return glm::dvec3(modelview * glm::dvec4(place, 0, 1));
}

/// `a`, `b`, `c` are what the modelview makes of x axis, y axis and origin, or the places of a line.
inline EventRow event_row(float code, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                          const glm::vec3& color, float width, std::size_t depth = 0)
{
    const auto f = [](double value) { return static_cast<float>(value); };
    return {code,    f(a.x),  f(a.y),  f(a.z), f(b.x),
            f(b.y),  f(b.z),  f(c.x),  f(c.y), f(c.z),
            color.x, color.y, color.z, width,  static_cast<float>(depth)};
}

/// As `event_row`, of what a matrix does to the plane z = 0; its third column is free.
inline EventRow matrix_row(float code, const glm::dmat4& m, const glm::vec3& color, float width, std::size_t depth = 0)
{
    return event_row(code, glm::dvec3(m[0]), glm::dvec3(m[1]), glm::dvec3(m[3]), color, width, depth);
}

/// Is drawn with changes of the stack, or without?
enum class Stack { shown, left_out };

/// Are polylines recorded here, or apart as `sorted_lines`?
enum class Lines { shown, left_out };

/// Are copies of the figure recorded here, or apart?
enum class Figures { shown, left_out };

/// All that was drawn, polylines line by line, and at the end how the pipeline stands.
inline void record_events(Recorder& out, const std::string& name, const RecordingPipeline& drawn, Stack stack,
                          Lines lines = Lines::shown, Figures figures = Figures::shown)
{
    const auto add = [&](const EventRow& row) { out.append(name, std::span<const float>(row)); };
    for (const Call& call : drawn.calls()) {
        const auto matrix = [&](float code) { add(matrix_row(code, call.modelview, call.color, call.line_width)); };
        const auto bare = [&](float code) {
            if (stack == Stack::shown || call.kind == Call::Kind::empty_pop) add(event_row(code, {}, {}, {}, {}, 0));
        };
        switch (call.kind) {
            case Call::Kind::figure:
                if (figures == Figures::shown) matrix(1);
                break;
            case Call::Kind::polyline:
                for (std::size_t i = 1; lines == Lines::shown && i < call.places.size(); ++i)
                    add(event_row(2, seen_at(call.modelview, call.places[i - 1]),
                                  seen_at(call.modelview, call.places[i]), {}, call.color, call.line_width));
                break;
            case Call::Kind::push: bare(3); break;
            case Call::Kind::pop: bare(4); break;
            case Call::Kind::empty_pop: bare(5); break;
            case Call::Kind::set_view: matrix(6); break;
            case Call::Kind::triangles: matrix(7); break;
            case Call::Kind::primitive: matrix(8); break;
        }
    }
    add(matrix_row(9, drawn.modelview(), drawn.color(), drawn.line_width(), drawn.depth()));
}

/// The lines of all polylines, as events: in which order and sense they were drawn does not matter. They are sorted by
/// their places in master coordinates, which no matrix has rounded.
inline std::vector<EventRow> sorted_lines(const RecordingPipeline& drawn)
{
    const auto less = [](glm::vec2 a, glm::vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    using Line = std::pair<std::array<glm::vec2, 2>, EventRow>;
    std::vector<Line> lines;
    for (const Call& call : drawn.calls()) {
        if (call.kind != Call::Kind::polyline) continue;
        for (std::size_t k = 1; k < call.places.size(); ++k) {
            glm::vec2 a = call.places[k - 1];
            glm::vec2 b = call.places[k];
            if (less(b, a)) std::swap(a, b);
            lines.push_back({{a, b},
                             event_row(2, seen_at(call.modelview, a), seen_at(call.modelview, b), {}, call.color,
                                       call.line_width)});
        }
    }
    std::stable_sort(lines.begin(), lines.end(), [&](const Line& one, const Line& other) {
        const auto& [a, b] = one.first;
        const auto& [c, d] = other.first;
        return less(a, c) || (a == c && less(b, d));
    });
    std::vector<EventRow> rows;
    for (const Line& line : lines) rows.push_back(line.second);
    return rows;
}

/// The names of the codes, for a table of events; once for each.
inline void record_names(Recorder& out, const std::string& name) { out.text(name + ".names", drawn_event_names); }

/// A colour as a number that is not 0.
inline std::uint32_t packed(const glm::vec3& color)
{
    const glm::uvec3 bytes(glm::clamp(color, 0.0F, 1.0F) * 255.0F + 0.5F);
    return 0x1000000U | (bytes.x << 16U) | (bytes.y << 8U) | bytes.z;
}

/// Which colour the middle of each cell of a rectangle is filled with, if any, row by row from above: whatever
/// triangles were used to fill it.
inline Grid<std::uint32_t> filled_cells(const RecordingPipeline& drawn, int width, int height, glm::dvec2 low,
                                        glm::dvec2 high)
{
    Grid<std::uint32_t> cells(width, height);
    const glm::dvec2 cell = (high - low) / glm::dvec2(width, height);
    for (const Call& call : drawn.calls()) {
        if (call.kind != Call::Kind::triangles) continue;
        for (std::size_t i = 0; i + 2 < call.places.size(); i += 3) {
            std::array<glm::dvec2, 3> corner;
            for (std::size_t k = 0; k < 3; ++k)
                corner[k] = (glm::dvec2(seen_at(call.modelview, call.places[i + k])) - low) / cell;
            const auto side = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
                return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
            };
            const glm::dvec2 least = glm::clamp(glm::min(corner[0], glm::min(corner[1], corner[2])), glm::dvec2(0),
                                                glm::dvec2(width, height));
            const glm::dvec2 most = glm::clamp(glm::max(corner[0], glm::max(corner[1], corner[2])), glm::dvec2(0),
                                               glm::dvec2(width, height));
            if (!(least.x <= most.x) || !(least.y <= most.y)) continue;
            for (int y = static_cast<int>(least.y); y < std::min(height, static_cast<int>(most.y) + 1); ++y) {
                for (int x = static_cast<int>(least.x); x < std::min(width, static_cast<int>(most.x) + 1); ++x) {
                    const glm::dvec2 p(x + 0.5, y + 0.5);
                    const double a = side(corner[0], corner[1], p);
                    const double b = side(corner[1], corner[2], p);
                    const double c = side(corner[2], corner[0], p);
                    if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0))
                        cells.at(x, height - 1 - y) = packed(call.color);
                }
            }
        }
    }
    return cells;
}

}
