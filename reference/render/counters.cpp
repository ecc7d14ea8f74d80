#include "render/counters.hpp"

namespace umbral::render {

std::vector<Count> counts_of(const Counters& counters)
{
    std::vector<Count> counts;
    for (const NamedCounter& one : all_counters) counts.push_back({one.name, counters.*one.value, one.effect});
    return counts;
}

std::vector<Count> counts_of(const OpenGlWork& work)
{
    return {{"instances", work.instances, nullptr},
            {"instances outside", work.instances_outside, nullptr},
            {"vertices", work.vertices, nullptr},
            {"triangles", work.triangles, nullptr},
            {"samples passed", work.samples, nullptr},
            {"textures made", work.textures, "textured"},
            {"texels sent", work.texels, "textured"},
            {"samples with a texture", work.textured_samples, "textured"},
            {"instances with highlights", work.highlights, "specular"},
            {"smooth instances", work.smooth, "smooth"},
            {"lights with a place", work.light_places, "positional"},
            {"instances without culling", work.without_culling, "two_sided"},
            {"instances crossing the view volume", work.crossing, "clipped"}};
}

}
