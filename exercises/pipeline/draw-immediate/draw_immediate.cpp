#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/immediate.hpp>

namespace umbral::pipeline {

void draw_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges)
{
    // TODO: tell OpenGL where the table is (glEnableClientState, glVertexPointer), and draw all of it twice: once to
    // fill, once for the edges. Beware of a buffer that is bound, and of edges as deep as the fill. Put all state back.
    // Delete the next line.
    (void)not_implemented<int>(corners, fill, edges);
}

void draw_triangles(const std::vector<glm::vec2>& positions, const std::vector<std::uint32_t>& indices,
                    const glm::vec3& fill, const glm::vec3& edges)
{
    // TODO: the same with glDrawElements. What makes OpenGL draw triangles as lines? Delete the next line.
    (void)not_implemented<int>(positions, indices, fill, edges);
}

}
