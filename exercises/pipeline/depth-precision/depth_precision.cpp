#include <umbral/pipeline/depth_precision.hpp>

namespace umbral::pipeline {

double ndc_depth(const DepthRange& range, double z_eye)
{
    // TODO: z_clip / w of the perspective matrix.
    return not_implemented<double>(range, z_eye);
}

double window_depth(const DepthRange& range, double z_eye)
{
    // TODO: from [-1, 1] to [0, 1]; or, if reversed, to [1, 0].
    return not_implemented<double>(range, z_eye);
}

std::uint32_t depth_code(double depth, int bits)
{
    // TODO: the nearest of the codes 0 ... 2^bits - 1.
    return not_implemented<std::uint32_t>(depth, bits);
}

double eye_depth(const DepthRange& range, std::uint32_t code, int bits)
{
    // TODO: from a code back to z_eye, which is negative.
    return not_implemented<double>(range, code, bits);
}

double depth_resolution(const DepthRange& range, DepthFormat format, double z_eye)
{
    // TODO: one step of the format over the derivative of the depth by the distance.
    return not_implemented<double>(range, format, z_eye);
}

std::optional<double> fighting_distance(const DepthRange& range, int bits, double gap)
{
    // TODO: depth(d + gap) - depth(d) = 1 / (2^bits - 1), solved for d.
    return not_implemented<std::optional<double>>(range, bits, gap);
}

}
