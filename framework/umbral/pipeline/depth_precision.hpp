#pragma once

#include <cstdint>
#include <optional>
#include <umbral/core/not_implemented.hpp>
#include <umbral/pipeline/depth.hpp>

namespace umbral::pipeline {

/// How a perspective camera that looks along -z makes depths: 0 < near_plane < far_plane, and far_plane may be
/// infinite.
struct DepthRange {
    double near_plane;
    double far_plane;
    bool reversed = false;  ///< depths go from 1 at the near plane to 0 at the far one
};

/// z after projection and division by w, as OpenGL has it: -1 at the near plane, 1 at the far one; `reversed` does not
/// count. z_eye is negative: from -near_plane to -far_plane.
[[nodiscard]] double ndc_depth(const DepthRange& range, double z_eye);

/// The depth in window coordinates, in [0, 1]: 0 at the near plane and 1 at the far one, or the other way round if
/// reversed.
///
/// Guarantee of the reference: a relative error below 1e-15, also next to the plane where the depth is 0.
[[nodiscard]] double window_depth(const DepthRange& range, double z_eye);

/// The code nearest to a depth, which is clamped to [0, 1] first: a whole number from 0 to 2^bits - 1. Halves go up.
/// `bits` is 1 to 32. A depth that is no half, but lies within 2^-53 of one, may go either way.
[[nodiscard]] std::uint32_t depth_code(double depth, int bits);

/// The z_eye (negative) whose depth has exactly this code: the inverse. Codes lie in 0 ... 2^bits - 1.
///
/// Guarantee of the reference: a relative error below 1e-15. An infinite far plane comes back as -infinity.
[[nodiscard]] double eye_depth(const DepthRange& range, std::uint32_t code, int bits);

/// How far behind a point another must lie for their depths to differ by one step of the format: the step's size over
/// the derivative of the depth there. A step of float32 is 2^(e-23) at a depth from 2^e to 2^(e+1). z_eye lies strictly
/// between the planes.
[[nodiscard]] double depth_resolution(const DepthRange& range, DepthFormat format, double z_eye);

/// Where z-fighting begins: the smallest distance d from the camera, at least near_plane, from which on the depths of
/// two surfaces at d and at d + gap differ by no more than a step of b bits, 1 / (2^bits - 1). Nothing if that distance
/// is beyond far_plane - gap. gap > 0.
///
/// Reversed or not is the same for whole-numbered codes. Guarantee of the reference: a relative error below 1e-15.
/// Course of all of this: precision of the Z-buffer; its z_eye lacks the sign, and its codes are cut off instead of
/// rounded.
[[nodiscard]] std::optional<double> fighting_distance(const DepthRange& range, int bits, double gap);

}
