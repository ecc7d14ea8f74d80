#pragma once

#include <memory>
#include <string_view>
#include <umbral/record/ask.hpp>

#include "motions.hpp"

/// The cases of the keyframes unit about balls.
namespace umbral::interaction {

/// A ball's places at common times of all rates: every half second.
inline void record_path(Recorder& out, const BallLaunch& launch, std::int64_t rate, std::string_view name)
{
    const std::unique_ptr<BouncingBall> ball = ask_new<make_bouncing_ball>(out, "ball", launch);
    if (!ball) return;
    for (std::int64_t k = 1; k <= 4 * rate; ++k) {
        ask<&BouncingBall::advance>(out, *ball, frame_time(k, rate) - frame_time(k - 1, rate));
        if (k % (rate / 2) == 0) out.append(name, glm::vec3(ask<&BouncingBall::position>(out, *ball)));
    }
}

inline void record_rates(Recorder& out, Random& random)
{
    for (int i = 0; i < 6; ++i) {
        const BallLaunch launch = random_launch(random);
        record_path(out, launch, 10, "10 a second");
        record_path(out, launch, 60, "60 a second");
        record_path(out, launch, 144, "144 a second");
    }
}

// Pictures at odd times, some of them before the first step; times that stand still or go back change nothing.
inline void record_odd_times(Recorder& out, Random& random)
{
    const auto record_after = [&](BouncingBall& ball, std::int64_t microseconds) {
        ask<&BouncingBall::advance>(out, ball, microseconds);
        out.append("place", glm::vec3(ask<&BouncingBall::position>(out, ball)));
    };
    for (int i = 0; i < 8; ++i) {
        const std::unique_ptr<BouncingBall> ball = ask_new<make_bouncing_ball>(out, "ball", random_launch(random));
        if (!ball) continue;
        out.append("place", glm::vec3(ask<&BouncingBall::position>(out, *ball)));
        for (int k = 0; k < 24; ++k) {
            const std::uint32_t kind = random.below(6);
            const std::int64_t some = 1 + random.below(kind < 3 ? 4900 : 150'000);
            const std::int64_t nothing = k % 2 == 0 ? 0 : -some;
            record_after(*ball, kind == 5 ? nothing : some);
        }
    }
    for (const BallLaunch& launch : special_launches(random)) {
        const std::unique_ptr<BouncingBall> ball = ask_new<make_bouncing_ball>(out, "ball", launch);
        if (!ball) continue;
        for (int k = 0; k < 12; ++k) record_after(*ball, 60'000 + random.below(60'000));
    }
    // Steep throws, looked at in the air after one long call, in which some have met the floor and kept all of their
    // speed, or only when an hour has gone by in one.
    for (int i = 0; i < 12; ++i) {
        const bool keeps_all = i % 4 == 2;
        const auto ball = ask_new<make_bouncing_ball>(out, "ball", random_throw(random, keeps_all));
        if (!ball) continue;
        const std::int64_t in_the_air = (keeps_all ? 1'500'000 : 260'000) + std::int64_t{random.below(150'000)};
        record_after(*ball, i % 2 == 0 ? in_the_air : 3'600'000'000);
    }
}

/// All the digits of a double.
inline void record_digits_of(Recorder& out, const BouncingBall& ball)
{
    const glm::dvec3 place = ask<&BouncingBall::position>(out, ball);
    out.append("place", glm::dvec2(place.x, place.y));
}

// All the digits of a double, in pictures that come from one microsecond to 20 ms after each other; half of the balls
// come to rest meanwhile.
inline void record_digits(Recorder& out, Random& random)
{
    for (int i = 0; i < 6; ++i) {
        BallLaunch launch = random_launch(random);
        if (i % 2 == 1) launch.bounce -= 0.45;
        const std::unique_ptr<BouncingBall> ball = ask_new<make_bouncing_ball>(out, "ball", launch);
        if (!ball) continue;
        for (int k = 1; k <= 400; ++k) {
            ask<&BouncingBall::advance>(out, *ball, k % 4 == 0 ? 1 : 1 + std::int64_t{random.below(20'000)});
            if (k % 16 == 0) record_digits_of(out, *ball);
        }
    }
    // Balls that bounce so softly that the next step takes nearly all of their speed, or that they soon lie still.
    for (int i = 0; i < 20; ++i) {
        const int steps = 20 + static_cast<int>(random.below(60));
        const double rise =
            std::pow(10.0, i % 2 == 0 ? -3.8 + 0.7 * random.uniform_double() : -3 + 2.2 * random.uniform_double());
        const auto ball = ask_new<make_bouncing_ball>(out, "ball", launch_that_bounces_softly(random, steps, rise));
        if (!ball) continue;
        ask<&BouncingBall::advance>(out, *ball, (steps + 1) * 5'000 + 1'000 + std::int64_t{random.below(3'000)});
        record_digits_of(out, *ball);
        ask<&BouncingBall::advance>(out, *ball, 5'000);
        record_digits_of(out, *ball);
    }
    // Balls that a step leaves a hair above the floor or below it.
    for (int i = 0; i < 12; ++i) {
        const int steps = 20 + static_cast<int>(random.below(60));
        const double height = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, -7 + 3 * random.uniform_double());
        const auto ball = ask_new<make_bouncing_ball>(out, "ball", launch_that_lands(random, steps, height));
        if (!ball) continue;
        for (const std::int64_t time : {steps * 5'000, 1'000, 200'000}) {
            ask<&BouncingBall::advance>(out, *ball, time);
            record_digits_of(out, *ball);
        }
    }
}

/// Two balls in turns; what one is told must not reach the other.
inline void record_two(Recorder& out, Random& random)
{
    const std::unique_ptr<BouncingBall> first = ask_new<make_bouncing_ball>(out, "first", random_launch(random));
    if (!first) return;
    ask<&BouncingBall::advance>(out, *first, 123'456);
    const std::unique_ptr<BouncingBall> second = ask_new<make_bouncing_ball>(out, "second", random_launch(random));
    if (!second) return;
    for (int k = 0; k < 40; ++k) {
        ask<&BouncingBall::advance>(out, random.below(2) == 0 ? *first : *second, 1 + random.below(150'000));
        out.append("place", glm::vec3(ask<&BouncingBall::position>(out, *first)));
        out.append("place", glm::vec3(ask<&BouncingBall::position>(out, *second)));
    }
}

}
