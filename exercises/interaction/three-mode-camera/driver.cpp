#include <umbral/record/driver.hpp>

#include "steps.hpp"
#include "three_views.hpp"

namespace umbral {
namespace {

using namespace interaction;

constexpr double pi = std::numbers::pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

void record(Recorder& out, const ThreeModeCamera& camera)
{
    out.append("view", ask<&ThreeModeCamera::view>(out, camera));
    out.append("attention", glm::vec3(ask<&ThreeModeCamera::attention_point>(out, camera)));
}

/// What there is to see at the beginning and after each step. A factory that gives no camera leaves nothing to record.
void record(Recorder& out, const ThreeModeSettings& settings, const std::vector<ThreeModeStep>& steps)
{
    const std::unique_ptr<ThreeModeCamera> camera = ask_new<make_three_mode_camera>(out, "camera", settings);
    if (!camera) return;
    record(out, *camera);
    for (const ThreeModeStep& step : steps) {
        apply(out, *camera, step);
        record(out, *camera);
    }
}

void record_examine(Variation& vary, Recorder& out)
{
    record(out, varied(vary, {}), {move_xy(pi / 2, 0), move_xy(-pi, 0), move_xy(0, pi / 6), move_xy(pi / 4, -pi / 3)});
    record(out, varied(vary, {}),
           {move_z(1), move_z(-1), move_z(-1), move_z(5), move_z(-10), move_z(0.5), move_z(-0.25)});
    record(out, varied(vary, leaning(CameraMode::examine)),
           {move_xy(0.25, 0.125), move_z(2), move_xy(-7.5, 0.5), move_z(-3.5), move_xy(40, -1)});
}

void record_move(Variation& vary, Recorder& out)
{
    record(out, varied(vary, {.mode = CameraMode::move}),
           {move_xy(1, 0), move_xy(0, 2), move_z(-3), move_xy(-0.5, -0.25)});
    record(out, varied(vary, {.azimuth = pi / 2, .mode = CameraMode::move}), {move_xy(2, 0), move_z(1), move_z(-0.5)});
    record(out, varied(vary, leaning(CameraMode::move)),
           {move_xy(1.5, 0), move_xy(0, -2), move_z(4), move_z(-9), move_xy(-5, 3)});
}

void record_turn(Variation& vary, Recorder& out)
{
    record(out, varied(vary, {.mode = CameraMode::turn}),
           {move_xy(pi / 2, 0), move_xy(0, pi / 6), move_z(-1), move_xy(-pi, 0)});
    record(out, varied(vary, {.mode = CameraMode::turn}),
           {move_xy(0.5, 0.2), move_xy(-0.5, -0.2), move_z(0.25), move_z(-4)});
    record(out, varied(vary, leaning(CameraMode::turn)),
           {move_xy(0.25, 0.125), move_z(2), move_xy(-7.5, 0.5), move_z(-3.5), move_xy(40, -1)});
}

// From each mode; and a turn about the new attention point, which shows what is kept besides the axes.
void record_look_toward(Variation& vary, Recorder& out, Random& random)
{
    record(out, varied(vary, {}),
           {look_toward({1, 2, -1}), look_toward({5, 0, 3}), look_toward({0, 0, 9}), look_toward({-3, 1, 3})});
    for (int i = 0; i < 12; ++i) {
        ThreeModeSettings settings = random_three_mode(random);
        settings.mode = static_cast<CameraMode>(i % 3);
        settings.max_distance = 50;
        const glm::dvec3 first = random_point(random, 6);
        record(out, settings,
               {look_toward(first), move_xy(0.5, -0.25), move_z(1), look_toward(random_point(random, 6))});
    }
}

void record_modes(Variation& vary, Recorder& out)
{
    const auto record_mode = [&](const ThreeModeCamera& camera) {
        out.append("mode", static_cast<std::int32_t>(ask<&ThreeModeCamera::mode>(out, camera)));
    };
    const int later = vary.one_of(0, std::array{1, 2});
    for (const CameraMode first : {CameraMode::examine, CameraMode::move, CameraMode::turn}) {
        const ThreeModeSettings settings = leaning(static_cast<CameraMode>((static_cast<int>(first) + later) % 3));
        const std::unique_ptr<ThreeModeCamera> camera = ask_new<make_three_mode_camera>(out, "camera", settings);
        if (!camera) return;
        record_mode(*camera);
        for (const ThreeModeStep& step :
             {next_mode(), look_toward(observer_of(settings)), next_mode(), move_xy(0.1, 0.2), next_mode(), next_mode(),
              look_toward({7, 8, 9}), next_mode(), move_z(2), next_mode(), look_toward({not_a_number, 0, 0}),
              look_toward({1, 1, 1})}) {
            apply(out, *camera, step);
            record_mode(*camera);
        }
    }
}

// Up to a pole and beyond, and what is left and right there; and points straight above and below the observer.
void record_poles(Variation& vary, Recorder& out)
{
    const std::vector<ThreeModeStep> over{move_xy(0, 1.2), move_xy(0.4, 3),   move_xy(1, 0),  move_xy(0, 1e6),
                                          move_z(-0.5),    move_xy(0, -0.2),  move_xy(-2, 0), move_xy(0.3, -9),
                                          move_z(1),       move_xy(0.5, 0.1), move_xy(0.2, 1)};
    record(out, varied(vary, leaning(CameraMode::examine)), over);
    record(out, varied(vary, leaning(CameraMode::turn)), over);
    record(out, varied(vary, {.azimuth = 0.7, .elevation = pi / 2, .mode = CameraMode::move}),
           {move_xy(1, 2), move_z(3)});
    for (const CameraMode mode : {CameraMode::examine, CameraMode::move, CameraMode::turn}) {
        const ThreeModeSettings settings = varied(vary, leaning(mode));
        const glm::dvec3 observer = observer_of(settings);
        record(out, settings, {look_toward(observer + glm::dvec3(0, 5, 0)), move_xy(0.3, 0), move_xy(0, 0.2)});
        record(out, settings, {look_toward(observer - glm::dvec3(0, 3, 0)), move_xy(0, -0.5), move_z(1)});
        record(out, settings, {look_toward(observer + glm::dvec3(-0.02, 4, 0.03)), move_xy(0, 0.5)});
    }
}

void record_limits(Variation& vary, Recorder& out)
{
    const ThreeModeSettings settings =
        varied(vary, {.attention = {1, 2, 3}, .distance = 4, .min_distance = 0.5, .max_distance = 30});
    record(out, settings,
           {move_z(-30), move_z(-1), move_z(10'000), move_z(-2), move_z(-10'000), move_z(20), move_z(7), move_z(1e300),
            move_z(-5), move_z(-1e300), move_z(1)});
    record(out, varied(vary, {.distance = 500, .min_distance = 1e-3, .max_distance = 1e6}),
           {move_z(20), move_z(60), move_z(1000), move_z(-1), move_z(-400), move_z(-1e4), move_z(1)});
    // Small steps, and many at once that come to no limit.
    record(out, varied(vary, {.distance = 20, .min_distance = 0.5, .max_distance = 1e4, .zoom_step = 0.0025}),
           {move_z(-150), move_z(900), move_z(-300), move_z(400.5), move_z(-1200), move_z(250), move_z(1300),
            move_z(-1500), move_z(200), move_z(350)});
    const std::unique_ptr<ThreeModeCamera> camera = ask_new<make_three_mode_camera>(out, "camera", settings);
    if (!camera) return;
    for (int i = 1; i <= 400; ++i) {
        ask<&ThreeModeCamera::move_z>(out, *camera, i <= 200 ? -1.5 : 1);
        if (i % 20 == 0) record(out, *camera);
    }
}

// Points too near and too far to stand off from, and the observer's own place, which lies in no direction.
void record_near_and_far(Variation& vary, Recorder& out)
{
    for (const CameraMode mode : {CameraMode::examine, CameraMode::move, CameraMode::turn}) {
        ThreeModeSettings settings = varied(vary, leaning(mode));
        settings.min_distance = 0.5;
        settings.max_distance = 30;
        const glm::dvec3 observer = observer_of(settings);
        for (const glm::dvec3& away : ways_too_near_or_far(vary))
            record(out, settings, {look_toward(observer + away), move_xy(0.25, 0.5), move_z(1)});
    }
}

// Straight above or below, the observer's place does not depend on what rounding left of such an azimuth, and what he
// looks at next settles that too. Who takes turns off one at a time never comes there: it is asked first, to cost more.
void record_turned_for_ever(Variation& vary, Recorder& out)
{
    for (const CameraMode mode : {CameraMode::examine, CameraMode::turn})
        for (const double side : {1, -1}) {
            const std::unique_ptr<ThreeModeCamera> camera =
                ask_new<make_three_mode_camera>(out, "camera", varied(vary, leaning(mode)));
            if (!camera) return;
            ask<&ThreeModeCamera::move_xy>(out, *camera, side * 1e18, side * 10);
            for (const ThreeModeStep& step : {look_toward({side, 0.5, 3}), move_xy(0.25, -0.5)}) {
                apply(out, *camera, step);
                record(out, *camera);
            }
        }
}

void record_nonsense(Variation& vary, Recorder& out, Random& random)
{
    record_turned_for_ever(vary, out);
    for (const CameraMode mode : {CameraMode::examine, CameraMode::move, CameraMode::turn})
        record(out, varied(vary, leaning(mode)), steps_with_nonsense(random));
}

/// Two cameras in turns; what one is told must not reach the other.
void record_two(Recorder& out, Random& random)
{
    const std::unique_ptr<ThreeModeCamera> first =
        ask_new<make_three_mode_camera>(out, "first", random_three_mode(random));
    const ThreeModeSettings second_settings = random_three_mode(random);
    const std::vector<ThreeModeStep> steps = random_steps(random, 60);
    if (!first) return;
    ask<&ThreeModeCamera::move_xy>(out, *first, 0.3, 0.2);
    const std::unique_ptr<ThreeModeCamera> second = ask_new<make_three_mode_camera>(out, "second", second_settings);
    if (!second) return;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        // Both of them zoom before all else.
        apply(out, random.below(2) == 0 ? *first : *second, i < 6 ? move_z(random_length(random, 3)) : steps[i]);
        record(out, *first);
        record(out, *second);
    }
}

void record_random(Recorder& out, Random& random)
{
    for (int i = 0; i < 8; ++i) {
        ThreeModeSettings settings = random_three_mode(random);
        settings.mode = static_cast<CameraMode>(random.below(3));
        // Beside a thing that is smaller than 1.
        if (i % 4 == 3)
            for (double* const length : {&settings.distance, &settings.min_distance, &settings.max_distance})
                *length *= 0.15;
        record(out, settings, random_steps(random, 80));
    }
}

// Points so nearly above or below the observer that only their digits say where. Where the azimuth stays, the point and
// the one on the camera's axis at its distance are the same within the tolerance: either may be the attention point.
void record_nearly_above(Recorder& out, Random& random)
{
    const std::vector<std::pair<double, std::vector<double>>> places = {{0.25, {1e-3, 1e-5, 3e-6, 2e-6, 5e-8}},
                                                                        {4, {1e-3, 1e-4, 1e-5, 2e-6}},
                                                                        {64, {1e-3, 1e-5, 2e-6, 3e-8, 2e-8}},
                                                                        {1e8, {2e-6, 3e-8, 2e-8}}};
    for (const auto& [away, sines] : places)
        for (const double sine : sines) {
            const ThreeModeSettings settings = random_three_mode(random, 0.5);
            const double angle = random_length(random, pi);
            const glm::dvec3 aside(sine * std::sin(angle), random.below(2) == 0 ? 1 : -1, sine * std::cos(angle));
            record(out, settings, {look_toward(observer_of(settings) + away * aside)});
        }
}

// A million units from the world's origin, with strides as long; and points too near and too far.
void record_far(Recorder& out, Random& random)
{
    for (int i = 0; i < 24; ++i) {
        ThreeModeSettings settings = random_three_mode(random);
        settings.attention = glm::dvec3(std::pow(10.0F, random.uniform(4, 6)) * random.unit_vector());
        settings.mode = static_cast<CameraMode>(random.below(3));
        record(out, settings,
               i % 2 == 0 ? strides(random, settings.attention) : random_steps(random, 10, settings.attention));
    }
    for (int i = 0; i < 10; ++i) {
        const ThreeModeSettings settings = random_three_mode(random, 0.5);
        const double share = random.uniform_double();
        const double away =
            i % 2 == 0 ? settings.min_distance * (0.1 + 0.9 * share) : settings.max_distance * (1 + share);
        record(out, settings,
               {look_toward(observer_of(settings) + away * glm::dvec3(random.unit_vector())), move_z(1)});
    }
}

// A hundred thousand steps, mostly to the same side, in modes that take turns, while elevation and distance go to and
// fro without coming to their limits, which would take what was lost on the way with them.
void record_long_session(Recorder& out, Random& random)
{
    const ThreeModeSettings settings{.attention = {0.5, -0.25, 1}, .azimuth = 0.3};
    const std::unique_ptr<ThreeModeCamera> camera = make_three_mode_camera(settings);
    if (!camera) return;
    double elevation = 0;
    double back = 0;
    for (int i = 1; i <= 100'000; ++i) {
        const double right = pi * random.uniform_double();
        const double up = random_length(random, 1.5) - elevation;
        const double steps = random_length(random, 3) - back;
        const int mode = (i - 1) / 100 % 3;
        camera->move_xy(mode == 1 ? 0.1 * (right - pi / 2) : right, up);
        if (mode != 1) elevation += up;
        camera->move_z(steps);
        back += steps;
        if (i % 100 == 0) camera->next_mode();
        if (i % 500 != 0) continue;
        ask_in_words(out, [&] {
            return "const auto camera = make_three_mode_camera(" + literal::of_value(settings, true, literal::Style{}) +
                   ");\n// " + std::to_string(i) +
                   " times: camera->move_xy(right, up), right from 0 to pi, elevation within 1.5; move_z(steps), all "
                   "of\n// them within 3 of the first place; after each hundred of them "
                   "camera->next_mode()\ncamera->view()";
        });
        out.append("view", camera->view());
    }
}

}

const Driver driver = {
    {"beginning",
     [](Case& c, Recorder& out) {
         for (const ThreeModeSettings& settings : beginnings()) record(out, varied(c.vary, settings), {});
     }},
    {"examine", [](Case& c, Recorder& out) { record_examine(c.vary, out); }},
    {"move", [](Case& c, Recorder& out) { record_move(c.vary, out); }},
    {"turn", [](Case& c, Recorder& out) { record_turn(c.vary, out); }},
    {"look toward", [](Case& c, Recorder& out) { record_look_toward(c.vary, out, c.random); }},
    {"modes", [](Case& c, Recorder& out) { record_modes(c.vary, out); }},
    {"poles", [](Case& c, Recorder& out) { record_poles(c.vary, out); }},
    {"limits", [](Case& c, Recorder& out) { record_limits(c.vary, out); }},
    {"near and far points", [](Case& c, Recorder& out) { record_near_and_far(c.vary, out); }},
    {"nonsense", [](Case& c, Recorder& out) { record_nonsense(c.vary, out, c.random); }},
    {"two cameras", [](Case& c, Recorder& out) { record_two(out, c.random); }},
    {"random", [](Case& c, Recorder& out) { record_random(out, c.random); }},
    {"far", [](Case& c, Recorder& out) { record_far(out, c.random); }},
    {"nearly above", [](Case& c, Recorder& out) { record_nearly_above(out, c.random); }},
    {"a hundred thousand steps", [](Case& c, Recorder& out) { record_long_session(out, c.random); }},
    {"picture", [](Case& c, Recorder& out) { draw_modes(c.vary, out); }},
};

}
