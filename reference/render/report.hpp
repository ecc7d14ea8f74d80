#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "render/counters.hpp"
#include "render/effects.hpp"
#include "render/rays/ray_effects.hpp"

namespace umbral::render {

/// What umbral-render says about a picture; what is not given is left out.
struct Report {
    std::string scene;
    std::string title;
    std::string renderer;  ///< as --renderer takes it
    int width = 0;
    int height = 0;
    int samples = 1;
    std::string out;  ///< the picture's file, empty if none was written
    Derived derived;
    std::vector<rays::RayEffect> ray_effects;
    bool follows_rays = false;  ///< the renderer draws those too
    bool all_effects = false;   ///< the kernel with all effects was used, not the derived one
    std::string how;            ///< how the renderer leaves effects out
    std::vector<Count> counts;  ///< empty: not counted
};

/// The set of effects with its reasons, and all counters.
[[nodiscard]] std::string explanation(const Report& report);

/// Everything, as JSON.
[[nodiscard]] nlohmann::json to_json(const Report& report);

}
