#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>
#include <umbral/transforms/hook.hpp>

#include "../drawn_events.hpp"
#include "wheel.hpp"

namespace umbral {
namespace {

using namespace transforms;

struct Ends {
    glm::vec3 from;
    glm::vec3 to;
};

/// Everything that is drawn and left behind, for five states that are found.
void record_four_hooks(Recorder& out, Random& random)
{
    for (int i = 0; i < 5; ++i) {
        const Start start = i == 0 ? Start{} : random_start(random);
        RecordingPipeline drawn(start);
        const Figure hook = drawn.marker();
        introduce(out, drawn, start);
        introduce(out, hook, "hook");
        ask<draw_four_hooks>(out, drawn, hook);
        record_events(out, "drawn", drawn, Stack::shown);
    }
    record_names(out, "drawn");
}

/// The hook's lines in any order and sense, whatever else was drawn, and the state afterwards.
void record_hooks(Recorder& out, Random& random)
{
    for (int i = 0; i < 5; ++i) {
        const Start start = i == 0 ? Start{} : random_start(random);
        RecordingPipeline drawn(start);
        introduce(out, drawn, start);
        ask<draw_hook>(out, drawn);
        for (const EventRow& row : sorted_lines(drawn)) out.append("drawn", std::span<const float>(row));
        record_events(out, "drawn", drawn, Stack::left_out, Lines::left_out);
    }
    record_names(out, "drawn");
}

/// Where a hook was drawn. What its matrix does to z is free.
glm::mat4 in_the_plane(const glm::dmat4& modelview)
{
    glm::mat4 matrix(modelview);
    matrix[2] = {0, 0, 1, 0};
    return matrix;
}

/// Translations, rotations and scalings of the plane commute with their own kind, and the last two with each other: the
/// product of each kind, and each matrix that is none of them.
void record_steps(Recorder& out, const std::vector<glm::mat4>& steps)
{
    enum Kind { translation, rotation, scaling, other };
    const auto kind_of = [](const glm::dmat4& m) {
        const double a = m[0][0];
        const double b = m[0][1];
        const double size = 1e-5 * (std::abs(a) + std::abs(b));
        const auto near = [size](double one, double two) { return std::abs(one - two) <= size; };
        if (!near(a, m[1][1]) || !near(b, -m[1][0])) return other;
        if (glm::dvec2(m[3]) != glm::dvec2(0)) return near(a, 1) && near(b, 0) ? translation : other;
        return near(a * a + b * b, 1) ? rotation : near(b, 0) && a > 0 ? scaling : other;
    };
    const auto append = [&out](int kind, const glm::dmat4& m) {
        const glm::vec2 x(m[0]);
        const glm::vec2 y(m[1]);
        const glm::vec2 o(m[3]);
        const std::array row{static_cast<float>(kind + 1), x.x, x.y, y.x, y.y, o.x, o.y};
        out.append("steps", std::span<const float>(row));
    };
    std::array<std::optional<glm::dmat4>, 3> products;
    for (const glm::dmat4 step : steps) {
        const Kind kind = kind_of(step);
        if (kind == other) {
            append(kind, step);
        } else {
            std::optional<glm::dmat4>& product = products[kind];
            product = product.value_or(glm::dmat4(1)) * step;
        }
    }
    for (int kind = 0; kind < other; ++kind)
        if (const auto& product = products[static_cast<std::size_t>(kind)]) append(kind, *product);
}

/// Both ways to place a hook, each from a new state, or from the identity. Who draws none has left no state either.
void record_both(Recorder& out, const std::vector<Ends>& all, Random* starts = nullptr)
{
    for (const Ends& ends : all) {
        const Start start = starts == nullptr ? Start{} : random_start(*starts);
        RecordingPipeline drawn(start);
        const Figure hook = drawn.marker();
        introduce(out, drawn, start);
        introduce(out, hook, "hook");
        ask<draw_hook_between>(out, drawn, hook, ends.from, ends.to);
        bool any = false;
        for (const Call& call : drawn.calls()) {
            if (call.kind != Call::Kind::figure) continue;
            out.append("drawn", in_the_plane(call.modelview));
            any = true;
        }
        if (any) {
            const EventRow after = matrix_row(9, drawn.modelview(), drawn.color(), drawn.line_width(), drawn.depth());
            out.append("state", std::span<const float>(after));
            // Which way a hook of no length points is free.
            if (starts != nullptr && ends.from != ends.to) record_steps(out, drawn.first_steps());
        }
        out.append("matrix", ask<hook_matrix>(out, ends.from, ends.to));
    }
    if (starts == nullptr) return;
    record_names(out, "state");
    out.text("steps.names",
             "1 translation: x axis/2, y axis/2, origin/2\n2 rotation: x axis/2, y axis/2, origin/2\n"
             "3 scaling: x axis/2, y axis/2, origin/2\n4 none of these: x axis/2, y axis/2, origin/2\n");
}

// Along the axes, and between them. Lengths are powers of two and places multiples of 1/4: nothing need be rounded.
std::vector<Ends> all_directions(Variation& vary)
{
    std::vector<Ends> all;
    for (const float written : {1.0F, 2.0F, 0.25F})
        for (const glm::vec2& corner : {glm::vec2(0, 0), glm::vec2(3, -1.25F)})
            for (const glm::vec2& way : {glm::vec2(0, 1), glm::vec2(1, 0), glm::vec2(0, -1), glm::vec2(-1, 0)}) {
                const float size = written * vary.one_of(1.0F, std::array{0.5F, 2.0F, 4.0F});
                const glm::vec2 from = corner + 0.25F * glm::vec2(vary.near(glm::ivec2(0), 6));
                all.push_back({glm::vec3(from, 1), glm::vec3(from + size * way, 1)});
            }
    return all;
}

// Every fifth pair is one place.
std::vector<Ends> random_pairs(Random& random, int count)
{
    std::vector<Ends> all;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 from = 4.0F * random.in_cube();
        const glm::vec3 to = i % 5 == 4 ? from : 4.0F * random.in_cube();
        all.push_back({{from.x, from.y, 1}, {to.x, to.y, 1}});
    }
    return all;
}

// Hooks of no length, of tiny and huge length, and short ones a million units away: floats lie 1/16 apart there.
std::vector<Ends> hard_pairs(Random& random)
{
    std::vector<Ends> all;
    const auto add = [&](const glm::vec2& from, const glm::vec2& to) {
        all.push_back({glm::vec3(from, 1), glm::vec3(to, 1)});
    };
    for (int i = 0; i < 6; ++i) {
        const glm::vec2 place(random.in_cube());
        const glm::vec2 way(random.in_cube());
        add(place, place);
        add({0, 0}, way);
        add({0, 0}, 1e-30F * way);
        add({0, 0}, 1e-22F * way);
        add(1e20F * place, 1e20F * way);
        add(1e30F * place, 1e30F * way);
        const glm::vec2 far = glm::round(1e6F * place);
        add(far, far + glm::round(16.0F * way));
    }
    return all;
}

// Differences of 25 binary digits, half-way between two floats: whoever rounds once takes the even one. A sine, cosine
// or square root in double comes out on either side.
void record_halves(Recorder& out, Random& random)
{
    for (int i = 0; i < 60; ++i) {
        glm::vec3 from(1);
        glm::vec3 to(1);
        for (int k = 0; k < 2; ++k) {
            const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
            const std::uint32_t even = 2 * random.below(1U << 22U);
            const std::uint32_t odd = 2 * random.below(1U << 22U) + 1;
            to[k] = sign * (0.5F + 0x1p-24F * static_cast<float>(even));
            from[k] = -sign * (0.5F + 0x1p-24F * static_cast<float>(odd));
        }
        out.append("matrix", ask<hook_matrix>(out, from, to));
    }
}

/// The copies by their places round the circle, in whatever order they were drawn; then all else.
void record_copies(Recorder& out, const std::string& name, const RecordingPipeline& drawn, const Start& start,
                   unsigned count)
{
    const glm::dmat4 back = inverse(glm::dmat4(start.modelview));
    const auto place = [&](const Call& call) {
        const glm::dvec4 at = back * call.modelview[3];
        const double turns = std::atan2(at.y, at.x) / (2 * std::numbers::pi);
        return std::isfinite(turns) ? std::fmod(std::round(turns * count) + count, std::max(count, 1U)) : 0;
    };
    std::vector<const Call*> copies;
    for (const Call& call : drawn.calls())
        if (call.kind == Call::Kind::figure) copies.push_back(&call);
    std::ranges::stable_sort(copies, {}, [&](const Call* call) { return place(*call); });
    for (const Call* const call : copies)
        out.append(name, std::span<const float>(matrix_row(1, call->modelview, call->color, call->line_width)));
    record_events(out, name, drawn, Stack::left_out, Lines::shown, Figures::left_out);
}

void record_circles(Recorder& out, std::initializer_list<unsigned> counts, Random& random,
                    const std::string& name = "drawn")
{
    for (const unsigned count : counts) {
        const Start start = random_start(random);
        RecordingPipeline drawn(start);
        const Figure hook = drawn.marker();
        introduce(out, drawn, start);
        introduce(out, hook, "hook");
        ask<draw_hook_circle>(out, drawn, hook, count);
        record_copies(out, name, drawn, start, count);
    }
    record_names(out, name);
}

}

const Driver driver = {
    {"hook", [](Case& c, Recorder& out) { record_hooks(out, c.random); }},
    {"four hooks", [](Case& c, Recorder& out) { record_four_hooks(out, c.random); }},
    {"directions", [](Case& c, Recorder& out) { record_both(out, all_directions(c.vary)); }},
    {"two places",
     [](Case& c, Recorder& out) {
         const std::vector<Ends> pairs = random_pairs(c.random, 80);
         record_both(out, pairs, &c.random);
     }},
    {"hard places", [](Case& c, Recorder& out) { record_both(out, hard_pairs(c.random)); }},
    {"half-way numbers", [](Case& c, Recorder& out) { record_halves(out, c.random); }},
    {"few hooks",
     [](Case& c, Recorder& out) {
         record_circles(out, {0, 2, 1, 0, 1, 2}, c.random);
     }},
    {"circle",
     [](Case& c, Recorder& out) {
         record_circles(out, {5, 8, 3, 2, 1}, c.random);
     }},
    {"any circle",
     [](Case& c, Recorder& out) {
         // The small ones last, for whoever keeps the places of the large ones.
         record_circles(out, {260 + c.random.below(200)}, c.random, "many");
         const unsigned some = 13 + c.random.below(30);
         record_circles(out, {some, 4 + c.random.below(8)}, c.random);
     }},
    {"picture", [](Case&, Recorder& out) { out.image("colours", draw_wheel(out)); }},
};

}
