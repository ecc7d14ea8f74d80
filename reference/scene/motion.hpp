#pragma once

#include "scene/scene.hpp"

/// Scenes that move, at one moment.
namespace umbral::scene {

/// What `transform` is at a time in seconds: a Translate, a Rotate or a Scale. Computed in double, rounded once; turns
/// are taken modulo 360 degrees, so that no precision is lost in long films.
[[nodiscard]] Transform at_time(const Transform& transform, double seconds);

/// The scene at that time, in which nothing moves.
[[nodiscard]] Scene at_time(Scene scene, double seconds);

/// Does it depend on time?
[[nodiscard]] bool moves(const Instance& instance);

/// Does any instance?
[[nodiscard]] bool moves(const Scene& scene);

}
