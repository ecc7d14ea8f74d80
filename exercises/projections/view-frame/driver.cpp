#include <kit/numbers_changed.hpp>
#include <kit/scene.hpp>
#include <tuple>
#include <umbral/projections/view_frame.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"

namespace umbral {
namespace {

using namespace projections;

// Axes and origin as columns.
void record_frame(Recorder& out, const ViewParameters& view)
{
    std::optional<glm::mat4> columns;
    if (const std::optional<ViewFrame> frame = ask<view_frame>(out, view))
        columns = glm::mat4(glm::vec4(frame->x, 0), glm::vec4(frame->y, 0), glm::vec4(frame->z, 0),
                            glm::vec4(frame->origin, 1));
    out.append("frame", columns);
}

struct Direction {
    float azimuth_degrees;
    float elevation_degrees;
    float roll_degrees;
};

/// Other angles, if inputs are to vary; straight above and below remains so.
Direction varied(Variation& vary, Direction from)
{
    from.azimuth_degrees = vary.near(from.azimuth_degrees, 20.0F);
    if (std::abs(from.elevation_degrees) != 90) from.elevation_degrees = vary.near(from.elevation_degrees, 10.0F);
    from.roll_degrees = vary.near(from.roll_degrees, 20.0F);
    return from;
}

/// `size` is a power of two: the normal is recorded in this unit.
ViewParameters record_view(Recorder& out, const glm::vec3& target, float distance, const Direction& from,
                           float size = 1)
{
    const ViewParameters view =
        ask<view_from>(out, target, size * distance, from.azimuth_degrees, from.elevation_degrees, from.roll_degrees);
    out.append("target", view.target);
    out.append("normal", view.normal / size);
    out.append("up", view.up);
    return view;
}

// Along the axes, and the view of problem 3.1.
void record_known_frames(Variation& vary, Recorder& out)
{
    const ViewParameters views[] = {
        {{0, 0, 0}, {0, 1, 0}, {0, 0, 5}},  {{1, 2, 3}, {0, 1, 0}, {3, 0, 0}},
        {{1, 0, 0}, {0, 0, -1}, {0, 4, 0}}, {{0, 1, 0}, {0, 2, 0}, {0, 3, 4}},
        {{0, 0, 2}, {3, 4, 0}, {0, 0, 1}},  {{0, 0.5F, 0}, {0, 1, 0}, {2.1213203F, 0, 2.1213203F}}};
    for (const ViewParameters& view : views) {
        const ExactMap map = vary.exact_map();
        record_frame(out, {vary.near(view.target, 0.5F), map.direction(view.up), map.place(view.normal)});
    }
}

// Problems 3.1 and 3.2, then one angle at a time.
void record_known_views(Variation& vary, Recorder& out)
{
    const auto record_other = [&](const glm::vec3& target, float distance, const Direction& from) {
        record_view(out, vary.near(target, 0.5F), vary.scaled(distance, 1.2F), varied(vary, from));
    };
    record_other({0, 0.5F, 0}, 3, {45, 0, 0});
    record_other({0, 0.5F, 0}, 3, {45, 0, 45});
    for (const Direction& from : {Direction{0, 0, 0},
                                  {90, 0, 0},
                                  {180, 0, 0},
                                  {-270, 0, 210},
                                  {0, 30, 0},
                                  {0, -90, 0},
                                  {0, 90, 0},
                                  {90, 90, 0},
                                  {0, 0, 90},
                                  {0, 0, -30},
                                  {22.5F, 12.25F, 7.75F},
                                  {90, 60, 180}})
        record_other({1, 2, 3}, 2, from);
}

ViewParameters random_view(Random& random)
{
    const Placement camera = random_placement(random);
    return {camera.target, camera.up, camera.eye - camera.target};
}

Direction random_direction(Random& random, float largest)
{
    const float azimuth = random.uniform(-largest, largest);
    const float elevation = random.uniform(-largest, largest);
    return {azimuth, elevation, random.uniform(-largest, largest)};
}

/// Of four one is straight above or below, where azimuth and roll count all the same, one nearly so, and one after up
/// to a whole turn in each angle.
Direction random_direction_of_kind(Random& random, int kind)
{
    Direction from = random_direction(random, kind == 3 ? 360.0F : 180.0F);
    const float pole = random.below(2) == 0 ? 90.0F : -90.0F;
    if (kind == 1) from.elevation_degrees = pole;
    if (kind == 2) from.elevation_degrees = pole + from.elevation_degrees * std::pow(10.0F, random.uniform(-5, -1));
    return from;
}

/// One number of a view after the other is another.
void record_changed(Random& random, Recorder& out)
{
    constexpr float least_sine = 0.1F;
    const auto has_a_frame = [](const ViewParameters& view) {
        return length(cross(view.up, view.normal)) > least_sine * length(view.up) * length(view.normal);
    };
    for (const ViewParameters& view : numbers_changed(random, random_view(random), 9, has_a_frame))
        record_frame(out, view);
    const std::tuple asked(5.0F * random.in_cube(), random.uniform(0.5F, 8), random_direction(random, 180));
    const auto is_apart = [](const auto& question) { return std::get<1>(question) > 0; };
    for (const auto& [target, distance, from] : numbers_changed(random, asked, 7, is_apart))
        record_view(out, target, distance, from);
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        record_frame(out, random_view(random));
        const glm::vec3 target = 5.0F * random.in_cube();
        const float distance = random.uniform(0.5F, 8);
        const float size = i / 4 % 4 == 0 ? std::ldexp(1.0F, static_cast<int>(random.below(61)) - 30) : 1;
        record_view(out, target, distance, random_direction_of_kind(random, i % 4), size);
        if (i % 20 == 0) record_changed(random, out);
    }
}

/// Of three factors one is usual, one makes a vector as short as a float can be without losing its direction, and one
/// as long.
float factor_of_kind(Random& random, int kind)
{
    if (kind % 3 == 0) return std::pow(10.0F, random.uniform(-25, 25));
    // In two steps: the smallest ones are no numbers of all bits.
    return kind % 3 == 1 ? 1e-5F * std::pow(10.0F, random.uniform(-37, -25))
                         : std::pow(10.0F, random.uniform(28, 36.5F));
}

// Only directions count for the axes.
void record_lengths(Random& random, Recorder& out)
{
    for (int i = 0; i < 100; ++i) {
        ViewParameters view = random_view(random);
        view.up *= factor_of_kind(random, i);
        if (i / 3 % 4 != 3) view.normal *= factor_of_kind(random, i / 3);
        record_frame(out, view);
    }
}

/// The same view, its `up` turned until the sine of its angle to the normal is near `sine`, or to its other end.
ViewParameters almost_parallel(const ViewParameters& view, double sine, bool flipped, Random& random)
{
    const Placement placement = with_up_near_view({view.normal, glm::vec3(0), view.up}, sine, flipped, random);
    return {view.target, placement.up, view.normal};
}

// A view with a frame and one without, in random order, of all lengths: without up or normal, with parallel ones, with
// both ends of almost parallel ones; beside the latter stands another one that is almost parallel, but less so.
void record_none(Random& random, Recorder& out)
{
    for (int i = 0; i < 48; ++i) {
        ViewParameters good = random_view(random);
        ViewParameters bad = good;
        const bool flipped = i / 4 % 2 == 0;
        const double little = std::pow(10.0F, random.uniform(-1, 0));
        switch (i % 4) {
            case 0: bad.up = glm::vec3(0); break;
            case 1: bad.normal = glm::vec3(0); break;
            case 2: bad.up = (flipped ? -0.5F : 4.0F) * bad.normal; break;
            default:
                bad = almost_parallel(bad, 6e-7 * little, flipped, random);
                good = almost_parallel(good, 1.5e-6 / little, flipped, random);
        }
        const float scale = i / 8 % 2 == 0 ? 1.0F : std::pow(10.0F, random.uniform(-35, 35));
        const bool first = random.below(2) == 1;
        for (const bool is_bad : {first, !first}) {
            const auto& [target, up, normal] = is_bad ? bad : good;
            out.append("found", ask<view_frame>(out, {target, scale * up, scale * normal}).has_value());
        }
    }
}

void record_almost_parallel(Random& random, Recorder& out)
{
    for (const double sine : {1e-2, 1e-3, 1e-4, 1e-5, 2e-6, 1.25e-6, 7.5e-7})
        for (int i = 0; i < 40; ++i) record_frame(out, almost_parallel(random_view(random), sine, i % 2 == 1, random));
}

glm::mat4 view_matrix_of(const std::optional<ViewFrame>& frame)
{
    if (!frame) return glm::mat4(0);
    const glm::mat3 rows = glm::transpose(glm::mat3(frame->x, frame->y, frame->z));
    glm::mat4 view(rows);
    view[3] = glm::vec4(-rows * frame->origin, 1);
    return view;
}

// The views of problems 3.1 and 3.2, and one from above.
void draw_views(Variation& vary, Recorder& out)
{
    constexpr int side = 256;
    constexpr int gap = 8;
    const Direction directions[] = {{45, 0, 0}, {45, 0, 45}, {30, 90, 0}};
    Image picture(3 * side + 2 * gap, side, pixel_of(srgb_decoded(ink::night)));
    int left = 0;
    for (const Direction& written : directions) {
        const Direction from = varied(vary, written);
        const float distance = from.elevation_degrees == 90 ? 5.2F : 3.0F;
        const ViewParameters view = ask<view_from>(out, glm::vec3(0, 0.5F, 0), distance, from.azimuth_degrees,
                                                   from.elevation_degrees, from.roll_degrees);
        const Image panel = draw_scene(view_matrix_of(ask<view_frame>(out, view)));
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) picture.at(left + x, y) = panel.at(x, y);
        left += side + gap;
    }
    out.image("colours", picture);
}

}

const Driver driver = {
    {"known frames", [](Case& c, Recorder& out) { record_known_frames(c.vary, out); }},
    {"known views", [](Case& c, Recorder& out) { record_known_views(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"lengths", [](Case& c, Recorder& out) { record_lengths(c.random, out); }},
    {"none", [](Case& c, Recorder& out) { record_none(c.random, out); }},
    {"almost parallel", [](Case& c, Recorder& out) { record_almost_parallel(c.random, out); }},
    {"many turns",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 100; ++i) record_view(out, {0, 0, 0}, 1, random_direction(c.random, 1e6F));
     }},
    {"picture", [](Case& c, Recorder& out) { draw_views(c.vary, out); }},
};

}
