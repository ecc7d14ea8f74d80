// Pictures by random samples, independent in each pixel, right and wrong. Compiled several times, as software.cpp is.
// Based on: R. Cook, T. Porter, L. Carpenter. Distributed Ray Tracing. 1984. J. Kajiya. The Rendering Equation. 1986.

#include "tracing.hpp"

#include <algorithm>
#include <cmath>
#include <umbral/core/random.hpp>

#include "software.hpp"

namespace umbral::bench::scenes {
namespace {

using Real = UMBRAL_REAL;
using vec2 = glm::vec<2, Real>;
using vec3 = glm::vec<3, Real>;

constexpr Real pi = Real(3.14159265358979);
constexpr Real far_away = Real(1e9);
constexpr Real lift = Real(1e-3);

/// Based on: IEC 61966-2-1 (sRGB).
std::uint8_t encoded(Real light)
{
    const Real seen = std::clamp(light, Real(0), Real(1));
    const Real code =
        seen <= Real(0.0031308) ? Real(12.92) * seen : Real(1.055) * std::pow(seen, 1 / Real(2.4)) - Real(0.055);
    return static_cast<std::uint8_t>(code * Real(255) + Real(0.5));
}

struct Hit {
    Real distance = far_away;
    vec3 place{0};
    vec3 normal{0};
    vec3 color{0};
};

class Tracer {
public:
    Tracer(const Traced& world, Flaw flaw, Way way) : world_(world), flaw_(flaw), way_(way), random_(world.seed)
    {
        side_ = 1;
        while (side_ * side_ < world.samples) ++side_;
        eye_ = vec3(world.eye);
        forward_ = glm::normalize(vec3(world.target) - eye_);
        right_ = glm::normalize(glm::cross(forward_, vec3(0, 1, 0)));
        up_ = glm::cross(right_, forward_);
        const bool wide = flaw == Flaw::fov_3_percent_wrong;
        half_ = std::tan(glm::radians(Real(world.fovy_degrees) * (wide ? Real(1.03) : Real(1))) / 2);
        strength_ = flaw == Flaw::light_3_percent ? Real(0.97) : flaw == Flaw::light_5_percent ? Real(0.95) : Real(1);
    }

    Image picture()
    {
        Image image(world_.width, world_.height);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const auto pixel = static_cast<std::uint64_t>(y * image.width + x);
                random_ = Random(world_.seed * 0x100000000U + (flaw_ == Flaw::jitter_correlated ? 0 : pixel));
                vec3 sum(0);
                for (sample_ = 0; sample_ < world_.samples; ++sample_) sum += estimate(x, y);
                const vec3 mean = sum * (strength_ / static_cast<Real>(world_.samples));
                image.at(x, y) = {encoded(mean.x), encoded(mean.y), encoded(mean.z), 255};
            }
        return image;
    }

private:
    Real uniform() { return Real(random_.uniform()); }

    /// Uniform in the unit square. One after the other: compilers differ in the order in which they evaluate arguments.
    vec2 pair()
    {
        const Real x = uniform();
        return {x, uniform()};
    }

    /// The same; stratified, in the sample's own cell of the square.
    vec2 in_square()
    {
        const vec2 at = pair();
        if (way_ != Way::stratified_samples) return at;
        return (vec2(sample_ % side_, sample_ / side_) + at) / static_cast<Real>(side_);
    }

    void meet(Hit& hit, const vec3& from, const vec3& along, const TracedBall& ball) const
    {
        const vec3 centre(ball.centre);
        const vec3 o = from - centre;
        const Real radius = ball.radius;
        const Real b = glm::dot(o, along);
        const Real d = b * b - (glm::dot(o, o) - radius * radius);
        if (d < 0) return;
        const Real root = std::sqrt(d);
        const Real t = -b - root > lift ? -b - root : -b + root;
        if (t <= lift || t >= hit.distance) return;
        const vec3 place = from + t * along;
        hit = {t, place, (place - centre) / radius, vec3(ball.color)};
    }

    [[nodiscard]] Hit first_hit(const vec3& from, const vec3& along) const
    {
        Hit hit;
        for (const TracedBall& ball : world_.balls) meet(hit, from, along, ball);
        if (along.y < 0)
            if (const Real t = -from.y / along.y; t > lift && t < hit.distance && t < 60) {
                const vec3 place = from + t * along;
                const bool odd =
                    (static_cast<int>(std::floor(place.x)) + static_cast<int>(std::floor(place.z))) % 2 != 0;
                hit = {t, place, vec3(0, 1, 0),
                       odd ? vec3(Real(0.75), Real(0.72), Real(0.65)) : vec3(Real(0.45), Real(0.47), Real(0.5))};
            }
        return hit;
    }

    /// Round a normal, cosine-distributed: a point on the unit sphere that touches from above. Uniform for those who
    /// want that.
    vec3 direction(const vec3& n, const vec2& u, bool evenly) const
    {
        const Real turn = 2 * pi * u.x;
        const Real height = evenly ? u.y : std::sqrt(u.y);
        const Real r = std::sqrt(std::max(Real(0), 1 - height * height));
        const vec3 axis = flaw_ == Flaw::normal_forgotten ? vec3(0, 1, 0) : n;
        const vec3 t = glm::normalize(glm::cross(std::abs(axis.x) > Real(0.5) ? vec3(0, 1, 0) : vec3(1, 0, 0), axis));
        return r * std::cos(turn) * t + r * std::sin(turn) * glm::cross(axis, t) + height * axis;
    }

    static vec3 sky(const vec3& along)
    {
        const Real t = std::max(along.y, Real(0));
        return glm::mix(vec3(Real(0.95), Real(0.9), Real(0.8)), vec3(Real(0.45), Real(0.6), Real(0.9)), t);
    }

    vec3 estimate(int x, int y)
    {
        const bool blurred = world_.estimate == Estimate::depth_of_field;
        vec2 inside(Real(0.5));
        if (blurred && flaw_ != Flaw::pixel_not_jittered) inside = in_square();
        if (flaw_ == Flaw::half_pixel_centre) inside -= Real(0.5);
        const vec2 place = (vec2(x, y) + inside) * Real(2) / static_cast<Real>(world_.height) -
                           vec2(static_cast<Real>(world_.width) / static_cast<Real>(world_.height), 1);
        vec3 along = glm::normalize(forward_ + half_ * (place.x * right_ - place.y * up_));
        vec3 from = eye_;
        if (blurred) {
            const vec3 sharp = eye_ + along * (glm::length(vec3(world_.target) - eye_) / glm::dot(along, forward_));
            const Real radius =
                Real(world_.aperture) * std::sqrt(uniform()) * (flaw_ == Flaw::aperture_halved ? Real(0.5) : Real(1));
            const Real turn = 2 * pi * uniform();
            from = eye_ + radius * (std::cos(turn) * right_ + std::sin(turn) * up_);
            along = glm::normalize(sharp - from);
        }
        const Hit hit = first_hit(from, along);
        if (hit.distance == far_away) return sky(along) * Real(0.6);
        switch (world_.estimate) {
            case Estimate::soft_shadow: return from_lamp(hit);
            case Estimate::ambient_occlusion: return open_sky(hit);
            case Estimate::interreflection: return bounced(hit);
            case Estimate::depth_of_field: return from_sun(hit);
        }
        return vec3(0);
    }

    vec3 from_lamp(const Hit& hit)
    {
        const vec2 on_lamp = flaw_ == Flaw::light_as_point ? vec2(0) : in_square() * Real(2) - Real(1);
        const Real half = world_.lamp_half;
        const vec3 lamp = vec3(world_.lamp) + half * vec3(on_lamp.x, 0, on_lamp.y);
        const vec3 way = lamp - hit.place;
        const Real distance = glm::length(way);
        const vec3 l = way / distance;
        Real cosine = glm::dot(hit.normal, l);
        if (cosine <= 0) return vec3(Real(0.04)) * hit.color;
        if (flaw_ == Flaw::cosine_missing) cosine = 1;
        if (flaw_ != Flaw::shadow_missing && first_hit(hit.place + lift * hit.normal, l).distance < distance)
            return vec3(Real(0.04)) * hit.color;
        const Real area = 4 * half * half;
        return hit.color * (Real(0.04) + Real(world_.lamp_power) / pi * cosine * std::max(l.y, Real(0)) * area /
                                             (distance * distance));
    }

    /// The directions' density is cosine / pi, or 1 / (2 pi) for uniform ones; so the weight of a direction is 1, or
    /// twice the cosine.
    vec3 open_sky(const Hit& hit)
    {
        const bool evenly = way_ == Way::uniform_sampling || flaw_ == Flaw::pdf_mismatch;
        const vec3 along = direction(hit.normal, in_square(), evenly);
        const Real weight = way_ == Way::uniform_sampling ? 2 * glm::dot(along, hit.normal) : Real(1);
        const bool open =
            flaw_ == Flaw::shadow_missing || first_hit(hit.place + lift * hit.normal, along).distance == far_away;
        return open ? hit.color * weight * Real(0.8) : vec3(0);
    }

    vec3 bounced(Hit hit)
    {
        vec3 share = hit.color;
        for (int bounce = 0; bounce < 4; ++bounce) {
            const bool evenly = way_ == Way::uniform_sampling || flaw_ == Flaw::pdf_mismatch;
            const vec3 along = direction(hit.normal, bounce == 0 ? in_square() : pair(), evenly);
            if (way_ == Way::uniform_sampling) share *= 2 * glm::dot(along, hit.normal);
            const Hit next = first_hit(hit.place + lift * hit.normal, along);
            if (next.distance == far_away) return share * sky(along);
            if (flaw_ == Flaw::bounce_missing) return vec3(0);
            share *= next.color;
            hit = next;
        }
        return vec3(0);
    }

    [[nodiscard]] vec3 from_sun(const Hit& hit) const
    {
        const vec3 l = glm::normalize(vec3(Real(0.6), 1, Real(0.5)));
        const Real cosine = flaw_ == Flaw::cosine_missing ? Real(1) : std::max(glm::dot(hit.normal, l), Real(0));
        const bool dark =
            flaw_ != Flaw::shadow_missing && first_hit(hit.place + lift * hit.normal, l).distance < far_away;
        return hit.color * (Real(0.25) + (dark ? Real(0) : Real(0.7) * cosine));
    }

    const Traced& world_;
    Flaw flaw_;
    Way way_;
    Random random_;
    int side_ = 1;
    int sample_ = 0;
    vec3 eye_{0}, forward_{0}, right_{0}, up_{0};
    Real half_ = 1;
    Real strength_ = 1;
};

}

namespace UMBRAL_BUILD {

Image trace(const Traced& world, Flaw flaw, Way way) { return Tracer(world, flaw, way).picture(); }

}

}
