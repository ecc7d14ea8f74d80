#include <array>
#include <limits>
#include <umbral/record/driver.hpp>
#include <umbral/transforms/android.hpp>

#include "../drawn_events.hpp"
#include "parade.hpp"

namespace umbral {
namespace {

using namespace transforms;

/// A code, 12 numbers that say where a solid of revolution is, its colour, and the depth of the stack.
using SolidRow = std::array<float, 17>;

/// Turned or mirrored about its own axis y, a solid looks the same: its origin, its axis, and the sum of the squares of
/// its other two axes stay.
SolidRow solid_row(float code, const glm::dmat4& m, const glm::vec3& color, std::size_t depth)
{
    const auto f = [](double value) { return static_cast<float>(value); };
    const glm::dvec3 x(m[0]);
    const glm::dvec3 z(m[2]);
    const glm::dmat3 s = outerProduct(x, x) + outerProduct(z, z);
    return {code,
            f(m[3].x),
            f(m[3].y),
            f(m[3].z),
            f(m[1].x),
            f(m[1].y),
            f(m[1].z),
            f(s[0][0]),
            f(s[1][1]),
            f(s[2][2]),
            f(s[0][1]),
            f(s[0][2]),
            f(s[1][2]),
            color.x,
            color.y,
            color.z,
            static_cast<float>(depth)};
}

/// What the android draws when the pipeline stands like this, and how the pipeline stands afterwards.
void record(Recorder& out, const Android& android, const Start& start)
{
    RecordingPipeline drawn(start);
    android.draw(drawn);
    for (const Call& call : drawn.calls()) {
        if (call.kind == Call::Kind::push || call.kind == Call::Kind::pop) continue;
        const float code = call.kind == Call::Kind::primitive ? static_cast<float>(call.primitive) : 9;
        const SolidRow row = solid_row(code, call.modelview, call.color, 0);
        out.append("solids", std::span<const float>(row));
    }
    // Afterwards the matrix counts as it is.
    const glm::dmat4& m = drawn.modelview();
    const auto f = [](double value) { return static_cast<float>(value); };
    const SolidRow after{3,
                         f(m[3].x),
                         f(m[3].y),
                         f(m[3].z),
                         f(m[1].x),
                         f(m[1].y),
                         f(m[1].z),
                         f(m[0].x),
                         f(m[0].y),
                         f(m[0].z),
                         f(m[2].x),
                         f(m[2].y),
                         f(m[2].z),
                         drawn.color().x,
                         drawn.color().y,
                         drawn.color().z,
                         static_cast<float>(drawn.depth())};
    out.append("solids", std::span<const float>(after));
}

void record_names(Recorder& out)
{
    out.text("solids.names", "1 half sphere\n2 cylinder\n3 afterwards\n9 something that is no solid\n");
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

void pose(Android& android, Random& random, double reach)
{
    const auto angle = [&] { return reach * (2 * random.uniform_double() - 1); };
    android.set_left_arm(angle());
    android.set_right_arm(angle());
    android.set_head(angle());
}

void record_at_rest(Recorder& out, Random& random)
{
    record_names(out);
    const std::unique_ptr<Android> android = make_android();
    if (!android) return;
    record(out, *android, {.color = {0.2F, 0.7F, 0.3F}});
    for (int i = 0; i < 2; ++i) record(out, *android, somewhere(random));
}

// One joint at a time, and back to rest: what else moves with it?
void record_joints(Recorder& out)
{
    record_names(out);
    const std::unique_ptr<Android> android = make_android();
    if (!android) return;
    const Start start{.color = {0.2F, 0.7F, 0.3F}};
    for (const auto set : {&Android::set_left_arm, &Android::set_right_arm, &Android::set_head}) {
        for (const double angle : {0.5, -1.25, 0.0}) {
            ((*android).*set)(angle);
            record(out, *android, start);
        }
    }
}

void record_poses(Recorder& out, Random& random)
{
    record_names(out);
    const std::unique_ptr<Android> android = make_android();
    if (!android) return;
    for (int i = 0; i < 12; ++i) {
        pose(*android, random, 3.1);
        if (i % 3 == 0) android->set_head(std::numeric_limits<double>::quiet_NaN());
        if (i % 4 == 1) android->set_left_arm(std::numeric_limits<double>::infinity());
        record(out, *android, somewhere(random));
    }
}

void record_two(Recorder& out, Random& random)
{
    record_names(out);
    const std::unique_ptr<Android> one = make_android();
    const std::unique_ptr<Android> other = make_android();
    if (!one || !other) return;
    for (int i = 0; i < 4; ++i) {
        pose(i % 2 == 0 ? *one : *other, random, 3.1);
        record(out, *one, {});
        record(out, *other, {});
    }
}

// Three angles that are set a hundred thousand times each, in small steps round and round.
void record_long_dance(Recorder& out, Random& random)
{
    record_names(out);
    const std::unique_ptr<Android> android = make_android();
    if (!android) return;
    double angles[3] = {};
    for (int step = 1; step <= 100'000; ++step) {
        for (double& angle : angles) angle += 0.03 * random.uniform_double() - 0.01;
        android->set_left_arm(angles[0]);
        android->set_right_arm(angles[1]);
        android->set_head(angles[2]);
        if (step % 20'000 == 0) record(out, *android, {});
    }
}

}

const Driver driver = {
    {"at rest", [](Case& c, Recorder& out) { record_at_rest(out, c.random); }},
    {"joints", [](Case&, Recorder& out) { record_joints(out); }},
    {"poses", [](Case& c, Recorder& out) { record_poses(out, c.random); }},
    {"two androids", [](Case& c, Recorder& out) { record_two(out, c.random); }},
    {"long dance", [](Case& c, Recorder& out) { record_long_dance(out, c.random); }},
    {"picture", [](Case&, Recorder& out) { out.image("colours", draw_parade()); }},
};

}
