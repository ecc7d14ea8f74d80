#include <numbers>
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

/// Everything that a drawing function draws and leaves behind, for five states that it finds.
template <class Draw>
void record_figure(Recorder& out, Random& random, Stack stack, Draw draw)
{
    for (int i = 0; i < 5; ++i) {
        RecordingPipeline drawn(i == 0 ? Start{} : random_start(random));
        draw(drawn);
        record_events(out, "drawn", drawn, stack);
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

/// Both ways to place a hook, each from a new state, or from the identity. Who draws none has left no state either.
void record_both(Recorder& out, const std::vector<Ends>& all, Random* starts = nullptr)
{
    for (const Ends& ends : all) {
        RecordingPipeline drawn(starts == nullptr ? Start{} : random_start(*starts));
        draw_hook_between(drawn, drawn.marker(), ends.from, ends.to);
        bool any = false;
        for (const Call& call : drawn.calls()) {
            if (call.kind != Call::Kind::figure) continue;
            out.append("drawn", in_the_plane(call.modelview));
            any = true;
        }
        if (any) {
            const EventRow after = matrix_row(9, drawn.modelview(), drawn.color(), drawn.line_width(), drawn.depth());
            out.append("state", std::span<const float>(after));
        }
        out.append("matrix", hook_matrix(ends.from, ends.to));
    }
}

// Along the axes, and between them. Lengths are powers of two and places multiples of 1/4: nothing need be rounded.
std::vector<Ends> all_directions()
{
    std::vector<Ends> all;
    for (const float size : {1.0F, 2.0F, 0.25F})
        for (const glm::vec2& from : {glm::vec2(0, 0), glm::vec2(3, -1.25F)})
            for (const glm::vec2& way : {glm::vec2(0, 1), glm::vec2(1, 0), glm::vec2(0, -1), glm::vec2(-1, 0)})
                all.push_back({glm::vec3(from, 1), glm::vec3(from + size * way, 1)});
    return all;
}

std::vector<Ends> random_pairs(Random& random, int count)
{
    std::vector<Ends> all;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 from = 4.0F * random.in_cube();
        const glm::vec3 to = 4.0F * random.in_cube();
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
        add({0, 0}, 1e-30F * way);
        add({0, 0}, 1e-22F * way);
        add(1e20F * place, 1e20F * way);
        add(1e30F * place, 1e30F * way);
        const glm::vec2 far = glm::round(1e6F * place);
        add(far, far + glm::round(16.0F * way));
    }
    return all;
}

void record_circles(Recorder& out, std::initializer_list<unsigned> counts, Random& random)
{
    for (const unsigned count : counts) {
        RecordingPipeline drawn(random_start(random));
        draw_hook_circle(drawn, drawn.marker(), count);
        record_events(out, "drawn", drawn, Stack::left_out);
    }
    record_names(out, "drawn");
}

}

const Driver driver = {
    {"hook", [](Case& c, Recorder& out) { record_figure(out, c.random, Stack::shown, draw_hook); }},
    {"four hooks",
     [](Case& c, Recorder& out) {
         record_figure(out, c.random, Stack::shown,
                       [](RecordingPipeline& drawn) { draw_four_hooks(drawn, drawn.marker()); });
     }},
    {"directions", [](Case&, Recorder& out) { record_both(out, all_directions()); }},
    {"two places",
     [](Case& c, Recorder& out) {
         const std::vector<Ends> pairs = random_pairs(c.random, 80);
         record_both(out, pairs, &c.random);
     }},
    {"hard places", [](Case& c, Recorder& out) { record_both(out, hard_pairs(c.random)); }},
    {"circle",
     [](Case& c, Recorder& out) {
         record_circles(out, {5, 8, 3, 2, 1}, c.random);
     }},
    {"any circle",
     [](Case& c, Recorder& out) {
         record_circles(out, {4 + c.random.below(8), 13 + c.random.below(30)}, c.random);
     }},
    {"picture", [](Case&, Recorder& out) { out.image("colours", draw_wheel()); }},
};

}
