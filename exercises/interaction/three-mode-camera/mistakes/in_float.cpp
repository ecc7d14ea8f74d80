// mistake: keeps its state in float
// credit: 82..95
// hint: After a hundred thousand steps the rounding of each float addition adds up to degrees, and far from the origin
// a float place is rounded to centimetres. Keep attention point, angles and distance in double.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/interaction/three_mode_camera.hpp>

namespace umbral::interaction {
namespace {

using V3 = glm::vec3;

V3 cartesian(const V3& s)
{
    const float flat = s.z * std::cos(s.y);
    return {flat * std::sin(s.x), s.z * std::sin(s.y), flat * std::cos(s.x)};
}

class FloatCamera : public ThreeModeCamera {
public:
    explicit FloatCamera(const ThreeModeSettings& settings) : first_(settings), mode_(int(settings.mode))
    {
        at_ = V3(first_.attention);
        s_ = V3(first_.azimuth, first_.elevation, first_.distance);
        n_ = cartesian(s_);
        o_ = at_ + n_;
        update_axes();
    }
    void move_xy(double da, double db) override
    {
        if (!std::isfinite(da) || !std::isfinite(db)) return;
        if (mode_ == 1) {
            at_ += float(da) * x_ + float(db) * y_;
            o_ = at_ + n_;
            return;
        }
        s_ += V3(da, db, 0);
        const float limit = std::acos(0.0F);
        if (s_.y > limit) s_.y = limit;
        if (s_.y < -limit) s_.y = -limit;
        const V3 turned = cartesian(s_);
        if (mode_ == 0)
            o_ = at_ + turned;
        else
            at_ += n_ - turned;
        n_ = turned;
        update_axes();
    }
    void move_z(double dz) override
    {
        if (!std::isfinite(dz)) return;
        if (mode_ == 0) {
            const auto least = float(first_.min_distance);
            s_.z = limited(least + (s_.z - least) * std::pow(float(1 + first_.zoom_step), float(dz)));
            n_ = cartesian(s_);
        } else {
            at_ += float(dz) * z_;
        }
        o_ = at_ + n_;
    }
    void look_toward(const glm::dvec3& point) override
    {
        const V3 c(point);
        for (int i = 0; i < 3; ++i)
            if (!std::isfinite(c[i])) return;
        const V3 n = o_ - c;
        if (glm::length(n) < 1e-6) return;
        const float flat = std::sqrt(n.x * n.x + n.z * n.z);
        if (flat >= 1e-6 * glm::length(n)) s_.x = std::atan2(n.x, n.z);
        s_.y = std::atan2(n.y, flat);
        s_.z = limited(glm::length(n));
        n_ = cartesian(s_);
        at_ = o_ - n_;
        update_axes();
        mode_ = 0;
    }
    void next_mode() override
    {
        if (++mode_ == 3) mode_ = 0;
    }
    CameraMode mode() const override { return CameraMode(mode_); }
    glm::dvec3 attention_point() const override { return at_; }
    glm::mat4 view() const override
    {
        const glm::mat4 rows = glm::transpose(glm::mat4(glm::mat3(x_, y_, z_)));
        return rows * glm::translate(glm::mat4(1), -o_);
    }

private:
    float limited(double r) const { return float(std::clamp(r, 1.001 * first_.min_distance, first_.max_distance)); }
    void update_axes()
    {
        x_ = {std::cos(s_.x), 0, -std::sin(s_.x)};
        z_ = cartesian({s_.x, s_.y, 1});
        y_ = glm::cross(z_, x_);
    }

    ThreeModeSettings first_;
    int mode_;
    V3 at_, s_, n_, o_, x_, y_, z_;
};

}

std::unique_ptr<ThreeModeCamera> make_three_mode_camera(const ThreeModeSettings& settings)
{
    return std::make_unique<FloatCamera>(settings);
}

}
