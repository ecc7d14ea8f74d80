#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <umbral/projections/frustum.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../island.hpp"
#include "../volumes.hpp"

namespace umbral {
namespace {

using namespace projections;

constexpr float infinity = std::numeric_limits<float>::infinity();

void record(Recorder& out, const ViewVolume& volume)
{
    out.append("matrix", ask<frustum_matrix>(out, volume));
    const FrustumFactors factors = ask<frustum_factors>(out, volume);
    out.append("shear", factors.shear);
    out.append("scaling", factors.scaling);
    out.append("normalization", factors.normalization);
}

void record_point(Recorder& out, const glm::mat4& projection, const glm::vec3& point)
{
    const std::optional<glm::vec3> seen = ask<project_point>(out, projection, point);
    out.append("ndc x", seen ? std::optional(seen->x) : std::nullopt);
    out.append("ndc y", seen ? std::optional(seen->y) : std::nullopt);
    out.append("ndc depth", seen ? std::optional(seen->z) : std::nullopt);
}

// Windows of side 2 at the near plane, one that is not symmetric, the one of the course's cube of side 2, and the near
// plane behind the far one.
void record_known(Variation& vary, Recorder& out)
{
    const ViewVolume volumes[] = {
        {-1, 1, -1, 1, 1, 3}, {0, 4, -1, 1, 2, 6}, {-1, 1, -1, 1, 3, 5}, {2, 6, -5, -1, 4, 8}, {2, 6, -5, -1, 8, 4}};
    for (const ViewVolume& volume : volumes) record(out, varied(vary, volume));
}

glm::mat4 given_matrix(const ViewVolume& v)
{
    return glm::frustum(v.left, v.right, v.bottom, v.top, v.near_plane, v.far_plane);
}

// The matrix is not the student's, so that a wrong one does not hide a wrong division.
void record_known_points(Variation& vary, Recorder& out)
{
    const glm::mat4 perspective = given_matrix(varied(vary, {-1, 1, -1, 1, 1, 3}));
    for (const glm::vec3& point : {glm::vec3(0, 0, -1),
                                   {0, 0, -3},
                                   {1, 1, -1},
                                   {3, -3, -3},
                                   {1, -0.5F, -2},
                                   {4, 0, -2},
                                   {0, 1, -0.5F},
                                   {0, 0, -12}})
        record_point(out, perspective, vary.near(point, 0.2F));
    const glm::mat4 flat = glm::ortho(-2.0F, 2.0F, -1.0F, 1.0F, 1.0F, 9.0F);
    for (const glm::vec3& point : {glm::vec3(1, 0.5F, -5), {-2, 1, -9}, {1, 1, 7}})
        record_point(out, flat, vary.near(point, 0.2F));
}

ViewVolume resized(const ViewVolume& v, float size)
{
    return {size * v.left, size * v.right, size * v.bottom, size * v.top, size * v.near_plane, size * v.far_plane};
}

/// Every third time a frustum a thousand million times as large, or as small, at most.
ViewVolume frustum_of_any_size(int kind, Random& random)
{
    const ViewVolume v = random_frustum(random);
    const float size = kind % 3 == 0 ? std::ldexp(1.0F, static_cast<int>(random.below(61)) - 30) : 1.0F;
    return resized(v, size);
}

/// The same; some are mirrored in any way, and of some the middle of the window is up to five times as far off the axis
/// as off the eye.
ViewVolume frustum_of_any_form(int kind, Random& random)
{
    ViewVolume v = with_sides_exchanged(frustum_of_any_size(kind, random), kind % 5 < 2 ? 1 + random.below(7) : 0);
    if (kind % 4 != 1) return v;
    const glm::vec2 aside = 4 * v.near_plane * glm::vec2(random.in_cube());
    return {v.left + aside.x, v.right + aside.x, v.bottom + aside.y, v.top + aside.y, v.near_plane, v.far_plane};
}

/// The same but for one of its six numbers, which moves away from that of the opposite side.
ViewVolume with_one_changed(ViewVolume v, int which, Random& random)
{
    float* const numbers[] = {&v.left, &v.right, &v.bottom, &v.top, &v.near_plane, &v.far_plane};
    float& changed = *numbers[which];
    const float opposite = *numbers[which ^ 1];
    if (which < 4) {
        changed += random.uniform(0.2F, 1) * (changed - opposite);
    } else {
        const float factor = random.uniform(0.5F, 0.9F);
        changed = changed < opposite ? changed * factor : changed / factor;
    }
    return v;
}

// Every second frustum differs from the one before in one number.
void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 50; ++i) {
        const ViewVolume volume = frustum_of_any_form(i, random);
        record(out, volume);
        record(out, with_one_changed(volume, i % 6, random));
    }
}

// A point of the frustum, or beside it.
glm::vec3 point_before_the_eye(const ViewVolume& v, Random& random)
{
    const float distance = v.near_plane * std::pow(v.far_plane / v.near_plane, random.uniform(-0.2F, 1.2F));
    const float x = glm::mix(v.left, v.right, random.uniform(-0.5F, 1.5F));
    const float y = glm::mix(v.bottom, v.top, random.uniform(-0.5F, 1.5F));
    return {x * distance / v.near_plane, y * distance / v.near_plane, -distance};
}

// A point before the eye, and one behind it or in its plane, in random order; some are as close to it as floats are:
// the last ones nearer than the least float of all digits, before a frustum so small that depth is a float.
void record_behind(Random& random, Recorder& out)
{
    for (int i = 0; i < 50; ++i) {
        const bool tiny = i % 5 == 4;
        const ViewVolume volume = resized(random_frustum(random), tiny ? 0x1p-26F : 1);
        const glm::mat4 projection = given_matrix(volume);
        const float close[] = {1e-2F, 1e-3F, 1e-6F, 1e-12F, 1e-30F};
        glm::vec3 before = point_before_the_eye(volume, random);
        if (tiny) before *= -volume.near_plane / before.z;
        glm::vec3 behind = -before;
        if (i % 5 == 1) behind.z = 0;
        if (i % 5 == 2) behind = glm::vec3(0);
        if (i % 5 > 2) {
            before.z = tiny ? -std::ldexp(random.uniform(0.5F, 1), -128 - i / 5) : -close[i / 5 % 5];
            behind = glm::vec3(before.x, before.y, -before.z);
        }
        const bool first = random.below(2) == 1;
        for (const bool is_behind : {first, !first}) record_point(out, projection, is_behind ? behind : before);
    }
}

// Near and far exchanged comes with the others: depths in the opposite order.
void record_mirrored(Random& random, Recorder& out)
{
    for (unsigned i = 0; i < 70; ++i) record(out, with_sides_exchanged(random_frustum(random), 1 + i % 7));
}

void record_infinite(Random& random, Recorder& out)
{
    for (unsigned i = 0; i < 30; ++i) {
        ViewVolume volume = with_sides_exchanged(random_frustum(random), i % 4);
        volume.far_plane = infinity;
        record(out, volume);
    }
}

// A frustum, and something that is none, in random order: every second time a frustum that is almost none. Later both
// are without end, unless it is the far plane that is wrong.
void record_refused(Random& random, Recorder& out)
{
    constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
    for (int i = 0; i < 36; ++i) {
        ViewVolume good = random_frustum(random);
        ViewVolume bad = good;
        ViewVolume close = good;
        switch (i % 9) {
            case 0:
                bad.right = bad.left;
                close.right = next_above(bad.left);
                break;
            case 1:
                bad.top = bad.bottom;
                close.top = next_above(bad.bottom);
                break;
            case 2:
                bad.far_plane = bad.near_plane;
                close.far_plane = next_above(bad.near_plane);
                break;
            case 3:
                bad.near_plane = 0;
                close.near_plane = 1e-30F;
                break;
            case 4: bad.near_plane = -bad.near_plane; break;
            case 5:
                bad.far_plane = 0;
                close.far_plane = 1e-30F;
                break;
            case 6: bad.far_plane = i < 18 ? -bad.far_plane : -infinity; break;
            case 7: bad.near_plane = not_a_number; break;
            default: bad.far_plane = not_a_number;
        }
        if (i / 9 % 2 == 1) good = close;
        const bool far_is_right = bad.far_plane == good.far_plane;
        if (i >= 18 && far_is_right) good.far_plane = bad.far_plane = infinity;
        const bool first = random.below(2) == 1;
        for (const bool is_bad : {first, !first}) {
            const ViewVolume& asked = is_bad ? bad : good;
            record_refusal(out, "refused", [&] { return ask<frustum_matrix>(out, asked); });
            record_refusal(out, "factors refused", [&] { return ask<frustum_factors>(out, asked); });
        }
    }
}

// The far plane 10^5 to 10^7 times as far as the near one; nearly as far as a float can be; or right behind. And frusta
// 10^30 times as large, or as small: the product of the planes is no float.
void record_ratios(Random& random, Recorder& out)
{
    for (int i = 0; i < 80; ++i) {
        ViewVolume volume = random_frustum(random);
        switch (i % 4) {
            case 0: volume.far_plane = std::numeric_limits<float>::max() * random.uniform(0.9F, 1); break;
            case 1: volume.far_plane = volume.near_plane * (1 + std::pow(10.0F, random.uniform(-5, -2))); break;
            case 2: volume.far_plane = volume.near_plane * std::pow(10.0F, random.uniform(5, 7)); break;
            default:
                const int exponent = 98 + static_cast<int>(random.below(12));
                volume = resized(volume, std::ldexp(1.0F, i % 3 == 0 ? -exponent : exponent));
        }
        record(out, volume);
    }
}

// A window whose width and height are a thousandth to a hundred-thousandth of its distance from the axis: a tile of a
// picture much larger.
void record_narrow(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        ViewVolume volume = random_frustum(random);
        const auto narrow = [&](float& low, float& high, bool below) {
            const float aside = random.uniform(2, 5) * volume.near_plane;
            low = below ? -aside : aside;
            high = low + aside * std::pow(10.0F, random.uniform(-5, -3));
        };
        narrow(volume.left, volume.right, i % 2 == 0);
        narrow(volume.bottom, volume.top, i / 2 % 2 == 0);
        record_point(out, given_matrix(volume), point_before_the_eye(volume, random));
    }
}

// A wall of six monitors, each with a frustum of its own: together they are a window into one world.
void draw_wall(Variation& vary, Recorder& out)
{
    constexpr glm::ivec2 size(384, 256);
    constexpr int columns = 3;
    constexpr int rows = 2;
    constexpr int frame = 6;  // of a monitor, in pixels of the picture drawn at twice its size
    constexpr glm::vec3 sky(0.56F, 0.75F, 0.91F);
    const Stage stage(size.x, size.y, {0.07F, 0.07F, 0.09F});
    const Island island;
    const glm::mat4 view =
        glm::lookAt(vary.near(glm::vec3(4.6F, 3.9F, 8.2F), 1.2F), glm::vec3(0.1F, 0.75F, 0), glm::vec3(0, 1, 0));

    // The wall in the plane z = -0.5 of the eye, which is not before its middle.
    const glm::vec2 low(-0.33F, -0.265F);
    const glm::vec2 per_pixel(0.62F / static_cast<float>(2 * size.x));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::ivec2 corner = glm::ivec2(column, row) * 2 * size / glm::ivec2(columns, rows) + frame;
            const glm::ivec2 extent = 2 * size / glm::ivec2(columns, rows) - 2 * frame;
            const glm::vec2 from = low + per_pixel * glm::vec2(corner);
            const glm::vec2 to = from + per_pixel * glm::vec2(extent);
            begin_panel(corner, extent, sky);
            look_through(stage, view, ask<frustum_matrix>(out, {from.x, to.x, from.y, to.y, 0.5F, 40}));
            island.draw_at_sea(stage, sky);
        }
    out.image("colours", stage.picture());
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"known points", [](Case& c, Recorder& out) { record_known_points(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"random points",
     [](Case& c, Recorder& out) {
         for (int i = 0; i < 100; ++i) {
             const ViewVolume volume = frustum_of_any_size(i, c.random);
             record_point(out, given_matrix(volume), point_before_the_eye(volume, c.random));
         }
     }},
    {"mirrored", [](Case& c, Recorder& out) { record_mirrored(c.random, out); }},
    {"behind", [](Case& c, Recorder& out) { record_behind(c.random, out); }},
    {"infinite", [](Case& c, Recorder& out) { record_infinite(c.random, out); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(c.random, out); }},
    {"ratios", [](Case& c, Recorder& out) { record_ratios(c.random, out); }},
    {"narrow", [](Case& c, Recorder& out) { record_narrow(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { draw_wall(c.vary, out); }},
};

}
