#include <kit/varied.hpp>
#include <string>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "angles.hpp"
#include "keys.hpp"
#include "moons.hpp"

namespace umbral {
namespace {

using namespace lighting;

void record_in_frames(Recorder& out, const LightAngles& angles, const glm::mat4& view)
{
    for (const LightFrame frame : {LightFrame::world, LightFrame::camera}) {
        out.append("in camera", ask<direction_in_camera>(out, angles, frame, view));
        out.append("in world", ask<direction_in_world>(out, angles, frame, view));
    }
}

void record_key(Recorder& out, LightControl& control, char key)
{
    out.append("turned", ask<&LightControl::press>(out, control, key));
    out.columns("angles", "longitude, latitude");
    out.append("angles", pair_of(ask<&LightControl::angles>(out, control)));
}

void record_keys(Recorder& out, const LightAngles& initial, float step, const std::string& keys)
{
    const std::unique_ptr<LightControl> control = ask_new<make_light_control>(out, "control", initial, step);
    if (!control) return;
    out.columns("angles", "longitude, latitude");
    out.append("angles", pair_of(ask<&LightControl::angles>(out, *control)));
    for (const char key : keys) record_key(out, *control, key);
}

// Up to a quarter turn of longitude more or less, and not beyond 450 degrees.
LightAngles turned(Variation& vary, LightAngles angles)
{
    angles.longitude_degrees = vary.near(angles.longitude_degrees, 90.0F);
    if (angles.longitude_degrees > 450) angles.longitude_degrees -= 180;
    return angles;
}

// Another longitude, and another size; no zero that has a sign comes of it.
glm::vec3 turned(Variation& vary, const glm::vec3& direction)
{
    Random* const random = vary.random();
    if (random == nullptr) return direction;
    const double angle = random->uniform(0, 6.28F);
    const double size = random->uniform(0.5F, 3);
    const glm::dvec3 d(direction);
    return {0 + size * (std::cos(angle) * d.x + std::sin(angle) * d.z), size * d.y,
            0 + size * (std::cos(angle) * d.z - std::sin(angle) * d.x)};
}

// Varied, longitudes are others, and directions come in another order.
void by_hand(Variation& vary, Recorder& out)
{
    for (const LightAngles& angles : {LightAngles{0, 0}, {90, 0}, {180, 0}, {270, 0}, {0, 90}, {0, -90}, {77, 90}})
        record_direction(out, turned(vary, angles));
    for (const LightAngles& angles : {LightAngles{30, 0}, {0, 30}, {90, 60}, {-90, -30}, {45, 45}, {360, 30}, {450, 0}})
        record_direction(out, turned(vary, angles));
    // Beyond the poles it is the other side.
    for (const LightAngles& angles : {LightAngles{0, 120}, {90, -135}, {-60, 180}})
        record_direction(out, turned(vary, angles));
    std::vector<glm::vec3> directions = {{0, 0, 1},  {1, 0, 0},  {0, 0, -1}, {-1, 0, 0}, {0, 1, 0},   {0, -1, 0},
                                         {1, 0, 1},  {-1, 0, 1}, {0, 2, 2},  {0, -3, 3}, {-2, 0, -2}, {0, 0, 0},
                                         {0, 0, 25}, {0, 7, -7}, {-4, 0, 0}, {0, -5, 0}};
    for (glm::vec3& direction : directions) direction = turned(vary, direction);
    const glm::vec3 hard[] = {{-0.0F, 3, -0.0F},
                              {-0.0F, 0, 2},
                              {0, -0.0F, -2},
                              {-1e-30F, 0, 1},
                              // Next to the longitude 0, on either side.
                              {0.01F, 0, 1},
                              {-0.01F, 0.01F, 1},
                              {-1e-6F, 0, 1},
                              // Straight up and down, by less than a ten-thousandth.
                              {0, 1e-5F, 0},
                              {0, -1e-5F, 0}};
    directions.insert(directions.end(), std::begin(hard), std::end(hard));
    for (const glm::vec3& direction : in_random_order(vary, std::move(directions))) record_angles(out, direction);
}

// Of directions: longitudes a degree off the place where 360 becomes 0, latitudes up to 80 degrees. Of angles: all,
// some beyond the poles.
void at_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        const float longitude = random.uniform(-720, 720);
        const float highest = i % 3 == 0 ? 400 : 90;
        record_direction(out, {longitude, random.uniform(-highest, highest)});
        const double alpha = glm::radians(random.uniform(1, 359));
        const double beta = glm::radians(random.uniform(-80, 80));
        const double size = std::pow(10.0, random.uniform(-3, 3));
        record_angles(out, glm::vec3(size * std::cos(beta) * std::sin(alpha), size * std::sin(beta),
                                     size * std::cos(beta) * std::cos(alpha)));
    }
}

void frames_by_hand(Variation& vary, Recorder& out)
{
    // A camera on the positive x axis that looks at the origin: what is +x in the world is behind it.
    const glm::mat4 from_the_right(glm::vec4(0, 0, 1, 0), glm::vec4(0, 1, 0, 0), glm::vec4(-1, 0, 0, 0),
                                   glm::vec4(0, 0, -5, 1));
    // A camera above the origin that looks straight down, with the world's +x upwards in its picture.
    const glm::mat4 from_above(glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0), glm::vec4(1, 0, 0, 0),
                               glm::vec4(2, 0, -7, 1));
    for (const glm::mat4& view : {from_the_right, from_above})
        for (const LightAngles& angles : {LightAngles{0, 0}, {90, 0}, {0, 90}, {180, -30}})
            record_in_frames(out, turned(vary, angles), view);
}

void record_frames(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const float longitude = random.uniform(-360, 360);
        const LightAngles angles{longitude, random.uniform(-90, 90)};
        record_in_frames(out, angles, random_view(random));
    }
}

// Steps of whole and of half degrees: exact in float. The latitude meets its limits, the longitude goes round.
void keys_by_hand(Variation& vary, Recorder& out)
{
    const std::vector<Session> sessions = {
        {{0, 0}, 5, "xXaAzZcCC"},
        {{350, 85}, 5, "xxxaaazaZx"},
        {{10, -80}, 7.5F, "cczZzacAx"},
        {{-30, 0}, 45, "xaaaacczzzzzxxxx"},
        {{725, 90}, 180, "azxxczzaac"},
        {{0, -90}, 90, "zacAaC"},
        {{500, 89.75F}, 0.5F, "xcaAzc"},
        {{-0.5F, 0}, 0.5F, "xxxccccx"},
        // Through the longitude 0, and away from it, again and again: each key turns the light.
        {{90, 30}, 90, "cxcCxXxxxxccCc"},
        {{240, -15}, 120, "xcxXcCxxaxz"},
        // Neighbours of the keys, in the alphabet and on the keyboard, are no keys.
        {{120, 45}, 10, "bByYwWsSqQdDvV10 \n[{xZ"},
        // Neither are the keys with Ctrl, nor letters of other alphabets that share their last bits.
        {{-60, 15},
         20,
         "x\x01\x18z\x1A\x03\xC1\xE1"
         "c\xDA\xFA\xD8\xF8"
         "a\xC3\xE3"
         "A"}};
    for (const Session& written : in_random_order(vary, sessions)) {
        const Session session = mirrored(vary, written);
        record_keys(out, session.initial, session.step, session.keys);
    }
}

void random_keys(Random& random, Recorder& out)
{
    for (int i = 0; i < 12; ++i) {
        const auto longitude = static_cast<float>(random.below(2000)) - 1000;
        const auto latitude = static_cast<float>(random.below(181)) - 90;
        // Sums of such steps are floats, whole or not.
        const float whole = 0.5F * static_cast<float>(1 + random.below(60));
        const float fine = static_cast<float>(1 + random.below(30 * 1024)) / 1024;
        record_keys(out, {longitude, latitude}, i % 2 == 0 ? whole : fine, random_session(random, 40));
    }
    // Often at the longitude 0.
    for (const float step : {90.0F, 120.0F, 180.0F})
        record_keys(out, {step * static_cast<float>(random.below(4)), 0}, step, random_session(random, 40));
    // A step of a few roundings turns the light, too.
    for (int i = 0; i < 2; ++i) {
        const auto latitude = static_cast<float>(random.below(121)) - 60;
        record_keys(out, {90, latitude}, 0x1p-15F, random_session(random, 40));
    }
}

// From any finite longitude, and back to it: next to 0 on either side, and many turns. What a turn takes off is exact.
void any_longitude(Random& random, Recorder& out)
{
    for (int i = 0; i < 20; ++i) {
        const float size = std::pow(10.0F, i % 4 < 2 ? random.uniform(-44, -6) : random.uniform(3, 38));
        const auto latitude = static_cast<float>(random.below(121)) - 60;
        const LightAngles initial{i % 2 == 0 ? -size : size, latitude};
        const float step = 0.5F * static_cast<float>(1 + random.below(60));
        std::string keys;
        for (int k = 0; k < 2; ++k) keys += random.below(2) == 0 ? "xC" : "cX";
        record_keys(out, initial, step, keys);
    }
}

// A step may be too small for the next float, but not for double. Of six lights four stand next to a pole or at one;
// none comes to it.
void small_steps(Random& random, Recorder& out)
{
    for (int i = 0; i < 12; ++i) {
        const float side = random.below(2) == 0 ? 1.0F : -1.0F;
        const float middle = static_cast<float>(random.below(61));
        const float latitude = side * (i % 3 == 0 ? middle : i % 3 == 1 ? std::nextafter(90.0F, 0.0F) : 90);
        const float step =
            std::ldexp(static_cast<float>(1 + random.below(3)), -24 - static_cast<int>(random.below(12)));
        const auto control = ask_new<make_light_control>(out, "control", LightAngles{90, latitude}, step);
        if (!control) return;
        const std::string_view up = side > 0 ? "aA" : "zZ";
        const std::string_view down = side > 0 ? "zZ" : "aA";
        for (int k = 0; k < 16; ++k) {
            const std::string_view others = "xXcCqbyW";
            const std::string_view kind = k % 4 == 3 ? others : (k < 8 ? up : down);
            const char key = kind[random.below(static_cast<std::uint32_t>(kind.size()))];
            out.append("turned", ask<&LightControl::press>(out, *control, key));
        }
    }
}

// Two lights that are turned in turns: what one is told does not reach the other.
void two_controls(Random& random, Recorder& out)
{
    const auto first = ask_new<make_light_control>(out, "first", LightAngles{10, 20}, 5.0F);
    const auto second = ask_new<make_light_control>(out, "second", LightAngles{200, -40}, 12.5F);
    if (!first || !second) return;
    for (const char key : random_session(random, 60)) {
        record_key(out, random.below(2) == 0 ? *first : *second, key);
        for (const LightControl* control : {first.get(), second.get()})
            out.append("angles", pair_of(ask<&LightControl::angles>(out, *control)));
    }
}

// So many keys as a sentence.
std::string told(const LightAngles& initial, float step, bool is_x, int count)
{
    return "auto control = make_light_control(" + literal::of_value(initial, true, {}) + ", " + literal::of(step) +
           ");\n" + std::to_string(count) + " times control->press('" + (is_x ? 'x' : 'C') +
           "'), and behind every second one control->press('a') or, by turns of 200, control->press('Z');\n"
           "light_direction(control->angles())";
}

// A step that is no float, twenty thousand times. The longitude may be next to 0 and 360, so the direction is asked.
void many_keys(Random& random, Recorder& out)
{
    for (int i = 0; i < 6; ++i) {
        const float step = random.uniform(0.05F, 0.3F);
        const LightAngles initial{random.uniform(0, 360), 0};
        const auto control = make_light_control(initial, step);
        if (!control) return;
        const bool is_x = random.below(2) == 0;
        for (int k = 0; k < 20'000; ++k) {
            control->press(is_x ? 'x' : 'C');
            if (k % 2 == 0) control->press((k / 400) % 2 == 0 ? 'a' : 'Z');
            if (k % 1000 != 999) continue;
            ask_in_words(out, [&] { return told(initial, step, is_x, k + 1); });
            out.append("direction", light_direction(control->angles()));
        }
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { at_random(c.random, out); }},
    {"frames by hand", [](Case& c, Recorder& out) { frames_by_hand(c.vary, out); }},
    {"frames", [](Case& c, Recorder& out) { record_frames(c.random, out); }},
    {"keys by hand", [](Case& c, Recorder& out) { keys_by_hand(c.vary, out); }},
    {"random keys", [](Case& c, Recorder& out) { random_keys(c.random, out); }},
    {"two lights", [](Case& c, Recorder& out) { two_controls(c.random, out); }},
    {"any longitude", [](Case& c, Recorder& out) { any_longitude(c.random, out); }},
    {"small steps", [](Case& c, Recorder& out) { small_steps(c.random, out); }},
    {"poles", [](Case& c, Recorder& out) { record_poles(c.random, out); }},
    {"many turns", [](Case& c, Recorder& out) { many_turns(c.random, out); }},
    {"many keys", [](Case& c, Recorder& out) { many_keys(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("moons", moons(400, 260, c.vary)); }},
};

}
