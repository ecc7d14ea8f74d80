#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/outlined.hpp>

namespace umbral::pipeline {

// Classes of your own that derive from OutlinedDrawing go here.

void send_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges)
{
    // TODO: glVertexAttrib3f(1, ...) says the colour; glBegin, a glVertex2f for each corner, glEnd; twice.
    // Delete the next line.
    (void)not_implemented<int>(corners, fill, edges);
}

std::unique_ptr<OutlinedDrawing> make_outlined_polygon(const std::vector<glm::vec2>& corners)
{
    // TODO: one vertex array, one buffer of corners; draw() calls glDrawArrays twice.
    return not_implemented<std::unique_ptr<OutlinedDrawing>>(corners);
}

std::unique_ptr<OutlinedDrawing> make_outlined_triangles(const std::vector<glm::vec2>& positions,
                                                         const std::vector<std::uint32_t>& indices)
{
    // TODO: one vertex array, two buffers; draw() calls glDrawElements twice, the second time in the mode GL_LINE.
    return not_implemented<std::unique_ptr<OutlinedDrawing>>(positions, indices);
}

}
