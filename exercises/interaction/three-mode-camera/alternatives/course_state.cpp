// alternative: the course's redundant state (s, n, a, o and the axes), brought up to date after each step, and V as the
// rows of the axes times a translation
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/interaction/three_mode_camera.hpp>

namespace umbral::interaction {
namespace {

using V3 = glm::dvec3;

V3 cartesian(const V3& s)
{
    const double flat = s.z * std::cos(s.y);
    return {flat * std::sin(s.x), s.z * std::sin(s.y), flat * std::cos(s.x)};
}

class CourseCamera : public ThreeModeCamera {
public:
    explicit CourseCamera(const ThreeModeSettings& settings) : first_(settings), mode_(int(settings.mode))
    {
        at_ = first_.attention;
        s_ = {first_.azimuth, first_.elevation, first_.distance};
        n_ = cartesian(s_);
        o_ = at_ + n_;
        update_axes();
    }
    void move_xy(double da, double db) override
    {
        if (!std::isfinite(da) || !std::isfinite(db)) return;
        if (mode_ == 1) {
            at_ += da * x_ + db * y_;
            o_ = at_ + n_;
            return;
        }
        s_ += V3(da, db, 0);
        const double limit = std::acos(0.0);
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
            s_.z = limited(first_.min_distance + (s_.z - first_.min_distance) * std::pow(1 + first_.zoom_step, dz));
            n_ = cartesian(s_);
        } else {
            at_ += dz * z_;
        }
        o_ = at_ + n_;
    }
    void look_toward(const V3& c) override
    {
        for (int i = 0; i < 3; ++i)
            if (!std::isfinite(c[i])) return;
        const V3 n = n_ + at_ - c;
        if (glm::length(n) < 1e-6) return;
        const double flat = std::sqrt(n.x * n.x + n.z * n.z);
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
    V3 attention_point() const override { return at_; }
    glm::mat4 view() const override
    {
        const glm::dmat4 rows = glm::transpose(glm::dmat4(glm::dmat3(x_, y_, z_)));
        return glm::mat4(rows * glm::translate(glm::dmat4(1), -o_));
    }

private:
    double limited(double r) const { return std::clamp(r, 1.001 * first_.min_distance, first_.max_distance); }
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
    return std::make_unique<CourseCamera>(settings);
}

}
