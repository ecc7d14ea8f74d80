#pragma once

#include <umbral/core/grid.hpp>

#include "operators.hpp"
#include "scene/scene.hpp"

/// The same operators on what the engine draws: a flaw is a change of the scene, since the engine itself is right.
namespace umbral::bench::scenes {

/// Puts the flaw into the scene; one that only a finished picture or a painter can have leaves it as it is.
void spoil(umbral::scene::Scene& scene, Flaw flaw);

/// Can this scene show the flaw, as far as its data tells: are there textures, mirrors, lights of a size …?
[[nodiscard]] bool can_show(const umbral::scene::Scene& scene, Flaw flaw);

/// The scene in another right way: lights or things in another order, or everything moved together with the camera.
void rearrange(umbral::scene::Scene& scene, Way way);

/// Gamma and levels of a finished picture, as the flaw has them.
[[nodiscard]] Image recoded(Image image, Flaw flaw);

}
