#pragma once

#include "call.hpp"

/// The calls of each topic; with the oracles, the same in their namespace.
namespace umbral::bench {

[[nodiscard]] std::vector<stability::Call> transforms_calls();
[[nodiscard]] std::vector<stability::Call> projections_calls();
[[nodiscard]] std::vector<stability::Call> lighting_calls();
[[nodiscard]] std::vector<stability::Call> raytracing_calls();
[[nodiscard]] std::vector<stability::Call> texturing_calls();

/// All of them.
[[nodiscard]] std::vector<stability::Call> all_calls();

}
