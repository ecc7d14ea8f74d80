// Based on: E. Catmull. A Subdivision Algorithm for Computer Display of Curved Surfaces. 1974: the Z-buffer. T. Porter,
// T. Duff. Compositing Digital Images. SIGGRAPH 1984: what comes through, added to what is there.

#include <algorithm>
#include <limits>
#include <umbral/raytracing/transparent_z_buffer.hpp>

namespace umbral::raytracing {
namespace {

// Whether a fragment lies in the frame, nearer than what is there. No comparison with NaN is true.
template <class Fragment>
bool visible(const GlassFrame& frame, const Fragment& fragment)
{
    const int x = fragment.pixel.x;
    const int y = fragment.pixel.y;
    return frame.depths.contains(x, y) && fragment.depth < frame.depths.at(x, y);
}

}

GlassFrame empty_glass_frame(int width, int height, const glm::vec3& background)
{
    return {Grid<glm::vec3>(width, height, background),
            Grid<float>(width, height, std::numeric_limits<float>::infinity())};
}

void draw_opaque(GlassFrame& frame, const std::vector<OpaqueFragment>& fragments)
{
    for (const OpaqueFragment& fragment : fragments) {
        if (!visible(frame, fragment)) continue;
        frame.light.at(fragment.pixel.x, fragment.pixel.y) = fragment.light;
        frame.depths.at(fragment.pixel.x, fragment.pixel.y) = fragment.depth;
    }
}

void filter_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments)
{
    for (const GlassFragment& fragment : fragments)
        if (visible(frame, fragment)) frame.light.at(fragment.pixel.x, fragment.pixel.y) *= fragment.k_t * fragment.m_t;
}

void blend_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments)
{
    std::vector<const GlassFragment*> order;
    for (const GlassFragment& fragment : fragments)
        if (visible(frame, fragment)) order.push_back(&fragment);
    // Each pixel's fragments keep their order among others', so one sort does for all pixels.
    std::stable_sort(order.begin(), order.end(),
                     [](const GlassFragment* a, const GlassFragment* b) { return a->depth > b->depth; });
    for (const GlassFragment* fragment : order) {
        glm::vec3& light = frame.light.at(fragment->pixel.x, fragment->pixel.y);
        light = fragment->light + fragment->k_t * fragment->m_t * light;
    }
}

}
