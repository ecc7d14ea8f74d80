#include <kit/scene.hpp>
#include <numbers>
#include <umbral/interaction/orbit_camera.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"

namespace umbral {
namespace {

using namespace interaction;

constexpr double pi = std::numbers::pi;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The view at the beginning and after each event. A factory that gives no camera leaves nothing to record.
void record(Recorder& out, const OrbitCameraSettings& settings, const std::vector<CameraEvent>& events)
{
    const std::unique_ptr<OrbitCamera> camera = ask_new<make_orbit_camera>(out, "camera", settings);
    if (!camera) return;
    out.append("view", ask<&OrbitCamera::view>(out, *camera));
    for (const CameraEvent& event : events) {
        apply(out, *camera, event);
        out.append("view", ask<&OrbitCamera::view>(out, *camera));
    }
}

// Cameras as they are made, with matrices that a student can work out by hand.
std::vector<OrbitCameraSettings> beginnings()
{
    return {{},
            {.distance = 3, .yaw = pi / 2},
            {.distance = 3, .yaw = -pi / 2},
            {.distance = 2, .yaw = pi},
            {.distance = 4, .pitch = pi / 6},
            {.target = {1, 2, 3}, .distance = 7},
            {.target = {-4, 0.5, 2}, .distance = 10, .yaw = pi / 4, .pitch = -pi / 4},
            {.target = {0, 1, 0}, .distance = 2.5, .yaw = 2.5, .pitch = 1.2}};
}

// A viewport of 400 pixels: 200 of them are a right angle.
const OrbitCameraSettings small = {.distance = 4, .viewport_height = 400};

// The pitch at its limit, and at once back from it. Huge drags are no nonsense, whatever they are multiplied by.
std::vector<CameraEvent> up_and_down(Random& random)
{
    const auto aside = [&] { return 20 + std::abs(random_pixels(random, 60)); };
    return {drag(0, -150), drag(0, -150), drag(0, -5000),   drag(0, 100),         drag(30, 0),
            drag(0, 250),  drag(0, 1e9),  drag(0, -40),     drag(-500, -2),       drag(3, 1e300),
            drag(0, -200), drag(0, 70),   drag(-4, -1e300), drag(aside(), 1e307), drag(-aside(), -1e307)};
}

// Steps, fractions of steps, and both limits (0.1 and 1000).
std::vector<CameraEvent> wheel()
{
    return {scroll(1),  scroll(1),     scroll(-1),   scroll(-3),  scroll(0.5), scroll(-0.0625), scroll(0),
            scroll(20), scroll(200),   scroll(0.25), scroll(-1),  scroll(-5),  scroll(-500),    scroll(-1e9),
            scroll(1),  scroll(1e300), drag(40, 10), scroll(-10), scroll(3),   reset(),         scroll(2)};
}

// The same drags in windows of other sizes; one that is minimised keeps the last good size.
std::vector<CameraEvent> windows()
{
    return {drag(100, 50),     resize(640, 800), drag(100, 50),    resize(1600, 200), drag(20, 10), resize(0, 0),
            drag(20, 10),      resize(300, 0),   drag(20, 10),     resize(0, 77),     drag(20, 10), resize(-5, -5),
            drag(5, -5),       resize(333, 555), drag(-60, -12.5), reset(),           drag(30, 30), resize(1, 250),
            drag(10, 5),       resize(-5, 300),  drag(3, -8),      resize(300, -5),   drag(5, 2),   resize(640, 1),
            drag(0.25, 0.125), resize(640, 480), drag(30, -20)};
}

std::vector<CameraEvent> nonsense()
{
    return {drag(50, 20),      drag(0, 0),         drag(not_a_number, 10), drag(10, not_a_number),
            drag(infinity, 0), drag(0, -infinity), scroll(not_a_number),   scroll(infinity),
            scroll(-infinity), scroll(0),          drag(-0.0, 0.0),        drag(10, 20)};
}

/// Two cameras that are moved in turns; what one is told must not reach the other.
void record_two(Recorder& out, Random& random)
{
    const std::unique_ptr<OrbitCamera> first = ask_new<make_orbit_camera>(out, "first", random_settings(random));
    const std::vector<CameraEvent> events = random_session(random, 80);
    const OrbitCameraSettings second_settings = random_settings(random);
    if (!first) return;
    ask<&OrbitCamera::drag>(out, *first, 30, 20);
    const std::unique_ptr<OrbitCamera> second = ask_new<make_orbit_camera>(out, "second", second_settings);
    if (!second) return;
    for (const CameraEvent& event : events) {
        OrbitCamera& moved = random.below(2) == 0 ? *first : *second;
        apply(out, moved, event);
        out.append("view", ask<&OrbitCamera::view>(out, *first));
        out.append("view", ask<&OrbitCamera::view>(out, *second));
    }
}

// A million turns in the same direction, 200,000 drags of 0 to 10 turns, while pitch and distance go to and fro without
// coming to their limits, which would take what was lost on the way with them.
void record_long_session(Recorder& out, Random& random)
{
    const OrbitCameraSettings settings{.target = {0.5, -0.25, 1}, .distance = 3, .yaw = 0.3};
    const std::unique_ptr<OrbitCamera> camera = make_orbit_camera(settings);
    if (!camera) return;
    double height = 0;  // where the pointer is, in pixels, and the wheel, in steps
    double wheel = 0;
    for (int i = 1; i <= 200'000; ++i) {
        const double right = 4800 + random_pixels(random, 4800);
        const double up = random_pixels(random, 120) - height;
        const double steps = random_pixels(random, 8) - wheel;
        camera->drag(right, up);
        camera->scroll(steps);
        height += up;
        wheel += steps;
        if (i % 1000 != 0) continue;
        ask_in_words(out, [&] {
            return "const auto camera = make_orbit_camera(" + literal::of_value(settings, true, literal::Style{}) +
                   ");\n// " + std::to_string(i) +
                   " times: camera->drag(right, up), right from 0 to 9600, all of them up and down\n"
                   "// within 120 pixels of the first place, and then camera->scroll(steps), within 8 steps of "
                   "it\ncamera->view()";
        });
        out.append("view", camera->view());
    }
}

// A drag of very many whole turns, which a number of turns in an int does not hold, and small ones after it. Half turns
// and radians are exact, in double, for the first: whoever takes off whole turns is back where the camera began.
void record_many_turns_at_once(Recorder& out, Random& random)
{
    for (int i = 0; i < 16; ++i) {
        const int exponent = 8 + static_cast<int>(random.below(3));
        const double half_turns = std::ldexp(i % 2 == 0 ? 1.0 : -1.0, 36 + static_cast<int>(random.below(5)));
        const OrbitCameraSettings settings{.target = glm::dvec3(random.in_cube()),
                                           .distance = 2 + random.uniform_double(),
                                           .pitch = 0.5 * random.uniform_double(),
                                           .viewport_height = 1 << exponent};
        std::vector<CameraEvent> events = {drag(std::ldexp(half_turns, exponent), 0)};
        for (int k = 0; k < 3; ++k) events.push_back(drag(random_pixels(random, 50), random_pixels(random, 20)));
        record(out, settings, events);
    }
}

// The wheel goes far and all the way in one direction, in between both limits, at a target near the origin: nothing in
// the last column hides what the steps are worth.
void record_long_ways(Recorder& out, Random& random)
{
    for (int i = 0; i < 30; ++i) {
        const double nearer = i % 2 == 0 ? 1 : -1;
        const double steps = 40 + std::floor(160 * random.uniform_double()) / 8;
        const double rest = std::floor(80 * random.uniform_double()) / 8;
        const OrbitCameraSettings settings{.target = 0.01F * random.in_cube(),
                                           .distance = i % 2 == 0 ? 900 : 0.12,
                                           .yaw = 6 * random.uniform_double() - 3,
                                           .pitch = 2 * random.uniform_double() - 1};
        record(out, settings, {scroll(nearer * steps), scroll(nearer * rest)});
    }
}

// Targets far from the world's origin: where the camera stands cannot be told in float any more, what it sees can.
void record_far_targets(Recorder& out, Random& random)
{
    for (int i = 0; i < 40; ++i) {
        OrbitCameraSettings settings = random_settings(random);
        settings.yaw *= 50;
        settings.target = glm::dvec3(std::pow(10.0F, random.uniform(4, 6)) * random.unit_vector());
        const std::vector<CameraEvent> events = random_session(random, 6);
        record(out, settings, events);
    }
}

Image picture_after(Variation& vary, Recorder& out, const std::vector<CameraEvent>& events)
{
    const OrbitCameraSettings settings = varied(vary, {.target = {0, 0.35, 0}, .distance = 8, .viewport_height = 256});
    const std::unique_ptr<OrbitCamera> camera = ask_new<make_orbit_camera>(out, "camera", settings);
    if (!camera) return Image(256, 256);
    for (const CameraEvent& event : events) apply(out, *camera, event);
    return draw_scene(ask<&OrbitCamera::view>(out, *camera));
}

}

const Driver driver = {
    {"beginning",
     [](Case& c, Recorder& out) {
         for (const OrbitCameraSettings& settings : beginnings()) record(out, varied(c.vary, settings), {});
     }},
    {"drag",
     [](Case& c, Recorder& out) {
         record(out, varied(c.vary, small),
                {drag(200, 0), drag(-400, 0), drag(0, -100), drag(50, 0), drag(0, 100), drag(25.5, 12.25),
                 drag(1600, 0), drag(-0.5, -0.125), drag(-1e6, 60)});
     }},
    {"limits of pitch", [](Case& c, Recorder& out) { record(out, varied(c.vary, small), up_and_down(c.random)); }},
    {"wheel", [](Case& c, Recorder& out) { record(out, varied(c.vary, {.distance = 4, .pitch = 0.3}), wheel()); }},
    {"window", [](Case& c, Recorder& out) { record(out, varied(c.vary, small), windows()); }},
    {"nonsense", [](Case& c, Recorder& out) { record(out, varied(c.vary, small), nonsense()); }},
    {"two cameras", [](Case& c, Recorder& out) { record_two(out, c.random); }},
    {"random",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 8; ++i) {
             const OrbitCameraSettings settings = random_settings(c.random);
             record(out, settings, random_session(c.random, 100));
         }
     }},
    {"far targets",
     [](Case& c, Recorder& out) {
         record_far_targets(out, c.random);
         record_long_ways(out, c.random);
     }},
    {"a million turns",
     [](Case& c, Recorder& out) {
         record_long_session(out, c.random);
         record_many_turns_at_once(out, c.random);
     }},
    {"picture",
     [](Case& c, Recorder& out) {
         out.image("from the side", picture_after(c.vary, out, {drag(-60, -30), drag(10, -4), scroll(2.5)}));
         out.image("from above",
                   picture_after(c.vary, out, {drag(80, -60), scroll(-1), drag(10, -500), scroll(2.5), drag(0, 12)}));
     }},
};

}
