#include <umbral/interaction/three_mode_camera.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "wide.hpp"

// The observer is what is kept, and the attention point what follows from it: the other way round than in the
// reference. Angles are summed in 113 bits and never wrapped, all else has 64 bits; axes come from cross products.

namespace umbral::interaction {
namespace {

using Long = long double;
using LongVector = glm::vec<3, Long>;

constexpr Long pi = std::numbers::pi_v<Long>;

Long length_of(const LongVector& v) { return std::sqrt(dot(v, v)); }

class OracleCamera final : public ThreeModeCamera {
public:
    explicit OracleCamera(const ThreeModeSettings& settings)
        : settings_(settings),
          mode_(static_cast<int>(settings.mode)),
          azimuth_(settings.azimuth),
          elevation_(settings.elevation),
          distance_(settings.distance)
    {
        observer_ = LongVector(settings.attention) + distance_ * backward();
    }

    void move_xy(double right, double up) override
    {
        if (!std::isfinite(right) || !std::isfinite(up)) return;
        if (mode_ == 1) {
            observer_ += Long(right) * side() + Long(up) * cross(backward(), side());
            return;
        }
        const LongVector attention = observer_ - distance_ * backward();
        azimuth_ += right;
        elevation_ = std::min(std::max(elevation_ + up, -pi / 2), pi / 2);
        if (mode_ == 0) observer_ = attention + distance_ * backward();
    }

    void move_z(double steps) override
    {
        if (!std::isfinite(steps)) return;
        if (mode_ != 0) {
            observer_ += Long(steps) * backward();
            return;
        }
        const Long before = distance_;
        const Long factor = std::pow(1 + Long(settings_.zoom_step), Long(steps));
        distance_ = limited(settings_.min_distance + (before - settings_.min_distance) * factor);
        observer_ += (distance_ - before) * backward();
    }

    void look_toward(const glm::dvec3& point) override
    {
        if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) return;
        const LongVector n = observer_ - LongVector(point);
        const Long r = length_of(n);
        if (r < 1e-6L) return;
        const Long flat = std::sqrt(n.x * n.x + n.z * n.z);
        if (flat / r >= 1e-6L) azimuth_ = std::atan2(n.x, n.z);
        elevation_ = std::atan2(n.y, flat);
        distance_ = limited(r);
        mode_ = 0;
    }

    void next_mode() override { mode_ = (mode_ + 1) % 3; }
    [[nodiscard]] CameraMode mode() const override { return static_cast<CameraMode>(mode_); }
    [[nodiscard]] glm::dvec3 attention_point() const override { return glm::dvec3(observer_ - distance_ * backward()); }

    [[nodiscard]] glm::mat4 view() const override
    {
        glm::mat4 view(1);
        int row = 0;
        for (const LongVector& axis : {side(), cross(backward(), side()), backward()}) {
            for (int column = 0; column < 3; ++column) view[column][row] = static_cast<float>(axis[column]);
            view[3][row] = static_cast<float>(-dot(axis, observer_));
            ++row;
        }
        return view;
    }

private:
    /// In radians, within about a turn.
    [[nodiscard]] Long azimuth() const
    {
        const double turns = std::round(static_cast<double>(azimuth_) / (2 * std::numbers::pi));
        return static_cast<Long>(azimuth_ - Wide(turns) * 2 * pi);
    }
    [[nodiscard]] LongVector side() const { return {std::cos(azimuth()), 0, -std::sin(azimuth())}; }
    [[nodiscard]] LongVector backward() const
    {
        const Long flat = std::cos(elevation_);
        return {flat * std::sin(azimuth()), std::sin(elevation_), flat * std::cos(azimuth())};
    }
    [[nodiscard]] Long limited(Long distance) const
    {
        return std::clamp(distance, 1.001L * settings_.min_distance, Long(settings_.max_distance));
    }

    ThreeModeSettings settings_;
    int mode_;
    Wide azimuth_;
    Long elevation_;
    Long distance_;
    LongVector observer_;
};

}

std::unique_ptr<ThreeModeCamera> make_three_mode_camera(const ThreeModeSettings& settings)
{
    return std::make_unique<OracleCamera>(settings);
}

}
