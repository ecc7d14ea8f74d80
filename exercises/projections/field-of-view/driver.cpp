#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <umbral/projections/perspective.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../island.hpp"
#include "../volumes.hpp"

namespace umbral {
namespace {

using namespace projections;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

// A row of what the call gives, or of `none` if it refuses what it must not.
template <class Answer, class Call>
void record_answer(Recorder& out, const char* name, Answer none, Call call)
{
    try {
        none = call();
    } catch (const std::exception& refusal) {
        out.refused(name, refusal.what());
    }
    out.append(name, none);
}

void record(Recorder& out, const Lens& lens)
{
    const glm::mat4 none(no_number);
    record_answer(out, "matrix", none, [&] { return ask<perspective_matrix>(out, lens); });
    record_answer(out, "reversed", none, [&] { return ask<reversed_perspective_matrix>(out, lens); });
}

void record_angle(Recorder& out, float fovx_degrees, float aspect)
{
    record_answer(out, "fovy", no_number, [&] { return ask<vertical_field_of_view>(out, fovx_degrees, aspect); });
}

// A right angle; one whose half has the tangent 1/2; a picture that is higher than wide; the course's orbital camera
// for a picture of 16 : 9.
void record_known(Variation& vary, Recorder& out)
{
    const Lens lenses[] = {
        {90, 1, 1, 3}, {90, 2, 1, 5}, {53.130102F, 1, 2, 6}, {90, 0.5F, 0.5F, 2}, {60, 16.0F / 9, 0.05F, 1000.05F}};
    for (const Lens& lens : lenses)
        record(out, {vary.near(lens.fovy_degrees, 6.0F), vary.scaled(lens.aspect, 1.2F),
                     vary.scaled(lens.near_plane, 1.2F), vary.scaled(lens.far_plane, 1.2F)});
}

void record_known_angles(Variation& vary, Recorder& out)
{
    for (const auto& [fovx, aspect] : {std::pair(90.0F, 1.0F), {60, 1}, {90, 2}, {90, 0.5F}, {73.73980F, 1.5F}})
        record_angle(out, vary.near(fovx, 8.0F), vary.scaled(aspect, 1.2F));
}

// Planes at usual distances, and every fourth time at any: metres are not the only unit.
Lens random_lens(Random& random)
{
    const float decades = random.below(4) == 0 ? random.uniform(-6, 7) : random.uniform(-2, 1);
    const float near_plane = std::pow(10.0F, decades);
    return {random.uniform(10, 150), random.uniform(0.4F, 3), near_plane,
            near_plane * std::pow(10.0F, random.uniform(0.2F, 5))};
}

// Planes at any distance that floats have, but for the last few powers of ten.
Lens any_lens(Random& random)
{
    const Lens lens = random_lens(random);
    const float near_plane = std::pow(10.0F, random.uniform(-36, 33));
    return {lens.fovy_degrees, lens.aspect, near_plane, near_plane * (lens.far_plane / lens.near_plane)};
}

// Far planes at infinity; and, for A, which is 0 there only, in pairs with some that are just very far.
void record_infinite(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        Lens lens = random_lens(random);
        lens.far_plane = infinity;
        record(out, lens);
        const float far_plane = lens.near_plane * std::pow(10.0F, random.uniform(4, 9));
        const bool infinite_first = random.below(2) == 0;
        for (const bool is_infinite : {infinite_first, !infinite_first}) {
            lens.far_plane = is_infinite ? infinity : far_plane;
            record_answer(out, "A", no_number, [&] { return ask<reversed_perspective_matrix>(out, lens)[2][2]; });
        }
    }
}

// A lens, and something that is none, in random order: every second time a lens that is almost none.
void record_refused(Random& random, Recorder& out)
{
    constexpr float least = std::numeric_limits<float>::denorm_min();
    constexpr float most = std::numeric_limits<float>::max();
    constexpr int kinds = 14;
    for (int i = 0; i < 3 * kinds; ++i) {
        const int kind = i % kinds;
        Lens good = random_lens(random);
        Lens bad = good;
        Lens close = good;
        const float angles[] = {0, 180, -40, 270, no_number};
        const float aspects[] = {0, -1.5F, no_number};
        const float far_planes[] = {bad.near_plane, i < kinds ? no_number : 0.5F * bad.near_plane, -infinity, infinity};
        if (kind < 5) bad.fovy_degrees = angles[kind];
        if (kind >= 5 && kind < 8) bad.aspect = aspects[kind - 5];
        if (kind == 8) bad.near_plane = 0;
        if (kind == 9) bad.near_plane = -1;
        if (kind >= 10) bad.far_plane = far_planes[kind - 10];
        if (kind == 13) bad.near_plane = good.far_plane = infinity;
        if (kind == 0 || kind == 2) close.fovy_degrees = least;
        if (kind == 1 || kind == 3) close.fovy_degrees = std::nextafter(180.0F, 0.0F);
        if (kind == 5) close.aspect = least;
        if (kind == 6) close.aspect = most;
        if (kind == 8) close.near_plane = least;
        if (kind >= 9) close.far_plane = next_above(close.near_plane);
        if (kind == 13) close = {close.fovy_degrees, close.aspect, most, infinity};
        if (i / kinds % 2 == 1) good = close;
        const bool first = random.below(2) == 1;
        for (const bool is_bad : {first, !first}) {
            const Lens& asked = is_bad ? bad : good;
            record_refusal(out, "refused", [&] { return ask<perspective_matrix>(out, asked); });
            record_refusal(out, "reversed refused", [&] { return ask<reversed_perspective_matrix>(out, asked); });
            if (kind < 8)
                record_refusal(out, "angle refused",
                               [&] { return ask<vertical_field_of_view>(out, asked.fovy_degrees, asked.aspect); });
        }
    }
}

// As close as 10^-4 of a degree to 180, or as small.
float extreme_angle(int kind, Random& random)
{
    const float rest = std::pow(10.0F, random.uniform(-4, -0.5F));
    return kind % 4 == 3 ? rest : 180 - rest;
}

// Extreme angles, planes at any distance, and far planes right behind near ones.
void record_extremes(Random& random, Recorder& out)
{
    for (int i = 0; i < 100; ++i) {
        Lens lens = any_lens(random);
        lens.fovy_degrees = extreme_angle(i, random);
        record(out, lens);
        lens.far_plane = lens.near_plane * (1 + std::pow(10.0F, random.uniform(-5, -2)));
        record(out, lens);
    }
}

void record_extreme_angles(Random& random, Recorder& out)
{
    for (int i = 0; i < 100; ++i) {
        const float angle = extreme_angle(i, random);
        record_angle(out, angle, std::pow(10.0F, i % 8 < 4 ? random.uniform(1, 5) : random.uniform(-12, 12)));
    }
}

// The same lighthouse as large in three pictures: from far away with a long lens, and from nearby with a wide one.
void draw_vertigo(Variation& vary, Recorder& out)
{
    constexpr glm::ivec2 size(420, 240);
    constexpr int panels = 3;
    constexpr int gap = 8;
    const Stage stage(size.x, size.y, {0.07F, 0.07F, 0.09F});
    const Island island;
    constexpr glm::vec3 sky(0.58F, 0.76F, 0.91F);
    const glm::vec3 lighthouse(-2.5F, 1.45F, 2.5F);
    const glm::vec3 from = glm::normalize(vary.near(glm::vec3(-0.62F, 0.16F, 1), 0.15F));
    const glm::ivec2 extent(2 * size.x / panels - gap, 2 * size.y);
    int panel = 0;
    for (const float written : {14.0F, 42.0F, 96.0F}) {
        const float fovy_degrees = vary.scaled(written, 1.15F);
        begin_panel({panel * (2 * size.x + gap) / panels, 0}, extent, sky);
        const float distance = 1.5F / std::tan(glm::radians(fovy_degrees) / 2);
        const glm::mat4 view = glm::lookAt(lighthouse + distance * from, lighthouse, glm::vec3(0, 1, 0));
        const float aspect = static_cast<float>(extent.x) / static_cast<float>(extent.y);
        look_through(stage, view, ask<perspective_matrix>(out, {fovy_degrees, aspect, 0.2F, 60}));
        island.draw_at_sea(stage, sky);
        ++panel;
    }
    out.image("colours", stage.picture());
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"known angles", [](Case& c, Recorder& out) { record_known_angles(c.vary, out); }},
    {"random",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 100; ++i) record(out, random_lens(c.random));
     }},
    {"random angles",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 100; ++i) {
             const float fovx_degrees = c.random.uniform(10, 150);
             record_angle(out, fovx_degrees, c.random.uniform(0.4F, 3));
         }
     }},
    {"infinite", [](Case& c, Recorder& out) { record_infinite(c.random, out); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(c.random, out); }},
    {"extremes", [](Case& c, Recorder& out) { record_extremes(c.random, out); }},
    {"extreme angles", [](Case& c, Recorder& out) { record_extreme_angles(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { draw_vertigo(c.vary, out); }},
};

}
