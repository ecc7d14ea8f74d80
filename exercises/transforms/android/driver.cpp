#include <array>
#include <limits>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>
#include <umbral/transforms/android.hpp>

#include "../solid_rows.hpp"
#include "parade.hpp"

namespace umbral {
namespace {

using namespace transforms;

/// What the android draws when the pipeline stands like this, in any order; and in which order, and how the pipeline
/// stands afterwards, if these have a name.
void record(Recorder& out, const Android& android, const Start& start, const char* order = nullptr,
            const char* state = nullptr)
{
    RecordingPipeline drawn(start);
    introduce(out, drawn, start);
    ask<&Android::draw>(out, android, drawn);
    const std::vector<DrawnSolid> solids = sorted_solids(drawn, start);
    for (const DrawnSolid& solid : solids) {
        out.append("solids", std::span<const float>(solid.row));
        if (order != nullptr) out.append(order, solid.place);
    }
    for (const Call& call : drawn.calls()) {
        if (call.kind == Call::Kind::push || call.kind == Call::Kind::pop || call.kind == Call::Kind::primitive)
            continue;
        constexpr SolidRow no_solid{9};
        out.append("solids", std::span<const float>(no_solid));
    }
    if (state == nullptr || solids.empty()) return;
    const glm::mat4 m(drawn.modelview());
    const glm::vec3 color = drawn.color();
    const std::array<float, 18> row{3,
                                    m[0].x,
                                    m[0].y,
                                    m[0].z,
                                    m[1].x,
                                    m[1].y,
                                    m[1].z,
                                    m[2].x,
                                    m[2].y,
                                    m[2].z,
                                    m[3].x,
                                    m[3].y,
                                    m[3].z,
                                    color.x,
                                    color.y,
                                    color.z,
                                    drawn.line_width(),
                                    static_cast<float>(drawn.depth())};
    out.append(state, std::span<const float>(row));
}

void record_names(Recorder& out)
{
    out.text("solids.names",
             "1 half sphere: middle/3, axis as x 0 0 y z 0/6, square of the radius as xx yy zz xy xz yz/6, colour/3\n"
             "2 cylinder: middle/3, product of the axis with its direction as xx yy zz xy xz yz/6, square of the "
             "radius likewise/6, colour/3\n"
             "9 something that is no solid\n");
}

/// Anywhere in space, any colour.
Start somewhere(Random& random)
{
    Start start = random_start(random);
    const glm::vec3 place = 3.0F * random.in_cube();
    const glm::mat4 turned =
        glm::rotate(glm::translate(glm::mat4(1), place), random.uniform(-3, 3), random.unit_vector());
    start.modelview = glm::scale(turned, {random.uniform(0.5F, 2), random.uniform(0.5F, 2), random.uniform(0.5F, 2)});
    return start;
}

void pose(Recorder& out, Android& android, Random& random, double reach)
{
    const auto angle = [&] { return reach * (2 * random.uniform_double() - 1); };
    ask<&Android::set_left_arm>(out, android, angle());
    ask<&Android::set_right_arm>(out, android, angle());
    ask<&Android::set_head>(out, android, angle());
}

void record_at_rest(Recorder& out, Random& random)
{
    record_names(out);
    const std::unique_ptr<Android> android = ask_new<make_android>(out, "android");
    if (!android) return;
    record(out, *android, {.color = {0.2F, 0.7F, 0.3F}}, "order");
    for (int i = 0; i < 2; ++i) record(out, *android, somewhere(random), "order");
}

// One joint at a time, by much, by little, and back to rest: what else moves with it? Steps as small as those of a slow
// animation count as well.
void record_joints(Variation& vary, Random& random, Recorder& out)
{
    record_names(out);
    const std::unique_ptr<Android> android = ask_new<make_android>(out, "android");
    if (!android) return;
    const Start start{.color = vary.near(glm::vec3(0.2F, 0.7F, 0.3F), 0.15F)};
    using Set = void(Recorder&, Android&, double);
    constexpr std::array<Set*, 3> setters = {
        [](Recorder& o, Android& a, double angle) { ask<&Android::set_left_arm>(o, a, angle); },
        [](Recorder& o, Android& a, double angle) { ask<&Android::set_right_arm>(o, a, angle); },
        [](Recorder& o, Android& a, double angle) { ask<&Android::set_head>(o, a, angle); }};
    for (Set* const set : setters) {
        const double more = vary.near(1.0, 0.3);
        for (const double angle : {0.5, 0.5 + 6e-5 + 3e-4 * random.uniform_double(), -1.25, 0.0}) {
            set(out, *android, more * angle);
            record(out, *android, start);
        }
    }
}

double not_finite(int which)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::array values{infinity, std::numeric_limits<double>::quiet_NaN(), -infinity};
    return values.at(static_cast<std::size_t>(which) % values.size());
}

void record_poses(Recorder& out, Random& random)
{
    record_names(out);
    out.text("state.names",
             "3 afterwards: x axis/3, y axis/3, z axis/3, origin/3, colour/3, line width, depth of the stack\n");
    const std::unique_ptr<Android> android = ask_new<make_android>(out, "android");
    if (!android) return;
    for (int i = 0; i < 12; ++i) {
        pose(out, *android, random, 3.1);
        if (i % 3 == 0 || random.below(4) == 0) ask<&Android::set_left_arm>(out, *android, not_finite(i / 3));
        if (i % 3 == 1 || random.below(4) == 0) ask<&Android::set_right_arm>(out, *android, not_finite(i / 3));
        if (i % 3 == 2 || random.below(4) == 0) ask<&Android::set_head>(out, *android, not_finite(i / 3));
        record(out, *android, somewhere(random), nullptr, "state");
    }
}

void record_two(Recorder& out, Random& random)
{
    record_names(out);
    const std::unique_ptr<Android> one = ask_new<make_android>(out, "one");
    const std::unique_ptr<Android> other = ask_new<make_android>(out, "other");
    if (!one || !other) return;
    for (int i = 0; i < 4; ++i) {
        pose(out, i % 2 == 0 ? *one : *other, random, 3.1);
        record(out, *one, {});
        record(out, *other, {});
    }
}

// Three angles that are set a hundred thousand times each, in small steps round and round; then ever larger ones, drawn
// twice.
void record_long_dance(Recorder& out, Random& random)
{
    record_names(out);
    const std::unique_ptr<Android> android = ask_new<make_android>(out, "android");
    if (!android) return;
    double angles[3] = {};
    for (int step = 1; step <= 100'000; ++step) {
        for (double& angle : angles) angle += 0.03 * random.uniform_double() - 0.01;
        ask<&Android::set_left_arm>(out, *android, angles[0]);
        ask<&Android::set_right_arm>(out, *android, angles[1]);
        ask<&Android::set_head>(out, *android, angles[2]);
        if (step % 20'000 == 0) record(out, *android, {});
    }
    for (const double reach : {1e5, 1e7, 1e9, 5e10}) {
        pose(out, *android, random, reach);
        for (int draw = 0; draw < 2; ++draw) record(out, *android, {});
    }
}

}

const Driver driver = {
    {"at rest", [](Case& c, Recorder& out) { record_at_rest(out, c.random); }},
    {"joints", [](Case& c, Recorder& out) { record_joints(c.vary, c.random, out); }},
    {"poses", [](Case& c, Recorder& out) { record_poses(out, c.random); }},
    {"two androids", [](Case& c, Recorder& out) { record_two(out, c.random); }},
    {"long dance", [](Case& c, Recorder& out) { record_long_dance(out, c.random); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_parade(c.vary, out)); }},
};

}
