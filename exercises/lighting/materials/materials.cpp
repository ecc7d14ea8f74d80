#include <umbral/lighting/materials.hpp>

namespace umbral::lighting {

std::unique_ptr<SurfaceMaterial> make_material(const Material& reflection, std::shared_ptr<SharedTexture> texture)
{
    // TODO: a class of your own, derived from SurfaceMaterial, that keeps both.
    return not_implemented<std::unique_ptr<SurfaceMaterial>>(reflection, texture);
}

std::unique_ptr<SurfaceMaterial> make_gray_material(float k_ambient, float k_diffuse, float k_specular, float exponent,
                                                    std::shared_ptr<SharedTexture> texture)
{
    // TODO: the same from the course's four numbers.
    return not_implemented<std::unique_ptr<SurfaceMaterial>>(k_ambient, k_diffuse, k_specular, exponent, texture);
}

void draw_graph(const MaterialGraph& graph, DrawingContext& context)
{
    // TODO: go through the root's entries: draw objects, enter nodes, compose transformations, activate materials. What
    // must be as before at the end of a node? Delete the next line.
    (void)not_implemented<int>(graph.root, context.lighting);
}

}
