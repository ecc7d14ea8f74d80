#include <cmath>
#include <umbral/pipeline/depth_precision.hpp>

#include "wide.hpp"

// From the entries of the projection matrix, with 113 bits, rounded to double once.

namespace umbral::pipeline {
namespace {

// z_clip = scale * z_eye + shift, w = -z_eye; their limits for a far plane at infinity.
struct Projection {
    Wide scale, shift;
};

Projection projection(const DepthRange& range)
{
    const Wide n = range.near_plane;
    if (std::isinf(range.far_plane)) return {-1, -2 * n};
    const Wide f = range.far_plane;
    return {-(f + n) / (f - n), -2 * f * n / (f - n)};
}

Wide ndc(const DepthRange& range, double z_eye)
{
    const auto [scale, shift] = projection(range);
    return (scale * Wide(z_eye) + shift) / -Wide(z_eye);
}

// Reversed, by itself: 1 - depth would keep 113 bits of the 1 only.
Wide depth_of(const DepthRange& range, double z_eye)
{
    if (!range.reversed) return (ndc(range, z_eye) + 1) / 2;
    const Wide n = range.near_plane;
    const Wide d = -Wide(z_eye);
    if (std::isinf(range.far_plane)) return n / d;
    const Wide f = range.far_plane;
    return n * (f - d) / (d * (f - n));
}

Wide last_code(int bits) { return Wide((std::uint64_t{1} << bits) - 1); }

}

double ndc_depth(const DepthRange& range, double z_eye) { return static_cast<double>(ndc(range, z_eye)); }

double window_depth(const DepthRange& range, double z_eye) { return static_cast<double>(depth_of(range, z_eye)); }

std::uint32_t depth_code(double depth, int bits)
{
    const Wide clamped = depth > 1 ? 1 : depth > 0 ? depth : 0;
    return static_cast<std::uint32_t>(clamped * last_code(bits) + Wide(0.5));
}

double eye_depth(const DepthRange& range, std::uint32_t code, int bits)
{
    // The course's inverse, f n / ((f - n) k / last - f), with f divided out. It cancels, but never more than 60 of the
    // 113 bits.
    const Wide last = last_code(bits);
    const Wide part = (range.reversed ? last - Wide(code) : Wide(code)) / last;
    const Wide n = range.near_plane;
    const Wide n_over_f = std::isinf(range.far_plane) ? Wide(0) : n / Wide(range.far_plane);
    return static_cast<double>(-n / (1 - (1 - n_over_f) * part));
}

double depth_resolution(const DepthRange& range, DepthFormat format, double z_eye)
{
    const Wide z = z_eye;
    const Wide derivative = -projection(range).shift / 2 / (z * z);
    Wide step = std::ldexp(1.0, std::ilogb(static_cast<double>(depth_of(range, z_eye))) - 23);
    if (format == DepthFormat::unorm16) step = 1 / last_code(16);
    if (format == DepthFormat::unorm24) step = 1 / last_code(24);
    return static_cast<double>(step / derivative);
}

std::optional<double> fighting_distance(const DepthRange& range, int bits, double gap)
{
    const Wide product = -projection(range).shift / 2 * Wide(gap) * last_code(bits);
    const Wide half = Wide(gap) / 2;
    const Wide distance = product / (half + square_root(half * half + product));
    const double first = distance < Wide(range.near_plane) ? range.near_plane : static_cast<double>(distance);
    if (first > range.far_plane - gap) return std::nullopt;
    return first;
}

}
