// alternative: OpenGL 4.5's direct state access, which names objects instead of binding them
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/draw.hpp>

namespace umbral::pipeline {
namespace {

struct NamedDrawing : IndexedDrawing {
    GLuint array = 0;
    std::array<GLuint, 3> buffers{};
    GLsizei count;

    explicit NamedDrawing(const ColoredMesh& mesh) : count(static_cast<GLsizei>(mesh.indices.size()))
    {
        glCreateVertexArrays(1, &array);
        glCreateBuffers(3, buffers.data());
        const auto bytes = [](const auto& items) { return static_cast<GLsizeiptr>(items.size() * sizeof items[0]); };
        glNamedBufferData(buffers[0], bytes(mesh.positions), mesh.positions.data(), GL_STATIC_DRAW);
        glNamedBufferData(buffers[1], bytes(mesh.colors), mesh.colors.data(), GL_STATIC_DRAW);
        glNamedBufferData(buffers[2], bytes(mesh.indices), mesh.indices.data(), GL_STATIC_DRAW);
        for (const GLuint location : {0U, 1U}) {
            glVertexArrayVertexBuffer(array, location, buffers[location], 0, sizeof(glm::vec3));
            glVertexArrayAttribFormat(array, location, 3, GL_FLOAT, GL_FALSE, 0);
            glVertexArrayAttribBinding(array, location, location);
            glEnableVertexArrayAttrib(array, location);
        }
        glVertexArrayElementBuffer(array, buffers[2]);
    }
    NamedDrawing(const NamedDrawing&) = delete;
    NamedDrawing& operator=(const NamedDrawing&) = delete;
    ~NamedDrawing() override
    {
        glDeleteBuffers(3, buffers.data());
        glDeleteVertexArrays(1, &array);
    }
    void draw() override
    {
        glBindVertexArray(array);
        glDrawRangeElements(GL_TRIANGLES, 0, ~0U, count, GL_UNSIGNED_INT, nullptr);
        glBindVertexArray(0);
    }
};

}

std::unique_ptr<IndexedDrawing> make_indexed_drawing(const ColoredMesh& mesh)
{
    return std::make_unique<NamedDrawing>(mesh);
}

}
