// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 4.5, Compatibility Profile).
// 2017.

#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/immediate.hpp>

namespace umbral::pipeline {
namespace {

/// Puts back, at the end of its life, what the functions below change.
class StateKeeper {
public:
    StateKeeper()
    {
        glPushAttrib(GL_CURRENT_BIT | GL_POLYGON_BIT);
        glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    }
    StateKeeper(const StateKeeper&) = delete;
    StateKeeper& operator=(const StateKeeper&) = delete;
    ~StateKeeper()
    {
        glDepthFunc(GL_LESS);
        glPopClientAttrib();
        glPopAttrib();
    }
};

void prepare(const std::vector<glm::vec2>& positions)
{
    // With a buffer bound, the pointer would be taken for an offset into it.
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, positions.data());
    // Edges are exactly as deep as the fill beneath them: GL_LESS would hide them.
    glDepthFunc(GL_LEQUAL);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}

void draw_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges)
{
    const StateKeeper keeper;
    const auto count = static_cast<GLsizei>(corners.size());
    prepare(corners);
    glColor3fv(&fill.r);
    glDrawArrays(GL_TRIANGLE_FAN, 0, count);
    glColor3fv(&edges.r);
    glDrawArrays(GL_LINE_LOOP, 0, count);
}

void draw_triangles(const std::vector<glm::vec2>& positions, const std::vector<std::uint32_t>& indices,
                    const glm::vec3& fill, const glm::vec3& edges)
{
    const StateKeeper keeper;
    const auto count = static_cast<GLsizei>(indices.size());
    prepare(positions);
    glColor3fv(&fill.r);
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, indices.data());
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glColor3fv(&edges.r);
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, indices.data());
}

}
