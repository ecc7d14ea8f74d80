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

double last_code(int bits) { return std::ldexp(1.0, bits) - 1; }

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
                                 vary.scaled(-2.0, 1.5),
                                 vary.near(-0.7, 0.15),
                                 vary.scaled(-1e-2, 3),
                                 vary.scaled(1.5, 1.4F)};
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
    for (const std::uint32_t code : {0U, 1U, vary.near(127U, 90U), 254U})
        for (const bool reversed : {false, true}) {
            const double n = vary.scaled(0.5, 2);
            append_eye(out, ask<eye_depth>(out, {n, infinity, reversed}, reversed ? 255 - code : code, 8));
        }
    // As far as there is nothing.
    for (const int bits : {1, 8, 16, 24, 32})
        for (const bool reversed : {false, true}) {
            const double n = vary.scaled(0.5, 2);
            const auto last = static_cast<std::uint32_t>(last_code(bits));
            append_eye(out, ask<eye_depth>(out, {n, infinity, reversed}, reversed ? 0 : last, bits));
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
    // The largest codes fit into no int.
    const int bits = random.below(4) == 0 ? 32 : 1 + static_cast<int>(random.below(32));
    return {{n, f, reversed}, distance, bits};
}

/// Random cameras, of which every other one has the near plane of the one before, and only that: what a solution keeps
/// for a near plane is wrong for it.
class Cameras {
public:
    explicit Cameras(Random& random) : random_(random) {}

    [[nodiscard]] Camera next(double most = 16)
    {
        Camera camera = random_camera(random_, most);
        if (count_++ % 2 == 1) {
            const double scale = near_plane_ / camera.range.near_plane;
            camera.range.near_plane = near_plane_;
            camera.range.far_plane *= scale;
            camera.distance *= scale;
        }
        near_plane_ = camera.range.near_plane;
        return camera;
    }

private:
    Random& random_;
    int count_ = 0;
    double near_plane_ = 1;
};

/// Any code, the first and the last of them more often.
std::uint32_t random_code(Random& random, double last)
{
    const std::uint32_t border = random.below(6);
    const double inside = random.uniform_double();
    return static_cast<std::uint32_t>(border == 0 ? 0 : border == 1 ? last : std::floor(inside * (last + 1)));
}

/// A depth of this code, as close to the middle between two codes as 2^-2 to 2^-14 of a step, but never so close that
/// the last digits of the depth decide.
double depth_of_code(Random& random, std::uint32_t code, int bits)
{
    const double from_middle = std::exp2(-2 - (std::min(46 - bits, 24) - 2) * random.uniform_double());
    const double off = (random.below(2) == 0 ? 1 : -1) * (0.5 - from_middle);
    return (code + off) / last_code(bits);
}

void record_random(Random& random, Recorder& out)
{
    Cameras cameras(random);
    for (int i = 0; i < 300; ++i) {
        const auto& [range, distance, bits] = cameras.next();
        out.append("window", ask<window_depth>(out, range, -distance));
        const std::uint32_t code = random_code(random, last_code(bits));
        append_eye(out, ask<eye_depth>(out, range, code, bits));
        const double outside = random.uniform(-4, 5);
        const double inside = depth_of_code(random, code, bits);
        out.append("codes", ask<depth_code>(out, i % 6 == 5 ? outside : inside, bits));
    }
}

/// Where a depth lies just below a power of two: nearer than a float can tell, but not nearer than the formula can.
double below_a_power(Random& random, const DepthRange& range)
{
    const double power = std::ldexp(1.0, -static_cast<int>(random.below(4)));
    const double missing = power * std::exp2(-26 - 14 * random.uniform_double());
    const double whole = 1 - range.near_plane / range.far_plane;
    // What is left of 1 at the near plane, at this depth.
    const double to_far = range.reversed ? power - missing : 1 - power + missing;
    return range.near_plane / (range.near_plane / range.far_plane + to_far * whole);
}

void record_resolution(Random& random, Recorder& out)
{
    const auto one = [&](const DepthRange& range, DepthFormat format, double distance) {
        out.append("resolution", ask<depth_resolution>(out, range, format, -distance));
    };
    const auto all = [&](double n, double f, double distance) {
        one({n, f, random.below(2) == 0}, random.below(3) == 0 ? DepthFormat::unorm16 : DepthFormat::unorm24, distance);
        for (const bool reversed : {false, true}) one({n, f, reversed}, DepthFormat::float32, distance);
    };
    for (const double distance : {0.1, 1.0, 10.0, 100.0, 500.0}) all(0.01, 1000, distance);
    for (const double distance : {1.0, 10.0, 100.0, 300.0}) all(0.2, 400, distance);
    // Depths 1/2, 1/4, …, where the steps of floats change.
    for (const double distance : {1.25, 2.0, 4.0, 64.0}) all(1, infinity, distance);
    Cameras cameras(random);
    for (int i = 0; i < 100; ++i) {
        // Depths so close to 1, or to 0, that floats have other steps there, or that they are none of a float's.
        auto [range, distance, bits] = cameras.next(i % 3 == 0 ? 16 : 40);
        if (i % 4 == 2) {
            range.far_plane = infinity;
            distance = range.near_plane * std::exp2(40 * (0.3 + 0.68 * random.uniform_double()));
        }
        all(range.near_plane, range.far_plane, distance);
        range.far_plane = i % 4 == 2 ? infinity : range.near_plane * std::exp2(1 + 15 * random.uniform_double());
        one(range, DepthFormat::float32, below_a_power(random, range));
    }
}

/// A far plane that lies so far beyond the place where the fighting begins; that place depends on the far plane a
/// little.
double far_plane_at_the_border(double n, int bits, double gap, double beyond)
{
    double f = infinity;
    for (int i = 0; i < 8; ++i) {
        const double product = gap * n / (1 - n / f) * last_code(bits);
        f = std::max(n, std::sqrt(gap * gap / 4 + product) - gap / 2) + beyond;
    }
    return f;
}

/// Planes so close together that the whole range is one step of one bit: exactly at the border. The far plane has few
/// digits, and the range is a power of two times it: nothing is rounded.
DepthRange one_step(Random& random, bool reversed)
{
    const double f = std::ldexp(1.0 + random.below(2000), static_cast<int>(random.below(40)) - 30);
    return {f - std::ldexp(f, -1 - static_cast<int>(random.below(6))), f, reversed};
}

void record_fighting(Random& random, Recorder& out)
{
    for (const auto& [n, f] : {std::pair(0.01, 1000.0), {0.2, 400.0}, {1.0, infinity}})
        for (const int bits : {16, 24, 32})
            for (const double gap : {1e-6, 1e-3, 0.1, 1.0, 10.0})
                append(out, "begin", ask<fighting_distance>(out, {n, f}, bits, gap));
    append(out, "begin", ask<fighting_distance>(out, {1, 1000}, 10, 500));
    Cameras cameras(random);
    for (int i = 0; i < 160; ++i) {
        auto [range, distance, bits] = cameras.next();
        double gap = range.near_plane * std::exp2(random.uniform(-14, 6));
        if (i % 5 == 1)
            gap = (std::isinf(range.far_plane) ? distance : range.far_plane - range.near_plane) * 3 *
                  random.uniform_double();
        if (i % 5 == 2)
            range.far_plane = far_plane_at_the_border(range.near_plane, bits, gap, 2 * gap * random.uniform_double());
        if (i % 5 == 3) {
            range = one_step(random, range.reversed);
            bits = 1;
            gap = range.far_plane - range.near_plane;
        }
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
        const double gap = n * std::pow(10, 8 + 4 * random.uniform_double());
        const double end = gap * (2 + 98 * random.uniform_double());
        const int bits = 4 + static_cast<int>(random.below(13));
        append(out, "begin", ask<fighting_distance>(out, {n, i % 2 == 0 ? infinity : end}, bits, gap));
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
