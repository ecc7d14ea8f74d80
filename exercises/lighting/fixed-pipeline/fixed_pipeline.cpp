#include <umbral/gl/opengl.hpp>
#include <umbral/lighting/fixed_pipeline.hpp>

namespace umbral::lighting {

void set_lighting(const FrameLighting& lighting, const glm::mat4& view)
{
    // TODO: each light's position, through the right modelview matrix, its colours, and all that could weaken it; then
    // the light model (ambient light, viewer, two sides), the shade model, and normals of any length.
    // Delete the next line.
    (void)not_implemented<int>(lighting, view);
}

void set_material(const Material& material)
{
    // TODO: four colours and an exponent, for front and back.
    // Delete the next line.
    (void)not_implemented<int>(material);
}

void draw_lit(const LitScene& scene)
{
    // TODO: keep the state; matrices, lighting; for each thing its matrix, its front face, its material, one draw call;
    // put the state back.
    // Delete the next line.
    (void)not_implemented<int>(scene);
}

}
