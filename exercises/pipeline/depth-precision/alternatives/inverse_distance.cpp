// alternative: everything in terms of 1/d, in long double

#include <umbral/pipeline/depth_precision.hpp>

namespace umbral::pipeline {
namespace {

using Long = long double;

// The depth is affine in 1/d: 0 at 1/n, 1 at 1/f.
Long inverse(double distance) { return 1 / static_cast<Long>(distance); }

Long codes(int bits) { return std::pow(static_cast<Long>(2), bits) - 1; }

}

double ndc_depth(const DepthRange& range, double z_eye)
{
    const Long n = inverse(range.near_plane);
    const Long f = inverse(range.far_plane);
    return static_cast<double>((n + f - 2 * inverse(-z_eye)) / (n - f));
}

double window_depth(const DepthRange& range, double z_eye)
{
    const Long n = range.near_plane;
    const Long f = range.far_plane;
    const Long d = -z_eye;
    const bool endless = std::isinf(range.far_plane);
    if (range.reversed) return static_cast<double>(endless ? n / d : n * (f - d) / (d * (f - n)));
    return static_cast<double>(endless ? (d - n) / d : f / d * (d - n) / (f - n));
}

std::uint32_t depth_code(double depth, int bits)
{
    if (!(depth > 0)) return 0;
    const Long last = codes(bits);
    return static_cast<std::uint32_t>(std::floor(std::min<Long>(depth, 1) * last + 0.5L));
}

double eye_depth(const DepthRange& range, std::uint32_t code, int bits)
{
    const Long last = codes(bits);
    const Long from_near = range.reversed ? last - code : code;
    return static_cast<double>(-last /
                               ((last - from_near) * inverse(range.near_plane) + from_near * inverse(range.far_plane)));
}

double depth_resolution(const DepthRange& range, DepthFormat format, double z_eye)
{
    Long step = 0;
    if (format == DepthFormat::unorm16) step = 1 / codes(16);
    if (format == DepthFormat::unorm24) step = 1 / codes(24);
    if (format == DepthFormat::float32) {
        int exponent = 0;
        (void)std::frexp(window_depth(range, z_eye), &exponent);
        step = std::pow(static_cast<Long>(2), exponent - 24);
    }
    return static_cast<double>(step * z_eye * z_eye * (inverse(range.near_plane) - inverse(range.far_plane)));
}

std::optional<double> fighting_distance(const DepthRange& range, int bits, double gap)
{
    const Long target = codes(bits) / (inverse(range.near_plane) - inverse(range.far_plane));
    // d (d + gap) = gap * target, with d = sqrt(gap) * u.
    const Long half = std::sqrt(static_cast<Long>(gap)) / 2;
    const Long u = target / (half + std::sqrt(half * half + target));
    const auto distance = static_cast<double>(std::max<Long>(std::sqrt(static_cast<Long>(gap)) * u, range.near_plane));
    if (distance > range.far_plane - gap) return std::nullopt;
    return distance;
}

}
