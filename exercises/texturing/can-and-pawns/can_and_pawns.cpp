#include <umbral/gl/opengl.hpp>
#include <umbral/input/glfw.hpp>
#include <umbral/meshes/ply.hpp>
#include <umbral/texturing/lab4_program.hpp>

namespace umbral::texturing {

NormalTables normals_of(const meshes::IndexedMesh& mesh)
{
    // TODO: line 1 of the rubric. One pass over the triangles: each normal goes into the table of the faces, and into
    // the sums of its three corners. Then give the sums length 1. Delete the next line.
    return not_implemented<NormalTables>(mesh);
}

void draw(const LitMesh& mesh, Shading shading)
{
    // TODO: line 2. glShadeModel, glBegin(GL_TRIANGLES), and for each corner normal, coordinates, place. Delete the
    // next line.
    (void)not_implemented<int>(mesh, shading);
}

Revolved revolve(std::span<const glm::vec2> profile, std::uint32_t copies)
{
    // TODO: line 3. First the lengths of the profile up to each point, then the copies, then the triangles. Delete the
    // next line.
    return not_implemented<Revolved>(profile, copies);
}

void activate_texture(LabTexture& texture)
{
    // TODO: line 4. Enable, bind (the first time: make the name, and give OpenGL the texels), generate or not. Delete
    // the next line.
    (void)not_implemented<int>(texture);
}

Materials make_materials(LabTexture& label, LabTexture& wood)
{
    // TODO: line 5. The table of the interface. Delete the next line.
    return not_implemented<Materials>(label, wood);
}

void activate_material(const Material& material)
{
    // TODO: line 5. Lighting on, glMaterial, then the texture, or none. Delete the next line.
    (void)not_implemented<int>(material);
}

glm::vec3 direction(float alpha, float beta)
{
    // TODO: line 6. Delete the next line.
    return not_implemented<glm::vec3>(alpha, beta);
}

void activate_lights(std::span<const Light> lights, const glm::mat4& view)
{
    // TODO: line 6. Beware of the modelview matrix, by which glLight takes places and directions. Delete the next line.
    (void)not_implemented<int>(lights, view);
}

void run_lab4(const Files& files, EarlierLabs& earlier)
{
    // TODO: the program, with the real GLFW: window, callbacks (glfwSetWindowUserPointer leads them to your data),
    // loop. Delete the next line.
    (void)not_implemented<int>(files, earlier);
}

}
