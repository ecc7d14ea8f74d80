#include <umbral/raytracing/shadow_polygons.hpp>

namespace umbral::raytracing {

FlatPolygon shadow_polygon(const glm::vec4& light, const FlatPolygon& caster, const FlatPolygon& receiver)
{
    // TODO: cut the caster to what lies between light and receiver, then project what is left
    return not_implemented<FlatPolygon>(light, caster, receiver);
}

glm::mat4 mirror_matrix(const glm::vec4& plane)
{
    // TODO: p' = p - 2 (n·p + w) / (n·n) n, as a matrix
    return not_implemented<glm::mat4>(plane);
}

glm::mat4 mirrored_view(const glm::mat4& view, const glm::vec4& plane)
{
    // TODO: which acts first, the mirror or the camera?
    return not_implemented<glm::mat4>(view, plane);
}

std::vector<MirrorView> mirror_views(const glm::vec3& eye, const std::vector<FlatPolygon>& mirrors, int levels)
{
    // TODO: for each mirror before which the eye stands: its window, the mirrored eye, and how it goes on from there
    return not_implemented<std::vector<MirrorView>>(eye, mirrors, levels);
}

}
