#include <algorithm>
#include <cmath>
#include <kit/varied.hpp>
#include <limits>
#include <umbral/core/random.hpp>
#include <umbral/record/driver.hpp>

#include "floors.hpp"

namespace umbral {
namespace {

using namespace pipeline;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Rows of one number, or nothing: doubles have no table of their own for that. A relative error is one of the row's
// largest number, so what says that there is something is 0.
void append(Recorder& out, const char* name, const std::optional<double>& value)
{
    out.columns(name, "nothing, distance");
    out.append(name, value ? glm::dvec2(0, *value) : glm::dvec2(1, 0));
}

// Infinity is no number that a check can compare with.
void append_eye(Recorder& out, double z_eye)
{
    out.columns("eye", "infinite, z_eye");
    out.append("eye", std::isinf(z_eye) ? glm::dvec2(std::copysign(1, z_eye), 0) : glm::dvec2(0, z_eye));
}

/// Planes that are written down, moved.
DepthRange varied(Variation& vary, double near_plane, double far_plane)
{
    return {vary.scaled(near_plane, 1.5F), vary.scaled(far_plane, 1.3F)};
}

// The course's cameras, and one that a hand can work out: n = 1, f = 3.
void record_by_hand(Variation& vary, Recorder& out)
{
    for (const auto& [near_plane, far_plane] : {std::pair(1.0, 3.0), {0.2, 400.0}, {0.01, 1000.0}, {2.0, infinity}})
        for (const double written : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0}) {
            const auto [n, f, as_usual] = varied(vary, near_plane, far_plane);
            const double part = written == 0 || written == 1 ? written : vary.near(written, 0.08);
            const double distance = std::isinf(f) ? n / (1.0 - 0.9 * part) : std::min(f, n + part * (f - n));
            for (const bool reversed : {false, true}) {
                out.append("ndc", ask<ndc_depth>(out, {n, f, reversed}, -distance));
                out.append("window", ask<window_depth>(out, {n, f, reversed}, -distance));
            }
        }
}

void record_codes(Variation& vary, Recorder& out)
{
    for (const int bits : {1, 2, 8, 16, 24, 32}) {
        const std::vector depths{0.0,
                                 1.0,
                                 0.5,
                                 vary.near(0.49, 0.005),
                                 vary.near(0.51, 0.005),
                                 vary.near(0.31, 0.1),
                                 vary.near(0.70001, 0.1),
                                 vary.near(1.0 / 3, 0.1),
                                 vary.scaled(1e-3, 3),
                                 vary.near(0.999, 0.0008),
                                 -2.0,
                                 1.5};
        for (const double depth : in_random_order(vary, depths)) out.append("codes", ask<depth_code>(out, depth, bits));
    }
}

// The course's four codes first.
void record_back(Variation& vary, Recorder& out)
{
    for (const auto& [near_plane, far_plane] : {std::pair(0.2, 400.0), {0.01, 1000.0}, {1.0, 3.0}})
        for (const std::uint32_t code : {1U, 65534U, 0U, 65535U, vary.near(32768U, 9000U), vary.near(52454U, 9000U)})
            for (const bool reversed : {false, true}) {
                const auto [n, f, as_usual] = varied(vary, near_plane, far_plane);
                append_eye(out, ask<eye_depth>(out, {n, f, reversed}, code, 16));
            }
    for (const std::uint32_t code : {0U, 1U, vary.near(127U, 90U), 254U, 255U})
        for (const bool reversed : {false, true}) {
            const double n = vary.scaled(0.5, 2);
            append_eye(out, ask<eye_depth>(out, {n, infinity, reversed}, reversed ? 255 - code : code, 8));
        }
}

struct Camera {
    DepthRange range;
    double distance;
    int bits;
};

/// One in five without a far plane, one in ten with planes close together; 1 to 32 bits; lengths in any unit. Other far
/// planes are up to 2^`most` times as far as near ones.
Camera random_camera(Random& random, double most = 16)
{
    const double n = std::exp2(-40 + 60 * random.uniform_double());
    const std::uint32_t kind = random.below(10);
    const double part = random.uniform_double();
    const double range = kind < 2 ? 40 : kind == 2 ? std::exp2(-1 - 7 * part) : 1 + (most - 1) * part;
    const double f = kind < 2 ? infinity : n * std::exp2(range);
    const double distance = n * std::exp2(range * (0.02 + 0.96 * random.uniform_double()));
    const bool reversed = random.below(2) == 0;
    return {{n, f, reversed}, distance, 1 + static_cast<int>(random.below(32))};
}

/// Any code, the first and the last of them more often.
std::uint32_t random_code(Random& random, double last)
{
    const std::uint32_t border = random.below(12);
    const double inside = random.uniform_double();
    return static_cast<std::uint32_t>(border == 0 ? 0 : border == 1 ? last : std::floor(inside * (last + 1)));
}

// Codes are asked for in the middle between two halves, so that they do not hang on the last digits of the depth.
void record_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 300; ++i) {
        const auto& [range, distance, bits] = random_camera(random);
        out.append("window", ask<window_depth>(out, range, -distance));
        const double last = std::ldexp(1.0, bits) - 1;
        const std::uint32_t code = random_code(random, last);
        append_eye(out, ask<eye_depth>(out, range, code, bits));
        out.append("codes", ask<depth_code>(out, (code + 0.8 * (random.uniform_double() - 0.5)) / last, bits));
    }
}

void record_resolution(Random& random, Recorder& out)
{
    const auto all = [&](double n, double f, double distance) {
        for (const DepthFormat format : {DepthFormat::unorm16, DepthFormat::unorm24, DepthFormat::float32})
            for (const bool reversed : {false, true})
                out.append("resolution", ask<depth_resolution>(out, {n, f, reversed}, format, -distance));
    };
    for (const double distance : {0.1, 1.0, 10.0, 100.0, 500.0}) all(0.01, 1000, distance);
    for (const double distance : {1.0, 10.0, 100.0, 300.0}) all(0.2, 400, distance);
    // Depths 1/2, 1/4, …, where the steps of floats change.
    for (const double distance : {1.25, 2.0, 4.0, 64.0}) all(1, infinity, distance);
    // Depths so close to 1 that they are none of a float's.
    for (int i = 0; i < 60; ++i) {
        const Camera camera = random_camera(random, i % 2 == 0 ? 16 : 40);
        all(camera.range.near_plane, camera.range.far_plane, camera.distance);
    }
}

/// A far plane that lies so far beyond the place where the fighting begins; that place depends on the far plane a
/// little.
double far_plane_at_the_border(double n, int bits, double gap, double beyond)
{
    double f = infinity;
    for (int i = 0; i < 8; ++i) {
        const double product = gap * n / (1 - n / f) * (std::ldexp(1.0, bits) - 1);
        f = std::max(n, std::sqrt(gap * gap / 4 + product) - gap / 2) + beyond;
    }
    return f;
}

void record_fighting(Random& random, Recorder& out)
{
    for (const auto& [n, f] : {std::pair(0.01, 1000.0), {0.2, 400.0}, {1.0, infinity}})
        for (const int bits : {16, 24, 32})
            for (const double gap : {1e-6, 1e-3, 0.1, 1.0, 10.0})
                append(out, "begin", ask<fighting_distance>(out, {n, f}, bits, gap));
    // Exactly at the border: the whole range is one step. And between the border and the far plane.
    append(out, "begin", ask<fighting_distance>(out, {1, 2}, 1, 1));
    append(out, "begin", ask<fighting_distance>(out, {1, 1000}, 10, 500));
    for (int i = 0; i < 150; ++i) {
        auto [range, distance, bits] = random_camera(random);
        const double n = range.near_plane;
        double gap = n * std::exp2(random.uniform(-14, 6));
        if (i % 3 == 1)
            gap = (std::isinf(range.far_plane) ? distance : range.far_plane - n) * 3 * random.uniform_double();
        if (i % 3 == 2) range.far_plane = far_plane_at_the_border(n, bits, gap, 2 * gap * random.uniform_double());
        append(out, "begin", ask<fighting_distance>(out, range, bits, gap));
    }
}

// Far planes up to 1e14 times as far as near ones or hardly farther, points next to the planes, gaps that dwarf what
// the buffer resolves.
void record_extremes(Random& random, Recorder& out)
{
    for (int i = 0; i < 120; ++i) {
        const double n = std::pow(10, -4 * random.uniform_double());
        const double f = i % 4 == 0 ? infinity : n * std::pow(10, 8 + 6 * random.uniform_double());
        const double beside = std::pow(10, -1 - 9 * random.uniform_double());
        out.append("near", ask<window_depth>(out, {n, f}, -n * (1 + beside)));
        out.append("far", ask<window_depth>(out, {n, f, true}, std::isinf(f) ? -n / beside : -f * (1 - beside)));
        const double close = n * (1 + std::pow(10, -2 - 6 * random.uniform_double()));
        const double between = n + random.uniform_double() * (close - n);
        out.append("near", ask<window_depth>(out, {n, close}, -between));
        out.append("far", ask<window_depth>(out, {n, close, true}, -between));
        const std::uint32_t steps = random.below(4) == 0 ? 0 : random.below(1000);
        append_eye(out, ask<eye_depth>(out, {n, f}, 4294967295U - steps, 32));
        append_eye(out, ask<eye_depth>(out, {n, f}, random.below(4294967295U), 32));
        append(out, "begin",
               ask<fighting_distance>(out, {n, infinity}, 16, n * std::pow(10, 5 + 4 * random.uniform_double())));
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { record_by_hand(c.vary, out); }},
    {"codes", [](Case& c, Recorder& out) { record_codes(c.vary, out); }},
    {"back", [](Case& c, Recorder& out) { record_back(c.vary, out); }},
    {"random", [](Case& c, Recorder& out) { record_random(c.random, out); }},
    {"resolution", [](Case& c, Recorder& out) { record_resolution(c.random, out); }},
    {"fighting", [](Case& c, Recorder& out) { record_fighting(c.random, out); }},
    {"extremes", [](Case& c, Recorder& out) { record_extremes(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_precision(out, c.vary)); }},
};

}
