// Based on: K. Akeley, J. Su. Minimum Triangle Separation for Correct z-Buffer Occlusion. Graphics Hardware 2006.
// N. Reed. Depth Precision Visualized. 2015 (reversed depths in float).

#include <algorithm>
#include <cmath>
#include <umbral/pipeline/depth_precision.hpp>

namespace umbral::pipeline {
namespace {

// 1 - distance / far, without loss close to the far plane; 1 if that is infinite.
double before_far(const DepthRange& range, double distance)
{
    return std::isinf(range.far_plane) ? 1 : (range.far_plane - distance) / range.far_plane;
}

double last_code(int bits) { return std::ldexp(1.0, bits) - 1; }

// With n the near plane and f the far one, the depth is (1 - n/d) / (1 - n/f). Its derivative is this over the distance
// squared.
double slope(const DepthRange& range) { return range.near_plane / before_far(range, range.near_plane); }

// The size of a step of the format where the depth has this value: less than 1, though it may have been rounded to 1.
double step(DepthFormat format, double depth)
{
    switch (format) {
        case DepthFormat::unorm16: return 1 / last_code(16);
        case DepthFormat::unorm24: return 1 / last_code(24);
        case DepthFormat::float32: break;
    }
    return std::ldexp(1.0, std::min(std::ilogb(depth), -1) - 23);
}

}

double ndc_depth(const DepthRange& range, double z_eye)
{
    return 2 * window_depth({range.near_plane, range.far_plane, false}, z_eye) - 1;
}

double window_depth(const DepthRange& range, double z_eye)
{
    const double distance = -z_eye;
    const double whole = before_far(range, range.near_plane);
    if (range.reversed) return range.near_plane / distance * before_far(range, distance) / whole;
    return (distance - range.near_plane) / distance / whole;
}

std::uint32_t depth_code(double depth, int bits)
{
    return static_cast<std::uint32_t>(std::clamp(depth, 0.0, 1.0) * last_code(bits) + 0.5);
}

double eye_depth(const DepthRange& range, std::uint32_t code, int bits)
{
    // The codes to the far plane are a whole number: nothing cancels there.
    const double last = last_code(bits);
    const double to_far = range.reversed ? code : last - code;
    return -range.near_plane * last / (to_far + (last - to_far) * (range.near_plane / range.far_plane));
}

double depth_resolution(const DepthRange& range, DepthFormat format, double z_eye)
{
    return step(format, window_depth(range, z_eye)) * z_eye * z_eye / slope(range);
}

std::optional<double> fighting_distance(const DepthRange& range, int bits, double gap)
{
    // Depths differ by slope * gap / (d (d + gap)). One step of that is a quadratic equation, of which this is the root
    // that adds.
    const double product = gap * slope(range) * last_code(bits);
    const double distance = 2 * product / (gap + std::sqrt(gap * gap + 4 * product));
    const double first = std::max(distance, range.near_plane);
    if (first > range.far_plane - gap) return std::nullopt;
    return first;
}

}
