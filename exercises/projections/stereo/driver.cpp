#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <umbral/projections/stereo.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../volumes.hpp"
#include "anaglyphs.hpp"
#include "screens.hpp"

namespace umbral {
namespace {

using namespace projections;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

void record_pair(Recorder& out, const std::string& name, const StereoPair& pair)
{
    out.append(name + " left view", pair.left.view);
    out.append(name + " left projection", pair.left.projection);
    out.append(name + " right view", pair.right.view);
    out.append(name + " right projection", pair.right.projection);
}

void record(Recorder& out, const StereoScreen& screen)
{
    record_pair(out, "off-axis", ask<off_axis_pair>(out, screen));
    record_pair(out, "toe-in", ask<toe_in_pair>(out, screen));
}

void record_parallax(Recorder& out, const StereoScreen& screen, float distance)
{
    out.append("parallax", ask<parallax>(out, screen, distance));
}

// A row says whether there is a distance; one that is infinite counts as a distance of its own kind.
void record_distance(Recorder& out, const StereoScreen& screen, float parallax)
{
    out.columns("distance", "there is (0: no distance; 1: a distance; 2: an infinite one), distance");
    const std::optional<float> distance = ask<distance_of_parallax>(out, screen, parallax);
    if (!distance)
        out.append("distance", glm::vec2(0));
    else if (*distance == infinity)
        out.append("distance", glm::vec2(2, 0));
    else
        out.append("distance", glm::vec2(1, *distance));
}

// A row says whether there is an answer, and which.
void record_disparity(Recorder& out, const StereoPair& pair, const glm::vec3& point)
{
    out.columns("disparity", "is seen, disparity/2");
    const std::optional<glm::vec2> seen = ask<disparity>(out, pair, point);
    out.append("disparity", seen ? glm::vec3(1, *seen) : glm::vec3(0));
}

// Whole numbers, from 3-4-5 triangles; eyes far apart, so that the two pictures are clearly different. Another screen
// is not square, and the near plane lies behind it.
constexpr StereoScreen triangle = {4, 2, 4, 6, 1, 3};
constexpr StereoScreen known_screens[] = {
    triangle, {2, 2, 2, 1, 0.5F, 4.5F}, {10, 4, 12, 10, 15, 45}, {8, 6, 8, 12, 2, infinity}};

void record_known(Variation& vary, Recorder& out)
{
    // By less than would bring a near plane before its screen.
    const auto length = [&](float written) { return vary.scaled(written, 1.1F); };
    for (const StereoScreen& screen : known_screens)
        record(out, {length(screen.width), length(screen.height), length(screen.distance),
                     length(screen.eye_separation), length(screen.near_plane), length(screen.far_plane)});
}

// On the screen, twice as far, half as far, at infinity; and what none of the lines of sight can have.
void record_known_parallax(Variation& vary, Recorder& out)
{
    const float away = vary.scaled(1.0F, 1.5F);
    const float apart = vary.scaled(1.0F, 1.5F);
    const StereoScreen screen{4, 3, 2 * away, 0.5F * apart, 0.1F, 100};
    for (const float distance : {2.0F, 4.0F, 1.0F, infinity, 8.0F, 0.25F, 16.0F})
        record_parallax(out, screen, distance * away);
    for (const float parallax : {0.0F, 0.25F, -0.5F, 0.5F, 0.375F, -3.5F, 0.75F, infinity})
        record_distance(out, screen, parallax * apart);
}

/// The same viewer before another screen: only the eyes and the distance stay.
StereoScreen another_screen(const StereoScreen& s, Random& random)
{
    StereoScreen other = random_screen(random);
    other.distance = s.distance;
    other.eye_separation = s.eye_separation;
    return other;
}

void record_changed(Random& random, Recorder& out)
{
    for (const StereoScreen& screen : changed_screens(random)) record(out, screen);
    for (const auto& [screen, distance] : changed_distances(random)) record_parallax(out, screen, distance);
    for (const auto& [screen, parallax] : changed_parallaxes(random)) record_distance(out, screen, parallax);
    const StereoScreen screen = random_screen(random);
    const StereoPair pair = given_pair(screen, random);
    const std::vector<glm::vec3> points = changed_points(random, screen);
    for (const glm::vec3& point : points) record_disparity(out, pair, point);
    // The last point again, for another eye on one side, and for twice the same eye.
    const StereoPair other = given_pair(screen, random);
    for (const StereoPair& changed :
         {StereoPair{pair.left, other.right}, {other.left, other.right}, {other.left, other.left}})
        record_disparity(out, changed, points.back());
}

void record_random(Random& random, Recorder& out)
{
    StereoScreen screen{};
    for (int i = 0; i < 60; ++i) {
        screen = i % 4 == 1 ? another_screen(screen, random) : random_screen(random);
        record(out, screen);
        record_parallax(out, screen, screen.distance * random.uniform(0.1F, 10));
        const StereoScreen other = in_some_units(screen, i, random);
        const float seen = other.eye_separation * random.uniform(-8, 0.9F);
        record_distance(out, other, seen);
        // The same parallax at another distance.
        StereoScreen farther = other;
        farther.distance *= 1.5F;
        if (i % 4 == 1) record_distance(out, farther, seen);
        const StereoPair pair = given_pair(other, random);
        record_disparity(out, pair, point_before(other, random));
        if (i % 5 == 0) record_changed(random, out);
    }
}

// Whole numbers again: the course's parallaxes, seen in normalised device coordinates.
void record_known_disparity(Variation& vary, Recorder& out)
{
    const glm::mat4 projection = glm::frustum(-1.0F, 1.0F, -0.5F, 0.5F, 1.0F, 9.0F);
    glm::mat4 left(1);
    left[3].x = 1;
    glm::mat4 right(1);
    right[3].x = -1;
    right[3].y = 0.5F;
    for (const glm::vec3& point :
         {glm::vec3(0, 0, -2), {0, 0, -4}, {3, 1, -2}, {-2, 5, -8}, {0, 0, -64}, {1, 1, -0.5F}})
        record_disparity(out, {{left, projection}, {right, projection}}, vary.near(point, 0.3F));
    // Exactly in the plane of one eye, and before the other, which stands a unit further back or forward.
    right[3].z = -1;
    record_disparity(out, {{left, projection}, {right, projection}}, {1, 2, 0});
    right[3].z = 1;
    record_disparity(out, {{left, projection}, {right, projection}}, {1, 2, -1});
}

// A point before both eyes, and one behind one eye or both, in random order. The eyes look towards each other, so that
// what lies far aside is before one only.
void record_behind(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        const StereoScreen screen = in_some_units(random_screen(random), i, random);
        const auto eye = [&](float side) {
            return EyeMatrices{glm::lookAt(glm::vec3(side * screen.distance, 0, 0), glm::vec3(0, 0, -screen.distance),
                                           glm::vec3(0, 1, 0)),
                               glm::frustum(-1.0F, 1.0F, -1.0F, 1.0F, 1.0F, 50.0F)};
        };
        const StereoPair pair{eye(-1), eye(1)};
        const glm::vec3 before = point_before(screen, random) - glm::vec3(0, 0, screen.distance);
        const float beyond = screen.distance * random.uniform(3, 9);
        glm::vec3 behind(i % 4 < 2 ? beyond : -beyond, before.y, -0.5F * screen.distance);
        if (i % 4 == 3) behind = glm::vec3(before.x, before.y, 2 * beyond);
        const bool first = random.below(2) == 1;
        for (const bool is_behind : {first, !first}) record_disparity(out, pair, is_behind ? behind : before);
    }
}

/// A far plane at infinity; or, counted in so small a unit that the near plane has a large number, hardly nearer.
StereoScreen with_far_plane(StereoScreen screen, bool is_huge, Random& random)
{
    if (is_huge) screen = in_units(screen, 100 / screen.near_plane);
    screen.far_plane = is_huge ? random.uniform(0.1F, 0.9F) * std::numeric_limits<float>::max() : infinity;
    return screen;
}

void record_infinite(Random& random, Recorder& out)
{
    for (int i = 0; i < 30; ++i) {
        // Or nearly infinite: near times far is more than a float can hold.
        const bool is_huge = i % 3 == 2;
        const StereoScreen screen = with_far_plane(random_screen(random), is_huge, random);
        record(out, screen);
        record_parallax(out, screen, i % 2 == 0 ? infinity : screen.distance * random.uniform(0.5F, 9));
        const bool first = random.below(2) == 1;
        const StereoScreen other = in_some_units(screen, i / 2, random);
        const float larger = other.eye_separation * random.uniform(1.001F, 3);
        const float smaller = other.eye_separation * random.uniform(-2, 0.999F);
        for (const bool none : {first, !first})
            record_distance(out, other, none ? larger : i % 3 == 0 ? other.eye_separation : smaller);
    }
}

// A screen, and what is none, in random order.
void record_refused(Random& random, Recorder& out)
{
    for (int i = 0; i < 56; ++i) {
        const StereoScreen good =
            in_units(random_screen(random), i % 3 == 0 ? std::pow(10.0F, random.uniform(-7, -4)) : 1.0F);
        StereoScreen bad = good;
        const float wrong[] = {0, -1, no_number};
        float* const numbers[] = {&bad.width, &bad.height, &bad.distance, &bad.eye_separation, &bad.near_plane};
        if (i % 14 < 10) *numbers[i % 5] = wrong[(i % 14) / 5 + (i % 2)];
        if (i % 14 == 10) bad.far_plane = bad.near_plane;
        if (i % 14 == 11) bad.far_plane = 0.5F * bad.near_plane;
        if (i % 14 == 12) bad.far_plane = -bad.far_plane;
        if (i % 14 == 13) bad.far_plane = no_number;
        // What does not count for a parallax may be anything.
        const StereoScreen measured = {no_number, -1, good.distance, good.eye_separation, 0, 0};
        const float wrong_distances[] = {0, -good.distance, -infinity, no_number};
        const bool first = random.below(2) == 1;
        for (const bool is_bad : {first, !first}) {
            const StereoScreen& asked = is_bad ? bad : good;
            const float distance = is_bad ? wrong_distances[i % 4] : good.distance * (i % 4 == 0 ? infinity : 2);
            record_refusal(out, "off-axis refused", [&] { return ask<off_axis_pair>(out, asked); });
            record_refusal(out, "toe-in refused", [&] { return ask<toe_in_pair>(out, asked); });
            record_refusal(out, "parallax refused",
                           [&] { return ask<parallax>(out, i % 2 == 0 ? good : measured, distance); });
        }
    }
}

// Points a hair before or behind the screen; and eyes so close together that both see nearly the same.
void record_near_the_screen(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const StereoScreen screen = random_screen(random);
        const float aside = (i % 2 == 0 ? 1.0F : -1.0F) * std::pow(10.0F, random.uniform(-6, -3));
        record_parallax(out, screen, screen.distance * (1 + aside));
    }
    for (int i = 0; i < 200; ++i) {
        const StereoScreen screen = random_screen(random);
        const glm::mat4 projection = glm::frustum(-0.5F, 0.5F, -0.4F, 0.4F, 1.0F, 100.0F);
        glm::mat4 left(1);
        left[3].x = screen.width * std::pow(10.0F, random.uniform(-5, -3));
        glm::mat4 right(1);
        right[3].x = -left[3].x;
        const StereoPair pair{{left, projection}, {right, projection}};
        const std::optional<glm::vec2> seen = ask<disparity>(out, pair, point_before(screen, random));
        out.append("disparity", seen.value_or(glm::vec2(no_number)));
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"known parallax", [](Case& c, Recorder& out) { record_known_parallax(c.vary, out); }},
    {"known disparity", [](Case& c, Recorder& out) { record_known_disparity(c.vary, out); }},
    {"known pixels", [](Case& c, Recorder& out) { record_known_pixels(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"random pixels", [](Case& c, Recorder& out) { record_random_pixels(c.random, out); }},
    {"behind", [](Case& c, Recorder& out) { record_behind(c.random, out); }},
    {"infinite", [](Case& c, Recorder& out) { record_infinite(c.random, out); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(c.random, out); }},
    {"near the screen", [](Case& c, Recorder& out) { record_near_the_screen(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { draw_anaglyph(c.vary, out); }},
};

}
