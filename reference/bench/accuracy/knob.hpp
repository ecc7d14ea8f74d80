#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "measurement.hpp"

namespace umbral::bench {

/// What a measurement may use.
struct Means {
    std::filesystem::path
        units;           ///< where the build keeps the units' libraries: <units>/raytracing/sphere/reference.so
    bool quick = false;  ///< a look in seconds: fewer samples and settings
    std::string gl;      ///< set by a knob that draws: what drew
};

/// One knob: a file of its own in knobs/ with one function, declared below, and a line in knobs.cpp.
struct KnobEntry {
    const char* id;
    Knob (*measure)(Means& means);
};

/// All knobs there are.
[[nodiscard]] std::span<const KnobEntry> all_knobs();

[[nodiscard]] Knob measure_ray_sphere(Means& means);
[[nodiscard]] Knob measure_tessellation(Means& means);
[[nodiscard]] Knob measure_edge_samples(Means& means);
[[nodiscard]] Knob measure_edge_patterns(Means& means);
[[nodiscard]] Knob measure_light_samples(Means& means);
[[nodiscard]] Knob measure_mirror_depth(Means& means);
[[nodiscard]] Knob measure_sdf_tolerance(Means& means);
[[nodiscard]] Knob measure_sdf_steps(Means& means);
[[nodiscard]] Knob measure_shading(Means& means);
[[nodiscard]] Knob measure_texture_filter(Means& means);
[[nodiscard]] Knob measure_depth_format(Means& means);
[[nodiscard]] Knob measure_summation(Means& means);
[[nodiscard]] Knob measure_ray_triangle(Means& means);
[[nodiscard]] Knob measure_orientation(Means& means);
[[nodiscard]] Knob measure_hierarchy(Means& means);
[[nodiscard]] Knob measure_leaf_size(Means& means);
[[nodiscard]] Knob measure_neighbours(Means& means);
[[nodiscard]] Knob measure_normal_weights(Means& means);
[[nodiscard]] Knob measure_rotation_chain(Means& means);
[[nodiscard]] Knob measure_interpolation(Means& means);
[[nodiscard]] Knob measure_shadow_map(Means& means);
[[nodiscard]] Knob measure_time_step(Means& means);
[[nodiscard]] Knob measure_normal_difference(Means& means);

}
