#include <limits>
#include <umbral/projections/camera.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../island.hpp"
#include "../volumes.hpp"
#include "orbits.hpp"
#include "recording_target.hpp"

namespace umbral {
namespace {

using namespace projections;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

using Size = glm::ivec2;

// Square at first, wide, high, the sizes of a minimised window, and some whose product is no int or whose ratio is
// extreme; and each activated twice, in targets of their own.
constexpr Size sizes[] = {{640, 480}, {300, 300}, {100, 400}, {0, 0},         {1920, 1080}, {0, 77},  {640, 0},
                          {-5, 100},  {1, 400},   {7000, 3},  {90000, 70000}, {320, -240},  {-8, -8}, {2, 1}};

/// A size that is one, larger if inputs are to vary; a square remains one, as does what is one pixel wide.
Size varied(Variation& vary, const Size& size)
{
    Random* const random = vary.random();
    if (random == nullptr || size.x <= 0 || size.y <= 0) return size;
    const glm::vec2 factor(random->uniform(1, 2), random->uniform(1, 2));
    const Size larger(factor * glm::vec2(size));
    return size.x == size.y ? Size(larger.x) : larger;
}

template <class AnyCamera>
void record_viewports(Variation& vary, Recorder& out, AnyCamera& camera)
{
    record(out, camera);
    for (const Size& written : sizes) {
        const Size size = varied(vary, written);
        ask<&Camera::set_viewport>(out, camera, size.x, size.y);
        record(out, camera);
    }
    record(out, camera);
}

void record_base(Variation& vary, Recorder& out)
{
    const std::unique_ptr<Camera> camera = ask_new<make_camera>(out, "camera");
    if (camera) record_viewports(vary, out, *camera);
}

std::unique_ptr<OrbitalCamera> made(Recorder& out, const char* name, const Orbit& orbit)
{
    return ask_new<make_orbital_camera>(out, name, orbit.a_degrees, orbit.b_degrees, orbit.distance);
}

// On the axes, at the poles and beyond them; and one that shows which turn comes first.
void record_known(Variation& vary, Recorder& out)
{
    for (const Orbit& orbit : {Orbit{0, 0, 5},
                               {90, 0, 2},
                               {180, 0, 1},
                               {-90, 0, 0.5F},
                               {0, 30, 4},
                               {0, 90, 3},
                               {90, 90, 3},
                               {0, -90, 2},
                               {30, 150, 2},
                               {0, 180, 6},
                               {90, 30, 4},
                               {30, 60, 8}}) {
        if (const auto camera = made(out, "camera", varied(vary, orbit))) record(out, *camera);
    }
}

void record_orbital_viewports(Variation& vary, Recorder& out)
{
    const std::unique_ptr<OrbitalCamera> camera = made(out, "camera", varied(vary, Orbit{30, 20, 3}));
    if (camera) record_viewports(vary, out, *camera);
}

/// What one may do to an orbital camera.
void change(Recorder& out, OrbitalCamera& camera, std::uint32_t kind, const Orbit& orbit, const Size& size)
{
    if (kind == 0) ask<&OrbitalCamera::set_angles>(out, camera, orbit.a_degrees, orbit.b_degrees);
    if (kind == 1) ask<&OrbitalCamera::set_distance>(out, camera, orbit.distance);
    if (kind == 2) ask<&Camera::set_viewport>(out, camera, size.x, size.y);
}

// After each change, after two of them, and after none.
void record_changes(Variation& vary, Recorder& out)
{
    const std::unique_ptr<OrbitalCamera> camera = made(out, "camera", varied(vary, Orbit{0, 0, 5}));
    if (!camera) return;
    record(out, *camera);
    const std::uint32_t kinds[] = {0, 1, 2, 3, 1, 0, 2, 1, 0};
    for (std::uint32_t i = 0; i < 9; ++i) {
        const auto step = static_cast<float>(i);
        change(out, *camera, kinds[i], varied(vary, Orbit{15 * step, 10 * step - 30, 1 + 0.5F * step}),
               varied(vary, Size(100 + 50 * static_cast<int>(i), 200)));
        if (i != 4 && i != 6) record(out, *camera);
    }
}

Size random_size(Random& random)
{
    // Of three pictures one is larger than 16 bits can count.
    const std::uint32_t largest = random.below(3) == 0 ? 150'000 : 2000;
    const int width = 1 + static_cast<int>(random.below(largest));
    return {width, 1 + static_cast<int>(random.below(largest))};
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 20; ++i) {
        const std::unique_ptr<OrbitalCamera> camera = made(out, "camera", random_orbit(random));
        for (int step = 0; step < 6; ++step) {
            const std::uint32_t kind = random.below(3);
            const Orbit orbit = random_orbit(random);
            const Size size = random_size(random);
            if (!camera) continue;
            change(out, *camera, kind, orbit, size);
            record(out, *camera);
        }
    }
}

// Two orbital cameras and a base camera, changed in turns, and one of each that nobody changes; what one is told must
// not reach the others.
void record_several(Random& random, Recorder& out)
{
    const std::unique_ptr<OrbitalCamera> first = made(out, "first", random_orbit(random));
    const std::unique_ptr<Camera> base = ask_new<make_camera>(out, "base");
    const std::unique_ptr<OrbitalCamera> second = made(out, "second", random_orbit(random));
    const std::unique_ptr<Camera> unchanged = ask_new<make_camera>(out, "unchanged");
    const std::unique_ptr<OrbitalCamera> still = made(out, "still", random_orbit(random));
    for (int step = 0; step < 12; ++step) {
        const bool is_first = random.below(2) == 1;
        const std::uint32_t kind = random.below(3);
        const Orbit orbit = random_orbit(random);
        const Size size = random_size(random);
        const Size other = random_size(random);
        if (!first || !second || !base || !unchanged || !still) continue;
        change(out, is_first ? *first : *second, kind, orbit, size);
        if (step % 3 == 0) ask<&Camera::set_viewport>(out, *base, other.x, other.y);
        record(out, *first);
        record(out, *base);
        record(out, *second);
        if (step % 3 == 0) record(out, *unchanged);
        if (step % 3 == 1) record(out, *still);
    }
}

// One target for several activations, with or without a change in between: it is told each time.
void record_calls(Random& random, Recorder& out)
{
    out.columns("calls", "set_view, set_projection");
    for (int i = 0; i < 24; ++i) {
        const Orbit orbit = random_orbit(random);
        const Size size = random_size(random);
        RecordingTarget target;
        if (Questions* const questions = out.questions())
            questions->set_object(&target, "target", "RecordingTarget target;");
        const std::unique_ptr<OrbitalCamera> orbital = made(out, "orbital", orbit);
        const std::unique_ptr<Camera> base = ask_new<make_camera>(out, "base");
        if (!orbital || !base) continue;
        Camera& camera = i % 2 == 0 ? *base : *orbital;
        for (int k = 0; k < (i * 5) % 7; ++k) {
            if (k % 3 == 2) ask<&Camera::set_viewport>(out, camera, size.x, size.y);
            ask<&Camera::activate>(out, camera, target);
        }
        out.append("calls", target.calls());
    }
}

// What is refused and what is not, in random order; and after each attempt, what the camera still is.
void record_refused(Random& random, Recorder& out)
{
    const float wrong[] = {0, -1, no_number, infinity, -infinity};
    const Orbit start = random_orbit(random);
    const std::unique_ptr<OrbitalCamera> camera = made(out, "camera", start);
    for (int i = 0; i < 15; ++i) {
        Orbit good = random_orbit(random);
        // What is tiny is a distance too.
        if (i % 3 == 0) good.distance *= 1e-6F;
        const float distance = wrong[i % 5];
        const float angle = wrong[2 + i % 3];
        const bool first = random.below(2) == 1;
        if (!camera) continue;
        for (const bool is_bad : {first, !first}) {
            record_refusal(out, "distance refused", [&] {
                ask<&OrbitalCamera::set_distance>(out, *camera, is_bad ? distance : good.distance);
                return 0;
            });
            record(out, *camera);
            record_refusal(out, "angles refused", [&] {
                ask<&OrbitalCamera::set_angles>(out, *camera, is_bad && i % 2 == 0 ? angle : good.a_degrees,
                                                is_bad && i % 2 == 1 ? angle : good.b_degrees);
                return 0;
            });
            record(out, *camera);
            Orbit asked = good;
            if (is_bad && i % 3 == 0) asked.a_degrees = angle;
            if (is_bad && i % 3 == 1) asked.b_degrees = angle;
            if (is_bad && i % 3 == 2) asked.distance = distance;
            record_refusal(out, "factory refused", [&] { return made(out, "refused", asked); });
        }
    }
}

// Angles of up to ten million degrees, whole turns and all; every third one as large as floats are.
void record_many_turns(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const float size = std::pow(10.0F, i % 3 == 2 ? random.uniform(7, 38.5F) : random.uniform(3, 7));
        const float a = size * random.uniform(-1, 1);
        const std::unique_ptr<OrbitalCamera> camera = made(out, "camera", {a, size * random.uniform(-1, 1), 2});
        if (camera) out.append("view", activated(out, *camera).view());
    }
}

// A control room: five cameras, each with a window of its own shape; the last one is the base camera, before a model.
void draw_windows(Variation& vary, Recorder& out)
{
    constexpr glm::ivec2 size(480, 320);
    constexpr glm::vec3 sky(0.58F, 0.76F, 0.91F);
    const Stage stage(size.x, size.y, {0.05F, 0.05F, 0.07F});
    const Island island;
    const auto begin = [&](Camera& camera, const glm::ivec2& corner, const glm::ivec2& extent) {
        begin_panel(2 * corner, 2 * extent, sky);
        ask<&Camera::set_viewport>(out, camera, extent.x, extent.y);
        return activated(out, camera);
    };
    struct Window {
        Orbit orbit;
        glm::ivec2 corner;
        glm::ivec2 extent;
    };
    // The island's middle is a little above the origin.
    const glm::mat4 lowered = glm::translate(glm::mat4(1), {0, -0.9F, 0});
    const Window windows[] = {{{-28, 16, 7.4F}, {4, 132}, {344, 184}},
                              {{140, 34, 12.5F}, {352, 132}, {124, 184}},
                              {{0, 89, 9.5F}, {4, 4}, {124, 124}},
                              {{-62, 6, 4.4F}, {132, 4}, {216, 124}}};
    for (const Window& window : windows) {
        const std::unique_ptr<OrbitalCamera> camera = made(out, "camera", varied(vary, window.orbit));
        if (!camera) continue;
        const RecordingTarget target = begin(*camera, window.corner, window.extent);
        look_through(stage, target.view() * lowered, target.projection());
        island.draw_at_sea(stage, sky);
    }
    if (const std::unique_ptr<Camera> base = ask_new<make_camera>(out, "base")) {
        const RecordingTarget target = begin(*base, {352, 4}, {124, 124});
        const glm::mat4 model = glm::rotate(glm::mat4(1), vary.near(0.6F, 0.3F), glm::vec3(1, 0, 0)) *
                                glm::rotate(glm::mat4(1), 0.7F, glm::vec3(0, 1, 0)) *
                                glm::scale(glm::mat4(1), glm::vec3(0.155F)) * lowered;
        look_through(stage, target.view() * model, target.projection());
        island.draw(stage);
    }
    out.image("colours", stage.picture());
}

}

const Driver driver = {
    {"base", [](Case& c, Recorder& out) { record_base(c.vary, out); }},
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"viewports", [](Case& c, Recorder& out) { record_orbital_viewports(c.vary, out); }},
    {"changes", [](Case& c, Recorder& out) { record_changes(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"several", [](Case& c, Recorder& out) { record_several(c.random, out); }},
    {"calls", [](Case& c, Recorder& out) { record_calls(c.random, out); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(c.random, out); }},
    {"many turns", [](Case& c, Recorder& out) { record_many_turns(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { draw_windows(c.vary, out); }},
};

}
