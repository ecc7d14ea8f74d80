#include <cmath>
#include <kit/magnitude.hpp>
#include <numbers>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "tree.hpp"

namespace umbral {
namespace {

using namespace transforms;

constexpr float pi = std::numbers::pi_v<float>;

glm::vec2 in_square(Random& random)
{
    const float x = random.uniform(-8, 8);
    return {x, random.uniform(-8, 8)};
}

/// A Cartesian frame of the plane, or, if it is `left_handed`, its mirror image.
PlaneFrame random_frame(bool left_handed, Random& random)
{
    const double angle = double{random.uniform(-pi, pi)};
    const glm::vec2 x(std::cos(angle), std::sin(angle));
    const glm::vec2 y = (left_handed ? -1.0F : 1.0F) * glm::vec2(-x.y, x.x);
    return {x, y, in_square(random)};
}

/// Axes along those of the world, in one of their four places: products of their coordinates are 0 there, and say
/// nothing about the hand.
PlaneFrame quarter_frame(bool left_handed, Random& random)
{
    const glm::vec2 places[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const glm::vec2 x = places[random.below(4)];
    const glm::vec2 y = (left_handed ? -1.0F : 1.0F) * glm::vec2(-x.y, x.x);
    return {x, y, in_square(random)};
}

/// One in four along the world's axes.
PlaneFrame some_frame(bool left_handed, Random& random)
{
    return random.below(4) == 0 ? quarter_frame(left_handed, random) : random_frame(left_handed, random);
}

/// One in four on an axis.
glm::vec2 some_vector(Random& random)
{
    glm::vec2 u = in_square(random);
    if (random.below(4) == 0) u[static_cast<int>(random.below(2))] = 0;
    return u;
}

/// Any; one in four small, of either sign.
float some_angle(Random& random)
{
    const float small = std::pow(10.0F, random.uniform(-5, -1)) * (random.below(2) == 0 ? 1.0F : -1.0F);
    const float any = random.uniform(-pi, pi);
    return random.below(4) == 0 ? small : any;
}

void record_space(const glm::vec3& e, const glm::vec3& u, Recorder& out)
{
    out.append("across", ask<across>(out, e, u));
    out.append("across matrix", ask<across_matrix>(out, e));
}

void record_known(Variation& vary, Recorder& out)
{
    const auto other = [&](float x, float y) { return vary.near(glm::vec2(x, y), 0.4F); };
    const PlaneFrame shifted{{1, 0}, {0, 1}, other(2, 1)};
    const PlaneFrame turned{{0.6F, 0.8F}, {-0.8F, 0.6F}, other(0, 5)};
    const PlaneFrame mirrored{{0, 1}, {1, 0}, other(-1, 2)};
    const glm::vec2 to_the_left(-vary.scaled(3.0F, 1.5F), 0);
    const glm::vec2 downwards(0, -vary.scaled(2.0F, 1.5F));
    for (const glm::vec2& u :
         {other(1, 0), other(0, 1), other(3, 4), other(-2, 5), glm::vec2(0, 0), to_the_left, downwards}) {
        // Of any size: nothing rounds.
        for (const float size : {1.0F, 1e-12F, 1e30F}) {
            out.append("left", ask<turn_left>(out, size * u));
            out.append("right", ask<turn_right>(out, size * u));
        }
        // The mirrored one first: in the two others the answer is the same, and who gives it for the mirrored one as
        // well should not hear that it is the answer to the question before.
        for (const PlaneFrame& frame : {mirrored, shifted, turned}) {
            out.append("in a frame", ask<turn_vector_in>(out, frame, u));
            out.append("point", ask<turn_point_in>(out, frame, u));
        }
        for (const float angle : {pi / 2, pi / 6, -pi / 4, pi, 0.0F})
            out.append("rotated", ask<rotate_in_plane>(out, u, vary.near(angle, 0.1F)));
    }
    for (const float angle : {pi / 2, pi / 6, -pi / 4, pi, 0.0F, 50 * pi / 180})
        out.append("matrix", ask<plane_rotation_matrix>(out, vary.near(angle, 0.1F)));
    // Turned by quarters of a turn, which round nothing.
    const auto record_turned = [&](const glm::vec3& e, const glm::vec3& v) {
        const ExactMap map = vary.exact_map(1);
        record_space(map.place(e), map.place(v), out);
    };
    record_turned({0, 0, 1}, {1, 0, 0});
    record_turned({1, 0, 0}, {0, 2, 0});
    record_turned({1, 2, 3}, {4, 5, 6});
    record_turned({0, 0.25F, 0}, {1, 2, 3});
    record_turned({1, 2, 3}, {2, 4, 6});
    record_turned({0, 0, 0}, {1, 2, 3});
    record_turned({3, 2, 1}, {0, 0, 0});
    // Exactly parallel, though products of their components round.
    record_turned({1234.567F, -765.4321F, 87.654F}, {2469.134F, -1530.8642F, 175.308F});
    record_turned({1234.567F, -765.4321F, 87.654F}, {-1234.567F, 765.4321F, -87.654F});
}

/// In any unit, which is taken away again from what is recorded. One `u` in four is nearly parallel to `e`; one `e` in
/// eight is null.
void record_random_space(int i, Random& random, Recorder& out)
{
    const glm::vec3 any = random.uniform(0.05F, 3) * random.unit_vector();
    const glm::vec3 e = i % 8 == 5 ? glm::vec3(0) : any;
    const float lean = random.uniform(0.002F, 0.03F);
    const glm::vec3 beside = random.uniform(-2, 2) * any + lean * random.unit_vector();
    const glm::vec3 u = i % 4 == 2 ? beside : 3.0F * random.in_cube();
    const float unit = random_unit(random, -59, 57);
    out.append("across", ask<across>(out, unit * e, u) / unit);
    out.append("across matrix", ask<across_matrix>(out, unit * e) / unit);
}

void record_random(Random& random, Recorder& out)
{
    float angle = 0;
    for (int i = 0; i < 150; ++i) {
        const glm::vec2 u = some_vector(random);
        const float unit = random_unit(random, -100, 100);
        out.append("left", ask<turn_left>(out, unit * u));
        out.append("right", ask<turn_right>(out, unit * u));
        PlaneFrame frame = some_frame(i % 3 == 0, random);
        frame.origin *= unit;
        out.append("point", ask<turn_point_in>(out, frame, unit * u) / unit);
        // Every fourth angle is nearly the one before.
        angle = i % 4 == 3 ? angle + random.uniform(-1e-3F, 1e-3F) : some_angle(random);
        out.append("rotated", ask<rotate_in_plane>(out, unit * u, angle) / unit);
        out.append("matrix", ask<plane_rotation_matrix>(out, angle));
        record_random_space(i, random, out);
    }
}

// Pairs of a right-handed frame, where the frame does not matter, and a left-handed one, where it does; in random
// order.
void record_hands(Random& random, Recorder& out)
{
    for (int i = 0; i < 80; ++i) {
        const glm::vec2 u = in_square(random);
        const bool first = random.below(2) == 1;
        for (const bool left_handed : {first, !first})
            out.append("in a frame", ask<turn_vector_in>(out, some_frame(left_handed, random), u));
    }
}

// Both sides of R(a)·R(b) = a·b and |R(a)| = |a| as the student's vectors have them.
void record_kept(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        const float angle = random.uniform(-pi, pi);
        const glm::dvec2 a(ask<rotate_in_plane>(out, in_square(random), angle));
        out.append("length", length(a));
        const glm::dvec2 b(ask<rotate_in_plane>(out, in_square(random), angle));
        out.append("dot", dot(a, b));
    }
}

void record_many_turns(Random& random, Recorder& out)
{
    for (const float angle : {2 * pi, 100.0F, -1e3F, 1e4F, -1e6F}) {
        for (int i = 0; i < 8; ++i) {
            const glm::vec2 u = in_square(random);
            out.append("rotated", ask<rotate_in_plane>(out, u, angle * random.uniform(0.9F, 1)));
            out.append("matrix", ask<plane_rotation_matrix>(out, angle * random.uniform(0.9F, 1)));
        }
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"either hand", [](Case& c, Recorder& out) { record_hands(c.random, out); }},
    {"kept", [](Case& c, Recorder& out) { record_kept(c.random, out); }},
    {"many turns", [](Case& c, Recorder& out) { record_many_turns(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("tree", draw_tree(c.vary, out)); }},
};

}
