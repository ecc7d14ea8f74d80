#include <array>

#include "knob.hpp"

namespace umbral::bench {

std::span<const KnobEntry> all_knobs()
{
    static constexpr std::array knobs = {KnobEntry{"ray-sphere", measure_ray_sphere},
                                         KnobEntry{"tessellation", measure_tessellation},
                                         KnobEntry{"edge-samples", measure_edge_samples},
                                         KnobEntry{"edge-patterns", measure_edge_patterns},
                                         KnobEntry{"light-samples", measure_light_samples},
                                         KnobEntry{"mirror-depth", measure_mirror_depth},
                                         KnobEntry{"sdf-tolerance", measure_sdf_tolerance},
                                         KnobEntry{"sdf-steps", measure_sdf_steps},
                                         KnobEntry{"shading", measure_shading},
                                         KnobEntry{"texture-filter", measure_texture_filter},
                                         KnobEntry{"depth-format", measure_depth_format},
                                         KnobEntry{"summation", measure_summation},
                                         KnobEntry{"ray-triangle", measure_ray_triangle},
                                         KnobEntry{"orientation", measure_orientation},
                                         KnobEntry{"hierarchy", measure_hierarchy},
                                         KnobEntry{"leaf-size", measure_leaf_size},
                                         KnobEntry{"neighbours", measure_neighbours},
                                         KnobEntry{"normal-weights", measure_normal_weights},
                                         KnobEntry{"rotation-chain", measure_rotation_chain},
                                         KnobEntry{"interpolation", measure_interpolation},
                                         KnobEntry{"shadow-map", measure_shadow_map},
                                         KnobEntry{"time-step", measure_time_step},
                                         KnobEntry{"normal-difference", measure_normal_difference}};
    return knobs;
}

}
