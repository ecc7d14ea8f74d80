#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>
#include <umbral/interaction/camera_animation.hpp>
#include <umbral/record/variation.hpp>

/// Flights for the camera-animation unit.
namespace umbral::interaction {

/// A flight within about `reach` of the origin, whose camera never looks near the y axis: what it sees lies at least 1
/// before a plane through it that is upright.
inline CameraFlight random_flight(Random& random, float reach = 8)
{
    const glm::mat3 turn(glm::rotate(glm::mat4(1), random.uniform(-3.2F, 3.2F), glm::vec3(0, 1, 0)));
    const auto ahead = [&] {
        const float side = random.uniform(-3, 3);
        const float up = random.uniform(-3, 3);
        return turn * glm::vec3(side, up, random.uniform(-6, -1.2F));
    };
    CameraFlight flight;
    flight.eye_from = reach * random.in_cube();
    flight.eye_to = reach * random.in_cube();
    flight.target_from = flight.eye_from + ahead();
    flight.target_to = flight.eye_to + ahead();
    flight.duration = std::pow(10.0F, random.uniform(-2, 4));
    return flight;
}

/// Any size that a duration can have, from the smallest float to the largest.
inline float any_duration(Random& random) { return std::exp2(random.uniform(-148, 127.5F)); }

/// The same flight between other places, if inputs are to vary; who stands still at the same place remains there.
inline CameraFlight varied(Variation& vary, CameraFlight flight)
{
    const auto move = [&](glm::vec3& from, glm::vec3& to) {
        const bool stands = from == to;
        from = vary.near(from, 0.4F);
        to = stands ? from : vary.near(to, 0.4F);
    };
    move(flight.eye_from, flight.eye_to);
    move(flight.target_from, flight.target_to);
    return flight;
}

}
