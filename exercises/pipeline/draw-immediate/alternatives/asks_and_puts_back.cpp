// alternative: asks for each piece of state, and puts it back by itself; fills with GL_POLYGON
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/immediate.hpp>

namespace umbral::pipeline {
namespace {

template <class Pass>
void two_passes(const std::vector<glm::vec2>& table, const glm::vec3& fill, const glm::vec3& edges, Pass draw)
{
    GLint buffer = 0;
    GLint modes[2] = {};
    GLfloat color[4] = {};
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &buffer);
    glGetIntegerv(GL_POLYGON_MODE, modes);
    glGetFloatv(GL_CURRENT_COLOR, color);

    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glVertexPointer(2, GL_FLOAT, sizeof(glm::vec2), table.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glColor3f(fill.r, fill.g, fill.b);
    draw(false);
    glDepthFunc(GL_LEQUAL);
    glColor3f(edges.r, edges.g, edges.b);
    draw(true);

    glDepthFunc(GL_LESS);
    glPolygonMode(GL_FRONT, static_cast<GLenum>(modes[0]));
    glPolygonMode(GL_BACK, static_cast<GLenum>(modes[1]));
    glDisableClientState(GL_VERTEX_ARRAY);
    glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer));
    glColor4fv(color);
}

}

void draw_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges)
{
    two_passes(corners, fill, edges, [&](bool outline) {
        glDrawArrays(outline ? GL_LINE_LOOP : GL_POLYGON, 0, static_cast<GLsizei>(corners.size()));
    });
}

void draw_triangles(const std::vector<glm::vec2>& positions, const std::vector<std::uint32_t>& indices,
                    const glm::vec3& fill, const glm::vec3& edges)
{
    two_passes(positions, fill, edges, [&](bool outline) {
        if (outline) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, indices.data());
    });
}

}
