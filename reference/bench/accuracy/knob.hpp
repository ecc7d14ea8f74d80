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

/// One knob: a file of its own with one function, and a line in knobs.cpp.
struct KnobEntry {
    const char* id;
    Knob (*measure)(Means& means);
};

/// All knobs there are.
[[nodiscard]] std::span<const KnobEntry> all_knobs();

[[nodiscard]] Knob measure_ray_sphere(Means& means);
[[nodiscard]] Knob measure_tessellation(Means& means);

}
