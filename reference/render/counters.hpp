#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace umbral::render {

/// Work done for one picture. What belongs to an effect is counted where that work is done, inside the kernel: without
/// the effect there is neither work nor counting.
struct Counters {
    std::uint64_t instances = 0;
    std::uint64_t instances_outside = 0;
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t triangles_from_behind = 0;  ///< dropped
    std::uint64_t triangles_rasterized = 0;   ///< after clipping, which may make several of one
    std::uint64_t fragments = 0;
    std::uint64_t depth_rejects = 0;
    std::uint64_t fragments_shaded = 0;
    std::uint64_t light_evaluations = 0;
    std::uint64_t texture_lookups = 0;
    std::uint64_t specular_evaluations = 0;
    std::uint64_t normals_interpolated = 0;
    std::uint64_t light_directions = 0;  ///< ways to a light's place that were computed
    std::uint64_t triangles_turned = 0;  ///< seen from behind, drawn with their normal turned
    std::uint64_t clip_tests = 0;        ///< vertices compared with the planes
    std::uint64_t triangles_clipped = 0;
    friend bool operator==(const Counters&, const Counters&) = default;
};

/// A counter with its name, and the effect without which it stays 0 (nullptr: none).
struct NamedCounter {
    const char* name;
    std::uint64_t Counters::*value;
    const char* effect;
};

inline constexpr std::array<NamedCounter, 17> all_counters = {{
    {"instances", &Counters::instances, nullptr},
    {"instances outside", &Counters::instances_outside, nullptr},
    {"vertices", &Counters::vertices, nullptr},
    {"triangles", &Counters::triangles, nullptr},
    {"triangles from behind", &Counters::triangles_from_behind, nullptr},
    {"triangles rasterized", &Counters::triangles_rasterized, nullptr},
    {"fragments", &Counters::fragments, nullptr},
    {"depth rejects", &Counters::depth_rejects, nullptr},
    {"fragments shaded", &Counters::fragments_shaded, nullptr},
    {"light evaluations", &Counters::light_evaluations, nullptr},
    {"texture lookups", &Counters::texture_lookups, "textured"},
    {"specular evaluations", &Counters::specular_evaluations, "specular"},
    {"normals interpolated", &Counters::normals_interpolated, "smooth"},
    {"light directions", &Counters::light_directions, "positional"},
    {"triangles turned", &Counters::triangles_turned, "two_sided"},
    {"clip tests", &Counters::clip_tests, "clipped"},
    {"triangles clipped", &Counters::triangles_clipped, "clipped"},
}};

/// What OpenGL was handed for one picture, counted where it is handed over. It does not tell what it does with it,
/// except how many samples passed the depth test, where that is asked (drawing waits for the answer).
struct OpenGlWork {
    bool ask_samples = false;
    std::uint64_t instances = 0;
    std::uint64_t instances_outside = 0;
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t samples = 0;
    std::uint64_t textures = 0;
    std::uint64_t texels = 0;
    std::uint64_t textured_samples = 0;
    std::uint64_t highlights = 0;       ///< instances drawn with a specular colour
    std::uint64_t smooth = 0;           ///< instances drawn with normals interpolated
    std::uint64_t light_places = 0;     ///< lights with a place
    std::uint64_t without_culling = 0;  ///< instances of which both sides are drawn
    std::uint64_t crossing = 0;         ///< instances that may need clipping, which OpenGL does itself
};

/// A counter of either kind, as it is printed.
struct Count {
    const char* name;
    std::uint64_t value;
    const char* effect;  ///< without which it is 0 (nullptr: none)
};
[[nodiscard]] std::vector<Count> counts_of(const Counters& counters);
[[nodiscard]] std::vector<Count> counts_of(const OpenGlWork& work);

}
