#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/counters.hpp"

namespace umbral::render::rays {

/// Rays of each kind that were followed for one picture. Without the effect a kind stays 0.
struct RayCounts {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;
    std::uint64_t soft = 0;  ///< of the shadow rays: to a point of a light that has a size
    std::uint64_t mirrored = 0;
    std::uint64_t refracted = 0;
    std::uint64_t bounced = 0;
    std::uint64_t bumped = 0;  ///< no rays: normals that a bump map bent
};

inline constexpr std::array<std::uint64_t RayCounts::*, 7> ray_kinds = {
    &RayCounts::camera,    &RayCounts::shadow,  &RayCounts::soft,  &RayCounts::mirrored,
    &RayCounts::refracted, &RayCounts::bounced, &RayCounts::bumped};
inline constexpr std::array<const char*, 7> ray_kind_names = {
    "camera rays",    "shadow rays",           "rays to parts of lights",  "mirrored rays",
    "refracted rays", "rays between surfaces", "normals bent by bump maps"};

inline void operator+=(RayCounts& sum, const RayCounts& more)
{
    for (const auto kind : ray_kinds) sum.*kind += more.*kind;
}

[[nodiscard]] inline std::vector<Count> counts_of(const RayCounts& counts)
{
    std::vector<Count> all;
    for (std::size_t i = 0; i < ray_kinds.size(); ++i)
        all.push_back({ray_kind_names[i], counts.*ray_kinds[i], nullptr});
    return all;
}

}
