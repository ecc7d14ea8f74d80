#pragma once

#include <array>
#include <string>

#include "render/draw_list.hpp"

namespace umbral::render {

/// What a scene may call for, beside what every picture has. Each is a compile-time flag of the kernels: without it,
/// its code is not there. What comes in any number (lights, instances) is a list instead: an empty one costs nothing.
struct EffectSet {
    bool textured = false;  ///< a texture is looked up at every pixel
    bool specular = false;  ///< highlights are added
    bool smooth =
        false;  ///< normals are interpolated and made unit at every pixel; otherwise one serves a whole triangle
    bool positional = false;  ///< the way to a light differs from pixel to pixel
    bool two_sided = false;   ///< triangles seen from behind are drawn too, with their normal turned
    bool clipped = false;     ///< triangles may reach beyond what the rasteriser takes
    friend constexpr bool operator==(const EffectSet&, const EffectSet&) = default;
};

/// In the order of their bits in a set's number. The first ones are what is done to a fragment, the others to a
/// triangle.
inline constexpr std::array<bool EffectSet::*, 6> effect_flags = {&EffectSet::textured,  &EffectSet::specular,
                                                                  &EffectSet::smooth,    &EffectSet::positional,
                                                                  &EffectSet::two_sided, &EffectSet::clipped};
inline constexpr std::array<const char*, 6> effect_names = {"textured",   "specular",  "smooth",
                                                            "positional", "two_sided", "clipped"};
inline constexpr std::size_t fragment_effects = 4;
inline constexpr std::size_t effect_set_count = std::size_t{1} << effect_flags.size();

/// Sets are numbered from 0 (no effect) to effect_set_count - 1 (all).
[[nodiscard]] constexpr EffectSet effect_set(std::size_t number)
{
    EffectSet set;
    for (std::size_t i = 0; i < effect_flags.size(); ++i) set.*effect_flags[i] = ((number >> i) & 1U) != 0;
    return set;
}
[[nodiscard]] constexpr std::size_t number_of(const EffectSet& set)
{
    std::size_t number = 0;
    for (std::size_t i = 0; i < effect_flags.size(); ++i)
        number |= (set.*effect_flags[i] ? std::size_t{1} : std::size_t{0}) << i;
    return number;
}
inline constexpr EffectSet all_effects = effect_set(effect_set_count - 1);

/// The effects that a scene calls for, and why: one sentence for each effect, in the order of effect_flags.
struct Derived {
    EffectSet set;
    std::array<std::string, effect_flags.size()> why;
};

/// Instances that cannot be seen ask for nothing.
[[nodiscard]] Derived derive_effects(const DrawList& list, const scene::Scene& scene);

}
