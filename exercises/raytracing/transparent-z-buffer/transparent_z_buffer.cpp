#include <umbral/raytracing/transparent_z_buffer.hpp>

namespace umbral::raytracing {

GlassFrame empty_glass_frame(int width, int height, const glm::vec3& background)
{
    // TODO: how far away is nothing?
    return not_implemented<GlassFrame>(width, height, background);
}

void draw_opaque(GlassFrame& frame, const std::vector<OpaqueFragment>& fragments)
{
    // TODO: for each fragment in the frame: is it nearer than what is there?
    (void)not_implemented<int>(frame, fragments);
}

void filter_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments)
{
    // TODO: I = k_t M_t I
    (void)not_implemented<int>(frame, fragments);
}

void blend_glass(GlassFrame& frame, const std::vector<GlassFragment>& fragments)
{
    // TODO: I = I_m + k_t M_t I, from the farthest to the nearest
    (void)not_implemented<int>(frame, fragments);
}

}
