#pragma once

#include <umbral/interaction/pick_ray.hpp>

namespace umbral::interaction {

/// The unit's functions, as one solution defines them.
struct PickRayFunctions {
    decltype(&pick_pixel) pixel;
    decltype(&pick_ray) ray;
};

}
