#include <algorithm>
#include <cmath>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../drawn_events.hpp"
#include "rosette.hpp"
#include "sessions.hpp"

namespace umbral {
namespace {

using namespace transforms;

void record(Recorder& out, const MatrixStack& stack)
{
    out.append("modelview", ask<&MatrixStack::modelview>(out, stack));
    out.append("normals", up_to_scale(ask<&MatrixStack::normal_matrix>(out, stack)));
}

void record_session(Recorder& out, const std::vector<Step>& steps)
{
    const std::unique_ptr<MatrixStack> stack = ask_new<make_matrix_stack>(out, "stack");
    if (!stack) return;
    for (const Step& step : steps) {
        apply(out, *stack, step);
        record(out, *stack);
    }
}

// Pops that must work and pops that must not, two by two in random order; whatever was thrown, the stack must go on
// as if nothing had been asked.
void record_pops(Recorder& out, Random& random)
{
    out.columns("thrown", "thrown (0: nothing; 1: EmptyStack; 2: another exception)");
    for (int i = 0; i < 40; ++i) {
        const bool first_works = random.below(2) == 0;
        for (const bool works : {first_works, !first_works}) {
            const std::vector<Step> steps = steps_before_a_pop(random, works);
            const std::unique_ptr<MatrixStack> stack = ask_new<make_matrix_stack>(out, "stack");
            if (!stack) return;
            for (const Step& step : steps) apply(out, *stack, step);
            out.append("thrown", thrown_by_pop(out, *stack));
            out.append("modelview", ask<&MatrixStack::modelview>(out, *stack));
            ask<&MatrixStack::push>(out, *stack);
            ask<&MatrixStack::compose>(out, *stack, quarter_turn(1));
            out.append("modelview", ask<&MatrixStack::modelview>(out, *stack));
            (void)thrown_by_pop(out, *stack);
            out.append("modelview", ask<&MatrixStack::modelview>(out, *stack));
        }
    }
}

// Far more than the 32 matrices that OpenGL's own stack can hold.
void record_deep(Recorder& out, Random& random)
{
    const int depth = 100'000 + static_cast<int>(random.below(40'000));
    const std::unique_ptr<MatrixStack> stack = ask_new<make_matrix_stack>(out, "stack");
    if (!stack) return;
    for (int i = 0; i < depth; ++i) {
        ask<&MatrixStack::push>(out, *stack);
        ask<&MatrixStack::compose>(out, *stack, quarter_turn(i % 3));
    }
    for (int i = 0; i < depth; ++i) {
        if (i % 4999 == 0) out.append("modelview", ask<&MatrixStack::modelview>(out, *stack));
        ask<&MatrixStack::pop>(out, *stack);
    }
    out.append("modelview", ask<&MatrixStack::modelview>(out, *stack));
}

void record_two(Recorder& out, Random& random)
{
    const std::unique_ptr<MatrixStack> one = ask_new<make_matrix_stack>(out, "one");
    const std::unique_ptr<MatrixStack> other = ask_new<make_matrix_stack>(out, "other");
    if (!one || !other) return;
    const std::vector<Step> first = random_session(random, 30);
    const std::vector<Step> second = random_session(random, 30);
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
        apply(out, *one, first[i]);
        apply(out, *other, second[i]);
        record(out, *one);
        record(out, *other);
    }
}

// Each pop brings back exactly what was pushed, however much was composed since. Two of three chains are what turns in
// an animation: in each frame something is drawn a little aside, between a push and a pop.
void record_long_chains(Recorder& out, Random& random)
{
    for (int chain = 0; chain < 3; ++chain) {
        const glm::vec3 axis = random.unit_vector();
        const glm::mat4 aside = rigid(random);
        const std::unique_ptr<MatrixStack> stack = ask_new<make_matrix_stack>(out, "stack");
        if (!stack) return;
        for (int i = 1; i <= 30'000; ++i) {
            ask<&MatrixStack::compose>(out, *stack, glm::rotate(glm::mat4(1), 1e-3F, axis));
            if (chain > 0) {
                ask<&MatrixStack::push>(out, *stack);
                ask<&MatrixStack::compose>(out, *stack, aside);
                ask<&MatrixStack::pop>(out, *stack);
            }
            if (i % 3000 != 0) continue;
            out.append("modelview", ask<&MatrixStack::modelview>(out, *stack));
            ask<&MatrixStack::push>(out, *stack);
        }
        for (int i = 0; i < 10; ++i) {
            ask<&MatrixStack::pop>(out, *stack);
            out.append("modelview", ask<&MatrixStack::modelview>(out, *stack));
        }
    }
}

// Models in other units, every other one in a mirror: a scale of 1e-14 has a determinant of 1e-42.
void record_scales(Recorder& out, Random& random)
{
    for (const float power : {-17.0F, -14.0F, -12.0F, -9.0F, -6.0F, 6.0F, 9.0F, 12.0F, 14.0F, 17.0F}) {
        for (int i = 0; i < 6; ++i) {
            const glm::mat4 view = rigid(random);
            const glm::mat4 turn = rigid(random);
            const float scale = std::pow(10.0F, power + random.uniform(-0.5F, 0.5F));
            glm::vec3 size;
            for (int k = 0; k < 3; ++k) size[k] = scale * random.uniform(1, 3);
            if (i % 2 == 0) size[static_cast<int>(random.below(3))] *= -1.0F;
            const std::unique_ptr<MatrixStack> stack = ask_new<make_matrix_stack>(out, "stack");
            if (!stack) return;
            ask<&MatrixStack::set_view>(out, *stack, view);
            ask<&MatrixStack::compose>(out, *stack, turn);
            ask<&MatrixStack::compose>(out, *stack, glm::scale(glm::mat4(1), size));
            out.append("normals", up_to_scale(ask<&MatrixStack::normal_matrix>(out, *stack)));
        }
    }
}

// The figure as it is, and in three places that nobody can have expected. Who fills nothing has left no state either.
void record_simple(Recorder& out, Random& random)
{
    constexpr int size = 96;
    std::vector<Start> starts = {{.color = {0.2F, 0.6F, 0.9F}, .background = {0.1F, 0.1F, 0.2F}}};
    while (starts.size() < 4) starts.push_back(random_start(random));
    Grid<std::uint32_t> all(size, 4 * size);
    Grid<std::uint32_t> other_colors(size, 4 * size);
    for (int i = 0; i < 4; ++i) {
        const Start& start = starts[static_cast<std::size_t>(i)];
        RecordingPipeline drawn(start);
        introduce(out, drawn, start);
        ask<draw_simple_figure>(out, drawn);
        const double reach = i == 0 ? 1.25 : 4;
        const Grid<std::uint32_t> cells = filled_cells(drawn, size, size, glm::dvec2(-reach), glm::dvec2(reach));
        std::copy(cells.cells.begin(), cells.cells.end(), all.cells.begin() + i * size * size);
        out.tile("cells", 0, i * size, size, size);
        // What the figure does not fill with the current colour is a small part of it, and easily wrong by itself.
        std::replace_copy(cells.cells.begin(), cells.cells.end(), other_colors.cells.begin() + i * size * size,
                          packed(start.color), 0U);
        out.tile("triangle", 0, i * size, size, size);
        for (const Call& call : drawn.calls())
            if (call.kind == Call::Kind::polyline || call.kind == Call::Kind::primitive)
                out.append("state", std::span<const float>(matrix_row(8, call.modelview, call.color, call.line_width)));
        const auto filled = [](const Call& call) { return call.kind == Call::Kind::triangles && !call.places.empty(); };
        if (std::none_of(drawn.calls().begin(), drawn.calls().end(), filled)) continue;
        const EventRow after = matrix_row(9, drawn.modelview(), drawn.color(), drawn.line_width(), drawn.depth());
        out.append("state", std::span<const float>(after));
    }
    out.buffer("cells", all);
    out.buffer("triangle", other_colors);
    record_names(out, "state");
}

void record_complex(Recorder& out, Random& random)
{
    for (int i = 0; i < 5; ++i) {
        const Start start = i == 0 ? Start{} : random_start(random);
        RecordingPipeline drawn(start);
        const Figure figure = drawn.marker();
        introduce(out, drawn, start);
        introduce(out, figure, "figure");
        ask<draw_complex_figure>(out, drawn, figure);
        record_events(out, "drawn", drawn, Stack::left_out);
    }
    record_names(out, "drawn");
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_session(out, known_session(c.vary)); }},
    {"random",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 20; ++i) {
             record_session(out, random_session(c.random, 60, i % 2 == 0 ? Volume::any : Volume::kept));
             record_session(out, slanted_frames(c.random, 9));
         }
     }},
    {"empty stack", [](Case& c, Recorder& out) { record_pops(out, c.random); }},
    {"deep", [](Case& c, Recorder& out) { record_deep(out, c.random); }},
    {"two stacks", [](Case& c, Recorder& out) { record_two(out, c.random); }},
    {"long chains", [](Case& c, Recorder& out) { record_long_chains(out, c.random); }},
    {"tiny and huge", [](Case& c, Recorder& out) { record_scales(out, c.random); }},
    {"simple figure", [](Case& c, Recorder& out) { record_simple(out, c.random); }},
    {"complex figure", [](Case& c, Recorder& out) { record_complex(out, c.random); }},
    {"picture", [](Case&, Recorder& out) { out.image("colours", draw_rosette(out)); }},
};

}
