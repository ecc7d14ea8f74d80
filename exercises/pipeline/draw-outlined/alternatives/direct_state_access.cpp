// alternative: one class of functions given to it, objects made by direct state access, indices of 16 bits, glVertex3f
#include <functional>
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/outlined.hpp>

namespace umbral::pipeline {
namespace {

struct Objects final : OutlinedDrawing {
    std::vector<GLuint> buffers;
    GLuint array = 0;
    std::function<void(bool)> pass;

    explicit Objects(const std::vector<glm::vec2>& positions)
    {
        glCreateVertexArrays(1, &array);
        add(positions);
        glVertexArrayVertexBuffer(array, 0, buffers[0], 0, sizeof(glm::vec2));
        glVertexArrayAttribFormat(array, 0, 2, GL_FLOAT, GL_FALSE, 0);
        glVertexArrayAttribBinding(array, 0, 0);
        glEnableVertexArrayAttrib(array, 0);
    }
    Objects(const Objects&) = delete;
    Objects& operator=(const Objects&) = delete;
    ~Objects() override
    {
        glDeleteBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
        glDeleteVertexArrays(1, &array);
    }

    template <class Item>
    void add(const std::vector<Item>& items)
    {
        GLuint name = 0;
        glCreateBuffers(1, &name);
        glNamedBufferData(name, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(), GL_STATIC_DRAW);
        buffers.push_back(name);
    }

    void draw(const glm::vec3& fill, const glm::vec3& edges) override
    {
        glBindVertexArray(array);
        glVertexAttrib3fv(1, &fill.x);
        pass(false);
        glVertexAttrib3fv(1, &edges.x);
        pass(true);
        glBindVertexArray(0);
    }
};

}

void send_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges)
{
    for (const GLenum type : {GL_POLYGON, GL_LINE_LOOP}) {
        glBegin(type);
        for (const glm::vec2& p : corners) {
            glVertexAttrib4f(1, type == GL_POLYGON ? fill.r : edges.r, type == GL_POLYGON ? fill.g : edges.g,
                             type == GL_POLYGON ? fill.b : edges.b, 1);
            glVertex3f(p.x, p.y, 0);
        }
        glEnd();
    }
}

std::unique_ptr<OutlinedDrawing> make_outlined_polygon(const std::vector<glm::vec2>& corners)
{
    auto result = std::make_unique<Objects>(corners);
    const auto count = static_cast<GLsizei>(corners.size());
    result->pass = [count](bool edges) { glDrawArrays(edges ? GL_LINE_LOOP : GL_POLYGON, 0, count); };
    return result;
}

std::unique_ptr<OutlinedDrawing> make_outlined_triangles(const std::vector<glm::vec2>& positions,
                                                         const std::vector<std::uint32_t>& indices)
{
    auto result = std::make_unique<Objects>(positions);
    const bool small = positions.size() <= 65536;
    if (small)
        result->add(std::vector<std::uint16_t>(indices.begin(), indices.end()));
    else
        result->add(indices);
    glVertexArrayElementBuffer(result->array, result->buffers[1]);
    const auto count = static_cast<GLsizei>(indices.size());
    result->pass = [count, small](bool edges) {
        if (edges) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glDrawElements(GL_TRIANGLES, count, small ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT, nullptr);
        if (edges) glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    };
    return result;
}

}
