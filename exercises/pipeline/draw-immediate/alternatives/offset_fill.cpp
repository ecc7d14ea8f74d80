// alternative: keeps GL_LESS, and pushes the fill back with a polygon offset; draws as interleaved arrays
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/immediate.hpp>

namespace umbral::pipeline {
namespace {

void begin(const glm::vec2* table)
{
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glInterleavedArrays(GL_V2F, 0, table);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, 1);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void end()
{
    glPopClientAttrib();
    glPopAttrib();
}

}

void draw_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges)
{
    begin(corners.data());
    const auto count = static_cast<int>(corners.size());
    glColor3f(fill.x, fill.y, fill.z);
    glDrawArrays(GL_TRIANGLE_FAN, 0, count);
    glColor3f(edges.x, edges.y, edges.z);
    glDrawArrays(GL_LINE_LOOP, 0, count);
    end();
}

void draw_triangles(const std::vector<glm::vec2>& positions, const std::vector<std::uint32_t>& indices,
                    const glm::vec3& fill, const glm::vec3& edges)
{
    begin(positions.data());
    for (const bool outline : {false, true}) {
        const glm::vec3 color = outline ? edges : fill;
        glColor3f(color.x, color.y, color.z);
        if (outline) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glDrawElements(GL_TRIANGLES, static_cast<int>(indices.size()), GL_UNSIGNED_INT, indices.data());
    }
    end();
}

}
