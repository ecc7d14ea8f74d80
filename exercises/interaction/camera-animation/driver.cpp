#include <array>
#include <kit/numbers_changed.hpp>
#include <kit/refusal.hpp>
#include <limits>
#include <tuple>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../temple.hpp"
#include "flights.hpp"

namespace umbral {
namespace {

using namespace interaction;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

void record_pose(Recorder& out, const CameraFlight& flight, float seconds)
{
    const auto [eye, target] = ask<flight_pose>(out, flight, seconds);
    out.append("observer", eye);
    out.append("attention point", target);
}

void record_view(Recorder& out, const CameraFlight& flight, float seconds)
{
    out.append("view", ask<flight_view>(out, flight, seconds));
}

void record(Recorder& out, const CameraFlight& flight, float seconds)
{
    record_pose(out, flight, seconds);
    record_view(out, flight, seconds);
}

// The course's flight, and others whose poses can be worked out by hand; times in no order. Two flights of different
// durations are asked at the same times, one right after the other.
void record_worked(Variation& vary, Recorder& out)
{
    const CameraFlight quarter = varied(vary, {{0, 1, 5}, {5, 1, 0}, {0, 0, 0}, {0, 1, 0}, 4});
    const CameraFlight rising = varied(vary, {{2, 0, 2}, {2, 10, 2}, {-2, 1, 5}, {-2, 1, -3}, 10});
    for (const float seconds : {2.0F, 0.0F, 4.0F, 1.0F, 3.0F}) {
        record(out, quarter, seconds);
        record(out, rising, seconds);
    }
    const CameraFlight short_one = varied(vary, {{-3, 2, 0}, {1, 4, 8}, {1, 0, 0}, {1, 0, 0}, 0.5F});
    for (const float seconds : {0.125F, 0.375F, 0.25F}) record(out, short_one, seconds);
    const CameraFlight standing = varied(vary, {{1, 2, 3}, {1, 2, 3}, {4, 2, 3}, {1, 2, 7}, 8});
    for (const float seconds : {6.0F, 1.0F}) record(out, standing, seconds);
    // The same flight at once, and so slowly that no one sees the end of it.
    for (const int doublings : {-148, -22, 20, 120}) {
        CameraFlight other = quarter;
        other.duration = std::ldexp(4.0F, doublings);
        record(out, other, std::ldexp(doublings % 3 == 0 ? 1.0F : 3.0F, doublings));
    }
}

void record_before_and_after(Recorder& out, Random& random)
{
    for (int i = 0; i < 20; ++i) {
        CameraFlight flight = random_flight(random);
        if (i % 4 == 0) flight.duration = i % 8 == 0 ? 0.0F : -0.0F;
        // No time is too short to count, and none too long.
        if (i % 4 == 1) flight.duration = any_duration(random);
        if (i % 5 == 0) flight.eye_from = glm::vec3(0);
        const float beside = random.uniform(0.01F, 2) * (flight.duration > 0 ? flight.duration : 0.5F);
        for (const float seconds : {-beside, 0.0F, flight.duration, flight.duration + beside, -0.0F})
            record(out, flight, seconds);
        for (const float seconds : {infinity, -infinity}) record(out, flight, seconds);
    }
    // An end is exact, however far away the other one is.
    for (int i = 0; i < 12; ++i) {
        const auto near = [&] { return std::pow(10.0F, random.uniform(-6, -3)) * random.in_cube(); };
        const auto far = [&] { return std::pow(10.0F, random.uniform(3, 6)) * random.in_cube(); };
        CameraFlight flight{near(), far(), far(), near(), any_duration(random)};
        for (const float seconds : {-flight.duration, flight.duration, 2 * flight.duration})
            record_pose(out, flight, seconds);
    }
}

// Two flights at a time: of one clock, so that each is asked at the other's times, but not of one duration.
void record_random(Recorder& out, Random& random)
{
    for (int i = 0; i < 110; ++i) {
        CameraFlight flight = random_flight(random);
        CameraFlight other = random_flight(random);
        if (i % 3 == 0) flight.duration = any_duration(random);
        other.duration = flight.duration * random.uniform(0.4F, 1.25F);
        for (const float u : {random.uniform(-0.2F, 1.2F), random.uniform()}) {
            record(out, flight, flight.duration * u);
            record(out, other, flight.duration * u);
        }
        if (i % 10 != 0) continue;
        // One number after the other is another.
        const std::tuple asked(flight, flight.duration * random.uniform());
        const auto is_allowed = [](const auto& question) { return std::get<0>(question).duration > 0; };
        for (const auto& [changed, seconds] : numbers_changed(random, asked, 14, is_allowed))
            record(out, changed, seconds);
    }
}

// Between ends of very different sizes, up to 1e6: what is small must not be lost beside what is large.
void record_far_poses(Recorder& out, Random& random)
{
    const auto place = [&] { return std::pow(10.0F, random.uniform(-3, 6)) * random.in_cube(); };
    for (int i = 0; i < 200; ++i) {
        CameraFlight flight{place(), place(), place(), place(), std::pow(10.0F, random.uniform(-3, 5))};
        if (i % 3 == 0) flight.eye_to = flight.eye_from;
        record_pose(out, flight, flight.duration * (i % 4 == 0 ? 1 - 0x1p-20F : random.uniform()));
    }
}

// Observer and attention point meet at half of the time, as far from the origin as a million, and are asked for a
// little before or after: there they are nearer to each other than floats of this size, but all numbers are exact in
// double.
void record_close_by(Recorder& out, Random& random)
{
    for (int i = 0; i < 24; ++i) {
        const glm::vec3 meeting = glm::round(std::exp2(random.uniform(14, 19.9F)) * random.unit_vector());
        const auto step = [&](float reach) { return glm::round(16 * reach * random.in_cube()) / 16.0F; };
        const glm::vec3 eye_step = step(4) + glm::vec3(0, 0, i % 2 == 0 ? 6 : -6);
        const glm::vec3 target_step = step(1);
        const CameraFlight flight{meeting - eye_step, meeting + eye_step, meeting - target_step, meeting + target_step,
                                  16};
        const float beside = std::exp2(std::floor(random.uniform(-12, -8)));
        record_view(out, flight, 8 + (random.below(2) == 0 ? beside : -beside));
    }
}

// A million units from the origin, looking at what is near; from far to far, past what stands beside the way; and near
// the origin, all but straight above, or all but at what is looked at.
void record_far_views(Recorder& out, Random& random)
{
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 direction = glm::normalize(random.unit_vector() * glm::vec3(1, 0.3F, 1));
        CameraFlight passing = random_flight(random, 3);
        passing.eye_to = passing.eye_from + 2e5F * direction;
        passing.eye_from -= 2e5F * direction;
        passing.target_to = passing.target_from;
        record_view(out, passing, passing.duration * random.uniform(0.49999F, 0.50001F));
    }
    for (int i = 0; i < 160; ++i) {
        CameraFlight flight = random_flight(random);
        const glm::vec3 place = glm::round(std::pow(10.0F, random.uniform(4.5F, 6)) * random.unit_vector());
        for (glm::vec3* const end : {&flight.eye_from, &flight.eye_to, &flight.target_from, &flight.target_to})
            *end += place;
        record_view(out, flight, flight.duration * random.uniform());
    }
    for (int i = 0; i < 24; ++i) {
        const glm::vec3 close = std::pow(10.0F, random.uniform(-4.9F, -3)) * random.unit_vector();
        CameraFlight flight = random_flight(random);
        flight.target_to = glm::vec3(0);
        flight.eye_to = i % 2 == 0 ? close : glm::vec3(close.x, i % 4 == 1 ? 2 : -1, close.z);
        record_view(out, flight, flight.duration);
    }
    record_close_by(out, random);
}

/// A multiple of 1/8, up to `reach`: halves and quarters of sums of these are exact.
glm::vec3 on_grid(Random& random, float reach) { return glm::round(8 * reach * random.in_cube()) / 8.0F; }

// So nearly over or under what is looked at, from a thousandth to a thousand away, that the sine of the angle is below
// 1e-6, by far or by a little, or above it. Which axis is most perpendicular to the view follows from what is left.
void record_nearly_above(Recorder& out, Random& random)
{
    for (int i = 0; i < 40; ++i) {
        const float height = std::exp2(std::floor(random.uniform(-10, 10)));
        const float sines[] = {std::pow(10.0F, random.uniform(-9, -6.5F)), random.uniform(0.5e-6F, 0.98e-6F),
                               random.uniform(1.02e-6F, 1.9e-6F), random.uniform(2e-6F, 2e-5F)};
        const float less = random.uniform(-0.6F, 0.6F);
        const glm::vec2 aside = sines[i % 4] * glm::normalize(glm::vec2(less, random.below(2) == 0 ? 1 : -1));
        const bool is_x_less = i / 4 % 2 == 0;
        const glm::vec3 up(is_x_less ? aside.x : aside.y, random.below(2) == 0 ? 1 : -1, is_x_less ? aside.y : aside.x);
        const CameraFlight flight{height * up, 2 * height * up, {0, 0, 0}, {0, 0, 0}, 4};
        record_view(out, flight, i % 3 == 0 ? 4.0F : 0.0F);
    }
}

// Over, or under, what is looked at: for a moment, or all the time.
void record_straight_above(Recorder& out, Random& random)
{
    for (int i = 0; i < 16; ++i) {
        const glm::vec3 middle = on_grid(random, 4);
        const glm::vec3 high(0, i % 2 == 0 ? 5 : -3, 0);
        const glm::vec3 aside = on_grid(random, 3) + glm::vec3(4, 0, 0);
        const glm::vec3 sideways(aside.x, 0, aside.z);
        const CameraFlight passing{middle + high - sideways, middle + high + sideways, middle, middle, 8};
        const CameraFlight rising{middle + high, middle + 3.0F * high, middle - aside, middle - aside, 4};
        // Beside the vertical by a sixtieth and by two thousandths of the way, without rounding.
        for (const float seconds : {4.0F, 3.0F, 5.0F, 4.0625F, 3.9921875F}) record_view(out, passing, seconds);
        CameraFlight lifted = rising;
        lifted.target_from = middle;
        lifted.target_to = middle + 0.5F * high;
        for (const float seconds : {0.0F, 1.0F, 3.0F}) record_view(out, lifted, seconds);
        record_view(out, rising, 2);
    }
    record_nearly_above(out, random);
}

// The observer flies through the attention point, at a half or a quarter of the time, or past it by less than counts,
// or by a little more.
void record_through(Recorder& out, Random& random)
{
    for (std::size_t i = 0; i < 24; ++i) {
        const bool is_past = i % 6 > 1;
        const glm::vec3 meeting = is_past ? glm::vec3(0) : on_grid(random, 4);
        const glm::vec3 eye_step = on_grid(random, 3) + glm::vec3(0, 0, 5);
        const glm::vec3 target_step = on_grid(random, 1);
        const float before = i % 2 == 0 ? 2.0F : 1.0F;
        CameraFlight flight{meeting - before * eye_step, meeting + (4 - before) * eye_step,
                            meeting - before * target_step, meeting + (4 - before) * target_step, 4};
        constexpr std::array limits{0.0F, 0.0F, 0.3e-6F, 0.9e-6F, 1.03e-6F, 1.15e-6F};
        constexpr std::array ends{0.0F, 0.0F, 0.9e-6F, 0.97e-6F, 1.15e-6F, 4e-6F};
        const float past = random.uniform(limits[i % 6], ends[i % 6]);
        if (is_past) flight.target_from = flight.target_to = past * random.unit_vector();
        for (const float seconds : {before - 0.5F, before, before + 0.5F}) record_view(out, flight, seconds);
    }
}

// In random order one that is refused and one that is not. Some stand still, and are refused all the same; of some the
// duration is 0, of others the largest float, or the smallest.
void record_refused(Recorder& out, Random& random)
{
    constexpr float largest = std::numeric_limits<float>::max();
    constexpr float smallest = std::numeric_limits<float>::denorm_min();
    constexpr std::array wrong{-1.0F, no_number, infinity, -infinity, -1e-30F, -smallest};
    constexpr std::array right{0.0F, -0.0F, largest, smallest, 1e31F};
    for (std::size_t i = 0; i < 48; ++i) {
        CameraFlight good = random_flight(random);
        const float seconds = i % 3 == 0 ? (i % 2 == 0 ? infinity : -infinity) : good.duration * random.uniform();
        if (i % 3 == 1) good.eye_to = good.eye_from;
        if (i % 3 == 1) good.target_to = good.target_from;
        const bool wrong_time = i % 4 == 3;
        if (i % 4 == 1 || i % 8 == 3) good.duration = right[i / 4 % right.size()];
        if (i % 16 == 3) good.duration = 0;
        CameraFlight bad = good;
        if (!wrong_time) bad.duration = wrong[i / 2 % wrong.size()];
        const bool bad_first = random.below(2) == 0;
        for (const bool is_bad : {bad_first, !bad_first}) {
            const CameraFlight& flight = is_bad ? bad : good;
            const float time = is_bad && wrong_time ? no_number : seconds;
            record_refusal(out, "pose refused", [&] { return ask<flight_pose>(out, flight, time); });
            record_refusal(out, "view refused", [&] { return ask<flight_view>(out, flight, time); });
        }
    }
}

// Six frames of a flight into the temple.
void draw_flight(Variation& vary, Recorder& out)
{
    const Stage stage(480, 320, {0.05F, 0.05F, 0.07F});
    const Temple temple;
    const CameraFlight flight =
        varied(vary, {{8.5F, 4.6F, 8}, {-1.8F, 1.9F, 1.3F}, {0, 1.5F, 0}, {0.3F, 1.85F, -0.6F}, 6});
    for (int frame = 0; frame < 6; ++frame) {
        const Panel panel{{4 + 238 * (frame % 2), 216 - 106 * (frame / 2)}, {234, 100}};
        const float seconds = 1.2F * static_cast<float>(frame);
        draw_temple(stage, temple, panel, ask<flight_view>(out, flight, seconds), 40);
    }
    out.image("colours", stage.picture());
}

}

const Driver driver = {
    {"worked", [](Case& c, Recorder& out) { record_worked(c.vary, out); }},
    {"before and after", [](Case& c, Recorder& out) { record_before_and_after(out, c.random); }},
    {"random", [](Case& c, Recorder& out) { record_random(out, c.random); }},
    {"far poses", [](Case& c, Recorder& out) { record_far_poses(out, c.random); }},
    {"far views", [](Case& c, Recorder& out) { record_far_views(out, c.random); }},
    {"straight above", [](Case& c, Recorder& out) { record_straight_above(out, c.random); }},
    {"through the target", [](Case& c, Recorder& out) { record_through(out, c.random); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(out, c.random); }},
    {"picture", [](Case& c, Recorder& out) { draw_flight(c.vary, out); }},
};

}
