#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "any_frames.hpp"
#include "whirl.hpp"

namespace umbral {
namespace {

using namespace transforms;

const Frame world{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};

// Frames whose inverse a hand can find.
void record_known(Variation& vary, Recorder& out)
{
    // Another place, its vectors turned by quarters of a turn, which round nothing.
    const auto placed = [&](const Frame& frame) {
        const ExactMap map = vary.exact_map(0);
        return Frame{map.place(frame.x), map.place(frame.y), map.place(frame.z), by_quarters(vary, frame.origin)};
    };
    const Frame doubled = placed({{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 2, 3}});
    const Frame sheared = placed({{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 5, 0}});
    const Frame quarter = placed({{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {3, 4, 0}});
    const Frame cyclic = placed({{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {-1, -2, -3}});
    const Frame tilted = placed({{0.6F, 0.8F, 0}, {-0.8F, 0.6F, 0}, {0, 0, 1}, {10, 0, -5}});
    const Frame one_longer = placed({{0, 1, 0}, {-1, 0, 0}, {0, 0, 4}, {1, 0, 2}});
    // At the world's origin, but with vectors of its own: from there the displacement is to be turned all the same.
    Frame at_zero = placed({{0, 2, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, 0}});
    at_zero.origin = glm::vec3(0);
    for (const Frame& frame : {world, doubled, sheared, quarter, cyclic, tilted, one_longer, at_zero}) {
        out.append("matrix", ask<frame_matrix>(out, frame));
        out.append("inverse", ask<inverse_of_frame>(out, frame));
        for (const Frame& other : {world, doubled, quarter, sheared, one_longer, at_zero})
            out.append("between", ask<between_frames>(out, frame, other));
    }
    for (const Frame& frame : {quarter, cyclic, tilted}) out.append("cartesian", ask<inverse_of_cartesian>(out, frame));
}

void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        // Every third of each is nearly Cartesian. One in four stands at the world's origin, or both at one place.
        const glm::vec3 here = i % 4 == 1 ? glm::vec3(0) : 8.0F * random.in_cube();
        const glm::vec3 there = i % 4 == 2 ? glm::vec3(0) : i % 16 == 3 ? here : 8.0F * random.in_cube();
        Frame from = i % 3 == 0 ? nearly_cartesian(here, random) : oblique(here, random);
        Frame to = i % 3 == 1 ? nearly_cartesian(there, random) : oblique(there, random);
        Frame straight = cartesian(8.0F * random.in_cube(), random);
        // Turned about one axis only, as in a drawing: many coordinates are 0.
        if (i % 5 == 4) from = level(here, random.uniform(0.5F, 2), random);
        if (i % 7 == 6) to = level(there, random.uniform(0.5F, 2), random);
        if (i % 5 == 4) straight = level(straight.origin, 1, random);
        out.append("matrix", ask<frame_matrix>(out, from));
        out.append("inverse", ask<inverse_of_frame>(out, from));
        out.append("between", ask<between_frames>(out, from, to));
        out.append("cartesian", ask<inverse_of_cartesian>(out, straight));
    }
}

// From each frame to the one that comes of it by another length of one vector, or another origin: what is the same in
// both, or was the same in the question before, says nothing about the rest.
void record_related(Random& random, Recorder& out)
{
    Frame from{};
    for (int i = 0; i < 80; ++i) {
        if (i % 8 == 0) from = oblique(8.0F * random.in_cube(), random);
        Frame to = from;
        const std::uint32_t part = random.below(4);
        if (part < 3)
            axis_of(to, part) *= random.uniform(0.5F, 2) / length(axis_of(from, part));
        else
            to.origin = 8.0F * random.in_cube();
        out.append("related", ask<between_frames>(out, from, to));
        out.append("inverse", ask<inverse_of_frame>(out, to));
        from = to;
    }
}

// Cartesian frames that have been turned too often: half of them by less than the threshold of 1e-4 up to which they
// are still called Cartesian, others by as little and left-handed, or off by a thousandth. The transpose is the inverse
// no more.
void record_drifted(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 origin = 8.0F * random.in_cube();
        const Frame frame = drifted(origin, i % 4 == 0 ? 2e-3F : 4e-5F, i % 4 == 1, random);
        out.append("inverse", ask<inverse_of_frame>(out, frame));
        const Frame other = oblique(8.0F * random.in_cube(), random);
        out.append("between", ask<between_frames>(out, other, frame));
    }
}

// Pairs of a right-handed frame and a left-handed one, in random order, of all sizes, one in five with one vector that
// is smaller than what floats hold with all their digits; the slides' criterion for the plane says 0 = 0 for the first.
void record_orientation(Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        Frame frame = i == 0 ? Frame{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, 0}} : oblique({0, 0, 0}, random);
        for (glm::vec3* axis : {&frame.x, &frame.y, &frame.z}) *axis *= i < 20 ? 1.0F : i < 40 ? 1e-10F : 1e10F;
        glm::vec3& one = axis_of(frame, random.below(3));
        if (i % 3 == 2 && (i < 20 || i >= 40)) one = 0x1p-130F * normalize(one);
        frame.origin = any_origin(frame, random);
        Frame other = frame;
        std::swap(i % 2 == 0 ? other.x : other.z, other.y);
        const bool swapped = random.below(2) == 1;
        out.append("sign", ask<orientation>(out, swapped ? other : frame));
        out.append("sign", ask<orientation>(out, swapped ? frame : other));
    }
}

void record_kind(Recorder& out, const Frame& frame)
{
    out.columns("kind", "kind (0: degenerate; 1: oblique; 2: orthogonal; 3: orthonormal; 4: cartesian)");
    out.append("kind", static_cast<std::int32_t>(ask<classify_frame>(out, frame)));
}

// All five, of all sizes: a volume of 1e-14 is not 0, and squares of lengths may be no floats. Oblique ones of which
// one pair of vectors leans, and orthogonal ones of which one vector is not unit, beside those of which all do and are;
// some have the volume 1, or one vector of 2^-130. Where the frame stands says nothing of its kind.
void record_kinds(Variation& vary, Random& random, Recorder& out)
{
    const glm::vec3 origin(0);
    for (const int i : numbers(vary, 120)) {
        const int kind = i % 5;
        const int variant = i / 5;
        Frame frame = cartesian(origin, random);
        const Frame skew = oblique(origin, random);
        const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
        const std::uint32_t one = random.below(3);
        if (kind == 0 && variant % 2 == 0) frame = skew;
        if (kind == 0 && variant % 2 == 1) axis_of(frame, one) += 0.3F * sign * axis_of(frame, (one + 1) % 3);
        if (kind == 1 && variant % 4 == 0) frame.x *= 1.5F, frame.z *= 0.01F;
        if (kind == 1 && variant % 4 == 2) stretch(frame, one, std::array{2.0F, 1.01F, 1.5F}.at(random.below(3)));
        if (kind == 1 && variant % 2 == 1) axis_of(frame, one) *= random.below(2) == 0 ? 1.5F : 0.75F;
        const float size = std::array{1.0F, 1e-4F, 1e-25F, 1e25F}.at(static_cast<std::size_t>(variant / 2 % 4));
        if (kind == 0 || (kind == 1 && variant % 4 == 0))
            for (glm::vec3* axis : {&frame.x, &frame.y, &frame.z}) *axis *= size;
        if (kind < 2 && variant % 8 == 1) axis_of(frame, one) *= 0x1p-130F;
        if (kind == 2 && variant % 2 == 0) axis_of(frame, one) = glm::vec3(0);
        if (kind == 2 && variant % 2 == 1) frame.x.y = frame.y.y = frame.z.y = 0;
        if (sign < 0) frame.y = -frame.y;
        // As far off as a long chain of turns leaves a frame.
        if (kind > 2) frame.x *= 1.00001F;
        frame.origin = any_origin(frame, random);
        record_kind(out, frame);
    }
}

// On both sides of the thresholds of 1e-4, in pairs, in random order: cosines of 0.5e-4 … 0.85e-4 and of 1.2e-4 … 2e-4,
// also where one of the two vectors is long or short, and lengths that are as far from 1; of half of these another
// vector is as much shorter as one is longer, so that the volume is 1.
void record_thresholds(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        Frame frame = cartesian({0, 0, 0}, random);
        frame.origin = any_origin(frame, random);
        const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
        const bool first = random.below(2) == 1;
        for (const bool beyond : {first, !first}) {
            Frame other = frame;
            const float off = sign * 1e-4F * (beyond ? random.uniform(1.2F, 2) : random.uniform(0.5F, 0.85F));
            glm::vec3& axis = i % 3 == 0 ? other.x : i % 3 == 1 ? other.y : other.z;
            glm::vec3& next = i % 3 == 0 ? other.y : i % 3 == 1 ? other.z : other.x;
            if (i % 2 == 0)
                axis *= 1.0F + off, next *= i % 4 == 0 ? 1.0F - off : 1.0F;
            else
                axis += off * next;
            if (i % 8 == 3) axis *= 8.0F;
            if (i % 8 == 5) next *= 8.0F;
            if (i % 8 == 7) next *= 0.125F;
            record_kind(out, other);
        }
    }
}

// z = x + y, exactly, so that the frame is degenerate; and the same a unit in the last place above or below, which
// changes the volume by 2^-69 where x and y are nearly parallel. As small and as large as floats are, and in between.
void record_coplanar(Variation& vary, Random& random, Recorder& out)
{
    for (const int i : numbers(vary, 180)) {
        if (i >= 120) {
            const Frame frame = i < 140 ? nearly_flat(i % 2 == 0, random) : layered(i % 4 == 0, random);
            out.append("sign", ask<orientation>(out, frame));
            record_kind(out, frame);
            continue;
        }
        Frame frame = world;
        for (int k = 0; k < 3; ++k) {
            frame.x[k] = full_number(random);
            frame.y[k] = full_number(random);
        }
        const int off = i / 8 % 3;
        if (i % 8 > 3) make_nearly_parallel(frame, (off + 1) % 3, (off + 2) % 3);
        frame.z = frame.x + frame.y;
        if (i % 2 != 0) frame.z[off] += i % 4 == 1 ? 0x1p-23F : -0x1p-23F;
        // Powers of two round nothing, also where the vectors have different ones.
        const auto size = [&](int every) {
            return std::array{1.0F, 0x1p-103F, 0x1p126F}.at(static_cast<std::size_t>(i / every % 3));
        };
        frame.x *= size(1);
        frame.y *= size(i < 60 ? 1 : 3);
        frame.z *= size(i < 60 ? 1 : 9);
        out.append("sign", ask<orientation>(out, frame));
        record_kind(out, frame);
    }
}

// y leans onto x until they are 1e-2 … 1e-6 apart. Most origins have small coordinates in their frame, for which large
// numbers cancel; the world's origin has the same, with the other sign.
void record_ill_conditioned(Random& random, Recorder& out)
{
    for (const float apart : {1e-2F, 1e-3F, 1e-4F, 1e-5F, 1e-6F}) {
        for (int i = 0; i < 12; ++i) {
            Frame frame = cartesian(random.in_cube(), random);
            frame.y = frame.x + apart * frame.y;
            const glm::vec3 inside = 4.0F * random.in_cube();
            if (i % 4 != 0) frame.origin = inside.x * frame.x + inside.y * frame.y + inside.z * frame.z;
            out.append("inverse", ask<inverse_of_frame>(out, frame));
        }
    }
}

// Vectors of 1e-14 … 1e-9, and as many of 1e9 … 1e14: the volume may be no float, and is not 0.
void record_units(Random& random, Recorder& out)
{
    for (int i = 0; i < 24; ++i) {
        Frame frame = oblique(random.in_cube(), random);
        const float size = std::pow(10.0F, (i % 2 == 0 ? 1.0F : -1.0F) * random.uniform(9.5F, 14));
        for (glm::vec3* axis : {&frame.x, &frame.y, &frame.z}) *axis *= size;
        out.append("inverse", ask<inverse_of_frame>(out, frame));
    }
}

// Two frames a few steps from each other, or the same but for a thousandth in all vectors or in one, as far from the
// world's origin as a town, a country or a planet is wide in metres. Half of the Cartesian ones have drifted by less
// than what classify_frame forgives, and may be left-handed.
void record_far(Random& random, Recorder& out)
{
    for (const float far : {1e4F, 1e5F, 1e6F, 1e7F}) {
        for (int i = 0; i < 20; ++i) {
            const glm::vec3 here = far * random.unit_vector();
            const glm::vec3 there = here + 8.0F * random.unit_vector();
            const Frame from = oblique(here, random);
            Frame to = i % 4 == 0   ? cartesian(there, random)
                       : i % 4 == 2 ? drifted(there, 4e-5F, i % 8 == 2, random)
                                    : oblique(there, random);
            if (i % 4 == 3) {
                to = from;
                const std::uint32_t one = random.below(3);
                for (std::uint32_t axis = 0; axis < 3; ++axis) {
                    const glm::vec3 aside = 1e-3F * random.unit_vector();
                    if (i % 8 == 3 || axis == one) axis_of(to, axis) += aside;
                }
            }
            out.append("between", ask<between_frames>(out, from, to));
        }
    }
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"random",
     [](Case& c, Recorder& out) {
         record_random(c.random, out);
         record_related(c.random, out);
     }},
    {"drifted", [](Case& c, Recorder& out) { record_drifted(c.random, out); }},
    {"orientation", [](Case& c, Recorder& out) { record_orientation(c.random, out); }},
    {"kinds", [](Case& c, Recorder& out) { record_kinds(c.vary, c.random, out); }},
    {"thresholds", [](Case& c, Recorder& out) { record_thresholds(c.random, out); }},
    {"nearly in a plane", [](Case& c, Recorder& out) { record_coplanar(c.vary, c.random, out); }},
    {"ill-conditioned", [](Case& c, Recorder& out) { record_ill_conditioned(c.random, out); }},
    {"other units", [](Case& c, Recorder& out) { record_units(c.random, out); }},
    {"far away", [](Case& c, Recorder& out) { record_far(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("whirl", draw_whirl(c.vary, out)); }},
};

}
