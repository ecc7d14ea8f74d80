// Prints the two tables of the statement of interaction/keyframes: how far an even mixture of quaternions is from
// slerp, and how high a ball comes whose steps are as long as its pictures. Usage: keyframes-accuracy

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <interaction/keyframes/motions.hpp>
#include <numbers>

using namespace umbral::interaction;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The worst angle between slerp and the mixture made unit, on the way through a turn.
double worst_of_mixture(double angle)
{
    double worst = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double u = i / 1000.0;
        const double mixed = 2 * std::atan2(u * std::sin(angle / 2), (1 - u) + u * std::cos(angle / 2));
        const UnitQuaternion exact = slerp_shorter({}, about({0, 0, 1}, angle), static_cast<float>(u));
        worst = std::max(worst, std::abs(mixed - 2 * std::atan2(double{exact.v.z}, double{exact.w})));
    }
    return worst;
}

/// Dropped from 1 m; one step for each picture.
double height_of_bounce(double step)
{
    double y = 1;
    double velocity = 0;
    double highest = 0;
    for (int bounces = 0; bounces < 2;) {
        velocity -= 9.81 * step;
        y += step * velocity;
        if (y < 0) {
            y = 0;
            velocity *= -0.8;
            ++bounces;
        }
        if (bounces == 1) highest = std::max(highest, y);
    }
    return highest;
}

}

int main()
{
    std::printf("turn in degrees: the mixture is off by as many degrees\n");
    for (const double angle : {10.0, 30.0, 60.0, 90.0, 120.0, 170.0})
        std::printf("%6.0f %10.4f\n", angle, worst_of_mixture(angle * degree) / degree);
    std::printf("pictures a second: height of the first bounce in metres\n");
    for (const double rate : {10.0, 30.0, 60.0, 144.0, 200.0, 1000.0})
        std::printf("%6.0f %10.3f\n", rate, height_of_bounce(1 / rate));
}
