// Based on: the course's class Camara3Modos: s = (α, β, r), n = Cartesianas(s), o = a + n. Where the observer stays, n
// is the vector from a to o, so a must become o - n' and not a + (n' - n).

#include <umbral/interaction/three_mode_camera.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbral::interaction {
namespace {

constexpr double quarter_turn = std::numbers::pi / 2;
constexpr double full_turn = 2 * std::numbers::pi;

/// A step can bring r so near to min_distance that the way between them is lost to rounding, and no step leads out.
constexpr double nearest = 1.001;
constexpr double no_distance = 1e-6;
constexpr double vertical_sine = 1e-6;

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

class ReferenceCamera final : public ThreeModeCamera {
public:
    explicit ReferenceCamera(const ThreeModeSettings& settings)
        : settings_(settings),
          mode_(settings.mode),
          attention_(settings.attention),
          azimuth_(settings.azimuth),
          elevation_(settings.elevation),
          distance_(settings.distance)
    {
    }

    void move_xy(double right, double up) override
    {
        if (!std::isfinite(right) || !std::isfinite(up)) return;
        switch (mode_) {
            case CameraMode::examine: return rotate(right, up);
            case CameraMode::move: {
                const glm::dmat3 axes = this->axes();
                attention_ += right * axes[0] + up * axes[1];
                return;
            }
            case CameraMode::turn: {
                const glm::dvec3 observer = attention_ + offset();
                rotate(right, up);
                attention_ = observer - offset();
                return;
            }
        }
    }

    void move_z(double steps) override
    {
        if (!std::isfinite(steps)) return;
        if (mode_ != CameraMode::examine) {
            attention_ += steps * axes()[2];
            return;
        }
        const double gap = distance_ - settings_.min_distance;
        set_distance(settings_.min_distance + gap * std::pow(1 + settings_.zoom_step, steps));
    }

    void look_toward(const glm::dvec3& point) override
    {
        if (!is_finite(point)) return;
        const glm::dvec3 observer = attention_ + offset();
        const glm::dvec3 n = observer - point;
        // Not the root of a sum of squares, which is no double for points that are 1e155 away.
        const double r = std::hypot(n.x, n.y, n.z);
        if (r < no_distance) return;
        const double horizontal = std::hypot(n.x, n.z);
        if (horizontal >= vertical_sine * r) azimuth_ = std::atan2(n.x, n.z);
        elevation_ = std::atan2(n.y, horizontal);
        set_distance(r);
        attention_ = observer - offset();
        mode_ = CameraMode::examine;
    }

    void next_mode() override
    {
        switch (mode_) {
            case CameraMode::examine: mode_ = CameraMode::move; return;
            case CameraMode::move: mode_ = CameraMode::turn; return;
            case CameraMode::turn: mode_ = CameraMode::examine; return;
        }
    }

    [[nodiscard]] CameraMode mode() const override { return mode_; }

    [[nodiscard]] glm::dvec3 attention_point() const override { return attention_; }

    [[nodiscard]] glm::mat4 view() const override
    {
        // The axes are the rows of the rotation. It acts on the attention point, and r comes after it: the observer's
        // place would have to be subtracted again.
        glm::dmat4 view(transpose(axes()));
        view[3] = glm::dvec4(-(attention_ * axes()) - glm::dvec3(0, 0, distance_), 1);
        return glm::mat4(view);
    }

private:
    /// By columns; z goes from the attention point to the observer.
    [[nodiscard]] glm::dmat3 axes() const
    {
        const double sa = std::sin(azimuth_);
        const double ca = std::cos(azimuth_);
        const double sb = std::sin(elevation_);
        const double cb = std::cos(elevation_);
        return {{ca, 0, -sa}, {-sb * sa, cb, -sb * ca}, {cb * sa, sb, cb * ca}};
    }

    /// n, from the attention point to the observer.
    [[nodiscard]] glm::dvec3 offset() const { return distance_ * axes()[2]; }

    void rotate(double by_azimuth, double by_elevation)
    {
        azimuth_ = std::remainder(azimuth_ + by_azimuth, full_turn);
        elevation_ = std::clamp(elevation_ + by_elevation, -quarter_turn, quarter_turn);
    }

    void set_distance(double distance)
    {
        distance_ = std::clamp(distance, nearest * settings_.min_distance, settings_.max_distance);
    }

    ThreeModeSettings settings_;
    CameraMode mode_;
    glm::dvec3 attention_;
    double azimuth_;
    double elevation_;
    double distance_;
};

}

std::unique_ptr<ThreeModeCamera> make_three_mode_camera(const ThreeModeSettings& settings)
{
    return std::make_unique<ReferenceCamera>(settings);
}

}
