#include <array>

#include "knob.hpp"

namespace umbral::bench {

std::span<const KnobEntry> all_knobs()
{
    static constexpr std::array knobs = {KnobEntry{"ray-sphere", measure_ray_sphere},
                                         KnobEntry{"tessellation", measure_tessellation}};
    return knobs;
}

}
