#include <algorithm>
#include <limits>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../volumes.hpp"
#include "cuts.hpp"
#include "panorama.hpp"

namespace umbral {
namespace {

using namespace projections;

constexpr float pi = std::numbers::pi_v<float>;
constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

// A row says whether there is an answer, and which.
glm::vec4 row_of(const std::optional<CurvedPoint>& seen)
{
    return seen ? glm::vec4(1, seen->place, seen->distance) : glm::vec4(0);
}

void name_columns(Recorder& out)
{
    for (const char* const name : {"sphere", "cylinder"}) out.columns(name, "is seen, place/2, distance");
}

void record(Recorder& out, const glm::vec3& point)
{
    name_columns(out);
    out.append("sphere", row_of(ask<spherical_projection>(out, point)));
    out.append("cylinder", row_of(ask<cylindrical_projection>(out, point)));
}

/// The point moved along each axis, if inputs are to vary: zeros keep their signs, and nothing comes farther away.
glm::vec3 varied(Variation& vary, const glm::vec3& point)
{
    constexpr std::array factors{0.5F, 0.625F, 0.75F, 0.875F};
    const auto factor = [&] { return vary.one_of(1.0F, factors); };
    return point * glm::vec3(factor(), factor(), factor());
}

// Lengths that are whole; the axes, the plane of the eye, straight behind with both zeros, and the eye itself.
void record_known(Variation& vary, Recorder& out)
{
    for (const glm::vec3& point : {glm::vec3(0, 0, -5),
                                   {3, 4, -12},
                                   {-2, 1, -2},
                                   {4, 2, 4},
                                   {-4, -2, 4},
                                   {6, 0, 0},
                                   {-3, 4, 0},
                                   {0, 2, -0.0F},
                                   {0, -7, 0},
                                   {0, 0, 3},
                                   {-0.0F, 1, 2},
                                   {-0.0F, 1, 0.5F},
                                   {0, 0, 0},
                                   {1, -1, -1},
                                   {0, 3, -4},
                                   {2, 3, 6}})
        record(out, varied(vary, point));
}

/// A point within 10 of the eye, in any direction.
glm::vec3 random_point(Random& random)
{
    const glm::vec3 direction = random.unit_vector();
    return random.uniform(0.1F, 10) * direction;
}

// A point that appears, and one that does not, in random order. Half of them lie a hair beside the plane of the eye.
void record_behind(Random& random, Recorder& out)
{
    name_columns(out);
    for (int i = 0; i < 30; ++i) {
        glm::vec3 before = random_point(random);
        before.z = -std::abs(before.z) - 0.01F;
        if (i % 4 % 3 == 0) before.z *= std::pow(10.0F, random.uniform(-9, -3));
        glm::vec3 behind = before * glm::vec3(1, 1, -1);
        if (i % 3 == 1) before.z = 0;
        if (i % 5 == 4) behind = glm::vec3(0);
        // Before and behind are no matter of how far.
        const float size = i % 4 == 2 ? 1e-5F : 1.0F;
        before *= size;
        behind *= size;
        const bool first = random.below(2) == 1;
        const float along = random.uniform(-9, 9);
        for (const bool is_behind : {first, !first}) {
            out.append("sphere", row_of(ask<spherical_projection>(out, is_behind ? behind : before)));
            const glm::vec3 axis(0, along, 0);
            out.append("cylinder", row_of(ask<cylindrical_projection>(out, is_behind ? axis : before)));
        }
    }
}

// Coordinates from 1e-35 to 1e37, whose squares are no floats; and points right beside the axis, down to a billionth.
void record_sizes(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        const float aside = i % 3 == 0 ? std::pow(10.0F, random.uniform(-9, -2)) : 1.0F;
        const float size = std::pow(10.0F, random.uniform(-34, 36));
        glm::vec3 point = size * random_point(random);
        if (size * aside < 1e-34F) point /= aside;
        point *= glm::vec3(aside, 1, aside);
        point.z = -std::abs(point.z);
        for (const bool on_sphere : {true, false}) {
            const std::optional<CurvedPoint> seen =
                on_sphere ? ask<spherical_projection>(out, point) : ask<cylindrical_projection>(out, point);
            const CurvedPoint answer = seen.value_or(CurvedPoint{glm::vec2(no_number), no_number});
            const std::string name = on_sphere ? "sphere" : "cylinder";
            out.append(name + " x", answer.place.x);
            out.append(name + " y", answer.place.y);
            out.append("distance", answer.distance);
        }
    }
}

void record_angle(Recorder& out, const glm::vec3& a, const glm::vec3& b)
{
    out.append("angle", ask<visual_angle>(out, a, b));
}

void record_known_angles(Variation& vary, Recorder& out)
{
    const glm::vec3 ahead(0, 0, -1);
    for (const glm::vec3& other :
         {glm::vec3(1, 0, 0), {0, 0, -7}, {0, 0, 2}, {1, 0, -1}, {0, -3, -3}, {0, 0, 0}, {-1, 0, 1}})
        record_angle(out, ahead, cross(ahead, other) == glm::vec3(0) ? other : vary.near(other, 0.3F));
    for (const float side : {1.0F, -1.0F}) record_angle(out, {0, 0, 0}, side * vary.near(glm::vec3(1, 2, 3), 0.3F));
    record_angle(out, {2, 0, 0}, vary.near(glm::vec3(1, 1.7320508F, 0), 0.3F));
}

// Two directions that differ by 1e-6 to 1e-3, or are as nearly opposite; of all sizes.
void record_small_angles(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        const glm::vec3 a = random.unit_vector();
        const glm::vec3 aside = std::pow(10.0F, random.uniform(-6, -3)) * random.unit_vector();
        const float size = std::pow(10.0F, random.uniform(-30, 30));
        record_angle(out, size * a, (i % 3 == 0 ? -1.0F : 1.0F) * (a + aside));
    }
}

// Far away, where rounding takes for nothing what an edge is seen under; and 64 times as far, before the same wall.
void record_far_cuts(Random& random, Recorder& out)
{
    for (int i = 0; i < 30; ++i) {
        const bool on_wall = i % 2 == 1;
        std::vector<glm::vec3> corners = random_triangles(2, random);
        for (glm::vec3& corner : corners) {
            corner = 0.125F * corner + glm::vec3(0, 0, -2048);
            if (on_wall) corner.z = -131072;
        }
        record_cut(out, corners, std::pow(10.0F, on_wall ? random.uniform(-5.9F, -5) : random.uniform(-4.2F, -3.2F)));
    }
}

/// In the plane of the seam, with either zero, or right beside it; behind the eye or before it, a metre away or a hair.
glm::vec3 beside_the_seam(Random& random)
{
    const float aside = random.below(2) == 0 ? 0 : std::pow(10.0F, random.uniform(-5, -3));
    const float x = random.below(2) == 0 ? aside : -aside;
    const glm::vec3 point(x, random.uniform(-1, 1), random.below(4) == 0 ? -1 : 1);
    return (random.below(2) == 0 ? 5e-5F : 1.0F) * point;
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        record(out, i % 3 == 0 ? beside_the_seam(random) : random_point(random));
        const glm::vec3 a = random_point(random);
        const glm::vec3 b = random_point(random);
        // One edge in five has an end in the eye.
        record_angle(out, i % 10 == 3 ? glm::vec3(0) : a, i % 10 == 8 ? glm::vec3(0) : b);
    }
    for (int i = 0; i < 24; ++i) {
        std::vector<glm::vec3> corners = random_triangles(1 + random.below(3), random);
        if (i % 4 == 1) corners = triangle_past_the_eye(random);
        if (i % 4 == 3) corners[random.below(2) + 1] = corners[0];
        record_cut(out, corners, random.uniform(0.3F, 2));
    }
}

void record_seam(Recorder& out, const std::array<float, 3>& angles)
{
    out.columns("angles", "first, second, third");
    const std::array<float, 3> moved = ask<without_seam>(out, angles);
    out.append("angles", glm::vec3(moved[0], moved[1], moved[2]));
}

// Nowhere near the seam, across it in both directions, and begun at each of the corners.
void record_known_seams(Variation& vary, Recorder& out)
{
    for (const std::array<float, 3>& angles : {std::array{0.0F, 1.0F, -1.0F},
                                               {3.0F, -3.0F, 2.5F},
                                               {-3.0F, 3.0F, -2.5F},
                                               {2.5F, 3.0F, -3.0F},
                                               {-3.0F, -3.0F, 3.0F},
                                               {3.0F, 3.1F, 2.9F},
                                               {pi, -pi, 3.0F},
                                               {1.5F, -1.5F, 0.0F},
                                               {0.0F, 2.5F, -2.5F},
                                               {-0.5F, -2.25F, 2.75F},
                                               {0.5F, 3.0F, -3.0F}}) {
        std::array<float, 3> moved = angles;
        for (float& angle : moved)
            if (std::abs(angle) != pi) angle = vary.near(angle, 0.03F);
        record_seam(out, moved);
    }
}

void record_random_seams(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        const auto angle = [&] { return random.uniform(-pi, pi); };
        const float first = angle();
        // One in four is nearly, or hardly more than, half a turn away.
        const float half = (first > 0 ? -pi : pi) * (1 + (random.below(2) == 0 ? 1e-5F : -1e-5F));
        const float second = i % 4 == 0 ? first + half : angle();
        record_seam(out, {first, second, angle()});
    }
}

void record_refused(Random& random, Recorder& out)
{
    for (int i = 0; i < 24; ++i) {
        const std::vector<glm::vec3> good = random_triangles(2, random);
        std::vector<glm::vec3> bad = good;
        constexpr std::array<std::size_t, 4> no_triangles{4, 1, 5, 2};
        bad.resize(no_triangles[static_cast<std::size_t>(i) / 4 % 4]);
        const float wrong[] = {0, -1, no_number};
        const std::vector<glm::vec3> list = i % 4 == 2 ? std::vector<glm::vec3>() : good;
        // Any angle above 0 will do.
        const float right = i % 4 == 3 ? std::numeric_limits<float>::infinity() : 1.0F;
        const bool first = random.below(2) == 1;
        for (const bool is_bad : {first, !first}) {
            const bool by_count = i % 4 == 0;
            record_refusal(out, "refused", [&] {
                return ask<tessellated>(out, is_bad && by_count ? bad : list,
                                        is_bad && !by_count ? wrong[i % 3] : right);
            });
        }
    }
}

// The hall all around the eye, rolled out, and below it in a fisheye lens: ahead, upwards, and down at a crate.
void draw_views(Variation& vary, Recorder& out)
{
    constexpr glm::ivec2 size(480, 326);
    constexpr int disc = 158;
    constexpr int strip = 164;
    const DoubleFrame frame(size.x, size.y, {0.05F, 0.05F, 0.07F});
    glEnable(GL_DEPTH_TEST);
    const gl::Program program({"hall.vert", hall_vertex_shader},
                              lit_fragment_shader("hall.frag", hall_fragment_shader));
    const std::vector<HallPart> hall = built_hall();
    const glm::vec3 eye = vary.near(glm::vec3(0.9F, 1.65F, 1.2F), 0.4F);

    ask_in_words(out,
                 [] { return "// every corner of the hall: tessellated(corners, 0.2), then cylindrical_projection"; });
    const float reach = pi * static_cast<float>(strip) / static_cast<float>(size.x);
    glViewport(0, 2 * (size.y - strip), 2 * size.x, 2 * strip);
    program.set("is_disc", 0);
    draw_hall(
        program, hall, hall_view(eye, vary.near(glm::vec3(-0.6F, 1.65F, -4), 0.8F)),
        [&](auto& vertices, auto corners, const auto& world) { add_to_panorama(vertices, corners, world, reach); });

    ask_in_words(out, [] { return "// the same in three directions, with spherical_projection"; });
    program.set("is_disc", 1);
    int column = 0;
    for (const glm::vec3& target : {glm::vec3(-5, 1.9F, -1.5F), {0.9F, 9, 1.2F}, {1.6F, 0.4F, -2}}) {
        glViewport(2 * column * (size.x - disc) / 2, 0, 2 * disc, 2 * disc);
        draw_hall(program, hall, hall_view(eye, vary.near(target, 0.4F)),
                  [&](auto& vertices, auto corners, const auto& world) { add_to_disc(vertices, corners, world); });
        ++column;
    }
    out.image("colours", frame.picture());
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"known angles", [](Case& c, Recorder& out) { record_known_angles(c.vary, out); }},
    {"known cuts", [](Case& c, Recorder& out) { record_known_cuts(c.vary, out); }},
    {"known seams", [](Case& c, Recorder& out) { record_known_seams(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"random seams", [](Case& c, Recorder& out) { record_random_seams(c.random, out); }},
    {"behind", [](Case& c, Recorder& out) { record_behind(c.random, out); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(c.random, out); }},
    {"sizes", [](Case& c, Recorder& out) { record_sizes(c.random, out); }},
    {"small angles", [](Case& c, Recorder& out) { record_small_angles(c.random, out); }},
    {"far cuts", [](Case& c, Recorder& out) { record_far_cuts(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { draw_views(c.vary, out); }},
};

}
