#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "anamorphosis.hpp"
#include "snap_cameras.hpp"
#include "special_questions.hpp"

namespace umbral {
namespace {

using namespace interaction;

std::optional<float> as_row(std::optional<double> value)
{
    return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

void record_pixel(Recorder& out, glm::dvec2 cursor, glm::ivec2 window, glm::ivec2 framebuffer)
{
    out.columns("pixel", "column, row");
    out.append("pixel", ask<cursor_pixel>(out, cursor, window, framebuffer));
}

/// Windows with 1, 1.5, 2 and 0.5 pixels for each coordinate, in both directions alike or not; inside, at borders and
/// outside, and a hair beside the borders of large ones; and minimised ones.
void record_pixels(Recorder& out, Random& random)
{
    for (const glm::dvec2& cursor :
         {glm::dvec2(0), {99.5, 40.25}, {-0.25, -0.5}, {-1, -3}, {640, 480}, {639.75, 479.75}})
        for (const glm::ivec2& framebuffer : {glm::ivec2(640, 480), {1280, 960}, {960, 720}})
            record_pixel(out, cursor, {640, 480}, framebuffer);
    for (int i = 0; i < 60; ++i) {
        const glm::ivec2 window(64 << between(0, 4, random), 32 << between(0, 4, random));
        const glm::ivec2 framebuffer(window.x / 2 * between(1, 4, random), window.y / 2 * between(1, 4, random));
        const double x = between(-100, 140 * 64, random) / 64.0 - 9;
        record_pixel(out, {x, between(-100, 140 * 64, random) / 64.0 - 20}, window, framebuffer);
    }
    for (int i = 0; i < 60; ++i) {
        const glm::ivec2 window(between(2000, 6000, random), between(2000, 6000, random));
        const glm::ivec2 framebuffer(between(2000, 9000, random), between(2000, 9000, random));
        const auto beside_border = [&](int pixels) {
            const double hair = std::pow(10.0, between(-9.7, -4.0, random));
            return between(1 - pixels, 2 * pixels, random) + (random.below(2) == 0 ? hair : -hair);
        };
        const double x = beside_border(framebuffer.x);
        const glm::dvec2 place(x, beside_border(framebuffer.y));
        record_pixel(out, place * glm::dvec2(window) / glm::dvec2(framebuffer), window, framebuffer);
    }
    // Minimised: any of the four sizes is 0, at least one.
    for (int zeros = 1; zeros < 16; ++zeros) {
        const auto size = [&](int which) { return (zeros >> which & 1) != 0 ? 0 : between(1, 640, random); };
        const glm::ivec2 window{size(0), size(1)};
        record_pixel(out, {5, 6}, window, {size(2), size(3)});
    }
    record_pixel(out, {0.5, 0.75}, {1, 1}, {1, 1});
}

/// The course's example, the corners of a small view, views that do not begin at 0, and mirrored ones.
void record_linear(Variation& vary, Recorder& out)
{
    const auto other = [&](const ViewLimits& limits) {
        return ViewLimits{vary.near(limits.left, 0.4), vary.near(limits.right, 0.4), vary.near(limits.bottom, 0.4),
                          vary.near(limits.top, 0.4)};
    };
    const ViewLimits limits = other({-2, 2, -1.5, 1.5});
    out.append("world", ask<pixel_in_world>(out, glm::ivec2(100, 50), limits, glm::ivec2(800, 600)));
    for (const glm::ivec2& pixel : {glm::ivec2(0, 0), {3, 1}, {0, 1}, {3, 0}, {1, 0}, {-1, 2}})
        for (const ViewLimits& shown : {ViewLimits{0, 4, 0, 2}, {10, 12, -7, -6}, {1, -1, 3, -1}})
            out.append("world", ask<pixel_in_world>(out, pixel, other(shown), glm::ivec2(4, 2)));
}

void record_random_linear(Recorder& out, Random& random)
{
    for (int i = 0; i < 400; ++i) {
        const glm::ivec2 size(between(1, 1500, random), between(1, 1000, random));
        const glm::ivec2 pixel(between(-9, size.x + 8, random), between(-9, size.y + 8, random));
        const ViewLimits limits = i % 4 == 0 ? map_limits(pixel, size, random) : random_limits(random);
        out.append("world", ask<pixel_in_world>(out, pixel, limits, size));
    }
}

/// In a world that is so many times as large as the one that is recorded.
void record_point(Recorder& out, const SnapCamera& camera, glm::ivec2 pixel, const SnapPlane& plane, double size = 1)
{
    const SnapCamera sized = in_a_world_of(size, camera);
    std::optional<glm::dvec3> point = ask<point_on_plane>(out, pixel, sized.size, sized.view, sized.projection,
                                                          SnapPlane{plane.normal, size * plane.offset});
    if (point) *point /= size;
    out.append("point", point);
}

/// By hand: cameras without rotation, the floor, walls, normals that are not unit; planes behind, along the ray, and
/// through the observer.
void record_planes(Variation& vary, Recorder& out)
{
    // The world turned by quarters of a turn, in which nothing is rounded, the camera with it.
    const auto record_turned = [&](SnapCamera camera, glm::ivec2 pixel, SnapPlane plane) {
        const ExactMap map = vary.exact_map(0);
        const glm::mat3 turn = map.matrix();
        camera.view *= glm::mat4(glm::transpose(turn));
        plane.normal = glm::dmat3(turn) * plane.normal;
        record_point(out, camera, pixel, plane);
    };
    const glm::ivec2 size(4, 4);
    const glm::mat4 high = glm::translate(glm::mat4(1), {0, -2, 0});
    const SnapCamera wide{high, glm::frustum(-1.0F, 1.0F, -1.0F, 1.0F, 1.0F, 9.0F), size};
    const SnapCamera flat{high, glm::ortho(-4.0F, 4.0F, -2.0F, 2.0F, 1.0F, 9.0F), size};
    const SnapPlane planes[] = {{{0, 1, 0}, 0},
                                {{0, 5, 0}, 2.5},
                                {{0, 0, 1}, -8},
                                {{0, 0, -2}, 40},
                                {{0, 0, 1}, 3},
                                {{1, 0, 0}, 2},
                                {{0, -1, 0}, -7},
                                {{1, 1, 1}, 0},
                                {{0, 0, 1}, -0.5},
                                {{0, 3, 4}, -100},
                                {{0, 0, 0.25}, -30},
                                // The same planes with a normal of any length: parallel is a matter of angles.
                                {{0, 1e-12, 0}, 0},
                                {{0, 0, 1e-12}, -8e-12},
                                {{1e12, 0, 0}, 2e12}};
    for (const SnapCamera& camera : {wide, flat})
        for (const SnapPlane& plane : planes)
            for (const glm::ivec2& pixel : {glm::ivec2(0, 3), {3, 1}, {2, 2}}) record_turned(camera, pixel, plane);
    // Planes that lean by less than a millionth away from the rays of these pixels, which are (1, -1, -4) / 4 and
    // (3, 1, -4) / 4 for the first camera and -z for the second one: by more than what is parallel, and by less. They
    // would be met a few steps ahead.
    for (const double lean : {0x1p-26, -0x1p-23, 0x1p-31, -0x1p-33, 0x1p-35}) {
        record_turned(wide, {2, 2}, {{1, 1, lean}, 2 - 8 * lean});
        record_turned(wide, {3, 1}, {{1, -3, lean}, -6 - 5 * lean});
        record_turned(flat, {2, 2}, {{1, 2, lean}, 4 - 6 * lean});
        record_turned(flat, {1, 0}, {{-3, 1, lean}, 6.5 - 3 * lean});
    }
}

/// Pairs in random order: a plane through a point in front of a pixel, and the same one behind it, or one along the ray
/// where the camera sees what is behind too. One point in four is nearer than the near plane, or beyond the far one.
/// Half of the worlds are of another size, down to a millionth.
void record_random_planes(Recorder& out, Random& random)
{
    for (int i = 0; i < 200; ++i) {
        const double size = i % 2 == 0 ? 1 : std::exp2(between(-20, 12, random));
        const SnapCamera camera = random_camera(random);
        const glm::ivec2 pixel(between(-20, camera.size.x + 20, random), between(-20, camera.size.y + 20, random));
        const glm::dmat4 to_world = glm::inverse(glm::dmat4(camera.projection) * glm::dmat4(camera.view));
        const auto at_depth = [&](double depth) {
            const glm::dvec4 place = to_world * glm::dvec4(2 * (pixel.x + 0.5) / camera.size.x - 1,
                                                           1 - 2 * (pixel.y + 0.5) / camera.size.y, depth, 1);
            return glm::dvec3(place) / place.w;
        };
        const glm::dvec3 nearest = at_depth(-1);
        const glm::dvec3 ahead = at_depth(1) - nearest;
        // A normal that leans towards the ray, of any length.
        const glm::dvec3 lean = glm::normalize(ahead) + 0.85 * glm::dvec3(random.in_cube());
        glm::dvec3 normal = between(0.2, 5.0, random) * (random.below(2) == 0 ? lean : -lean);
        // Planes as floors, walls and ramps are: one coordinate of the normal is 0, or two are.
        if (i % 5 == 1) normal = along_axes(ahead, random);
        const bool sees_behind = camera.projection[3][3] == 1;
        const double distance = between(0.5, 12.0, random);
        const double behind_or_beyond = sees_behind ? -distance : 20 * distance;
        glm::dvec3 seen = nearest + (i % 4 < 2 ? distance : behind_or_beyond) * glm::normalize(ahead);
        const glm::dvec3 eye(glm::inverse(glm::dmat4(camera.view))[3]);
        if (i % 4 == 3 && !sees_behind) seen = glm::mix(eye, nearest, between(0.3, 0.9, random));
        const glm::dvec3 unseen = nearest - (5 + 3 * distance) * glm::normalize(ahead);
        const bool first = random.below(2) == 0;
        for (const bool hit : {first, !first}) {
            const glm::dvec3 through = hit ? seen : unseen;
            const SnapPlane along{glm::cross(ahead, glm::dvec3(1, 2, 3)), 7};
            const SnapPlane plane = !hit && sees_behind ? along : SnapPlane{normal, glm::dot(normal, through)};
            record_point(out, camera, pixel, plane, size);
        }
    }
}

/// Every combination of buttons, and views of different shape.
void record_moves(Recorder& out, Random& random)
{
    for (unsigned buttons = 0; buttons < 8; ++buttons)
        out.append("cursor", glm::vec3(ask<moved_cursor>(out, glm::dvec3(1, 2, 3), glm::dvec2(8, 5), buttons,
                                                         ViewLimits{-4, 4, -1, 2}, glm::ivec2(64, 30))));
    record_changed_moves(out, random);
    for (int i = 0; i < 150; ++i) {
        const glm::dvec3 cursor(5.0F * random.in_cube());
        const glm::dvec2 motion(between(-90.0, 90.0, random), between(-70.0, 70.0, random));
        const unsigned buttons = random.below(4) + 4 * random.below(3);
        const glm::ivec2 size(between(50, 1500, random), between(50, 900, random));
        out.append("cursor", glm::vec3(ask<moved_cursor>(out, cursor, motion, buttons, random_limits(random), size)));
    }
}

void record_views(Recorder& out, Random& random)
{
    record_changed_views(out, random);
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 cursor = i == 0 ? glm::dvec3(1, 2, 3) : glm::dvec3(5.0F * random.in_cube());
        const glm::dvec2 place = i == 0 ? glm::dvec2(7, 8) : glm::dvec2(random.in_cube());
        for (const LinkedView view : {LinkedView::front, LinkedView::top, LinkedView::side}) {
            out.append("shown", ask<cursor_in_view>(out, view, cursor));
            out.append("entered", glm::vec3(ask<cursor_from_view>(out, view, place, cursor)));
        }
    }
}

/// All directions, both sides of the cut to the left, and the same point; far from the origin too.
void record_angles(Variation& vary, Recorder& out)
{
    for (const glm::dvec2& reference : {glm::dvec2(0), {320, 240}, {-15.5, 1e5}})
        for (const glm::dvec2& way : {glm::dvec2(10, 0),
                                      {10, -10},
                                      {0, -4},
                                      {-3, -3},
                                      {-8, 0},
                                      {-6, 6},
                                      {0, 0},
                                      {0, 5},
                                      {2, 2},
                                      {-512, 0.0078125},
                                      {-512, -0.0078125}}) {
            // Ways along the axes remain so.
            const double wider = vary.scaled(1.0, 1.5F);
            const glm::dvec2 other = way * glm::dvec2(wider, vary.scaled(1.0, 1.5F));
            out.append("angle", as_row(ask<entered_angle>(out, reference, reference + other)));
        }
}

void record_random_angles(Recorder& out, Random& random)
{
    for (int i = 0; i < 100; ++i) {
        const glm::dvec2 reference(between(0.0, 640.0, random), between(0.0, 480.0, random));
        const double x = between(-50.0, 690.0, random);
        glm::dvec2 cursor(x, between(-50.0, 530.0, random));
        // Cursors have fractions: the way may be as short as a thousandth, or a millionth.
        if (i % 3 == 0) cursor = reference + (cursor - reference) * std::exp2(between(-30.0, -10.0, random));
        out.append("angle", as_row(ask<entered_angle>(out, reference, cursor)));
        // The same cursor about another reference point; one that is straight above it, or straight to the right.
        if (i % 4 != 0) continue;
        const glm::dvec2 other = cursor + glm::dvec2(between(3.0, 90.0, random), between(3.0, 90.0, random));
        for (const glm::dvec2& from : {other, {cursor.x, other.y}, {other.x, cursor.y}, {-other.x, -other.y}, {0, 0}})
            out.append("angle", as_row(ask<entered_angle>(out, from, cursor)));
    }
}

Image heart(Variation& vary, Recorder& out)
{
    const glm::vec3 eye = vary.near(heart_eye, 0.6F);
    return draw_heart(eye, [&](glm::ivec2 pixel, const SnapPlane& plane) {
        return ask<point_on_plane>(out, pixel, glm::ivec2(heart_size), heart_view(eye), heart_projection(), plane);
    });
}

}

const Driver driver = {
    {"pixels", [](Case& c, Recorder& out) { record_pixels(out, c.random); }},
    {"linear", [](Case& c, Recorder& out) { record_linear(c.vary, out); }},
    {"random linear",
     [](Case& c, Recorder& out) {
         record_random_linear(out, c.random);
         record_changed_linear(out, c.random);
     }},
    {"planes", [](Case& c, Recorder& out) { record_planes(c.vary, out); }},
    {"random planes", [](Case& c, Recorder& out) { record_random_planes(out, c.random); }},
    {"moves", [](Case& c, Recorder& out) { record_moves(out, c.random); }},
    {"views", [](Case& c, Recorder& out) { record_views(out, c.random); }},
    {"angles", [](Case& c, Recorder& out) { record_angles(c.vary, out); }},
    {"random angles", [](Case& c, Recorder& out) { record_random_angles(out, c.random); }},
    {"picture", [](Case& c, Recorder& out) { out.image("heart", heart(c.vary, out)); }},
};

}
