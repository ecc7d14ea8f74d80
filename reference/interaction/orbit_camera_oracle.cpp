#include <umbral/interaction/orbit_camera.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "wide.hpp"

// Angles summed in 113 bits and never wrapped, the matrix with 64 bits and the other way round: first where the camera
// stands, then its axes by cross products. So an error of the reference shows in how it counts as well as in how it
// writes the matrix down.

namespace umbral::interaction {
namespace {

using Long = long double;
using LongVector = glm::vec<3, Long>;

constexpr Long pi = std::numbers::pi_v<Long>;

LongVector unit(const LongVector& v) { return v / std::sqrt(dot(v, v)); }

/// The angle of so many half turns, in radians between -π and π.
Long radians_of(Wide half_turns)
{
    const Wide turns = half_turns / 2;
    // A whole number of turns as a sum of two that a double holds.
    const double coarse = std::round(static_cast<double>(turns));
    const double rest = std::round(static_cast<double>(turns - Wide(coarse)));
    return 2 * pi * static_cast<Long>(turns - Wide(coarse) - Wide(rest));
}

class OracleCamera final : public OrbitCamera {
public:
    explicit OracleCamera(const OrbitCameraSettings& settings) : settings_(settings), height_(settings.viewport_height)
    {
        reset();
    }

    void drag(double right, double up) override
    {
        if (!std::isfinite(right) || !std::isfinite(up)) return;
        const Wide limit = static_cast<Long>(settings_.max_pitch) / pi;
        yaw_ -= Wide(right) / height_;
        pitch_ = std::clamp(pitch_ - Wide(up) / height_, -limit, limit);
    }

    void scroll(double steps) override
    {
        if (!std::isfinite(steps)) return;
        const Long factor = std::pow(Long(11) / 10, -static_cast<Long>(steps));
        distance_ = std::clamp(distance_ * factor, static_cast<Long>(settings_.min_distance),
                               static_cast<Long>(settings_.max_distance));
    }

    void resize(int width, int height) override
    {
        if (std::min(width, height) > 0) height_ = height;
    }

    void reset() override
    {
        yaw_ = static_cast<Long>(settings_.yaw) / pi;
        pitch_ = static_cast<Long>(settings_.pitch) / pi;
        distance_ = settings_.distance;
    }

    [[nodiscard]] glm::mat4 view() const override
    {
        const Long yaw = radians_of(yaw_);
        const Long pitch = radians_of(pitch_);
        const LongVector z = unit({std::cos(pitch) * std::sin(yaw), std::sin(pitch), std::cos(pitch) * std::cos(yaw)});
        const LongVector x = unit(cross(LongVector(0, 1, 0), z));
        const LongVector y = cross(z, x);
        const LongVector eye = LongVector(settings_.target) + distance_ * z;

        glm::mat4 view(1);
        int row = 0;
        for (const LongVector& axis : {x, y, z}) {
            for (int column = 0; column < 3; ++column) view[column][row] = static_cast<float>(axis[column]);
            view[3][row] = static_cast<float>(-dot(axis, eye));
            ++row;
        }
        return view;
    }

private:
    OrbitCameraSettings settings_;
    Wide height_;
    Wide yaw_ = 0;    ///< half turns
    Wide pitch_ = 0;  ///< half turns
    Long distance_ = 0;
};

}

std::unique_ptr<OrbitCamera> make_orbit_camera(const OrbitCameraSettings& settings)
{
    return std::make_unique<OracleCamera>(settings);
}

}
