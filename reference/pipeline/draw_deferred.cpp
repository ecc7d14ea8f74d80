#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/draw.hpp>

namespace umbral::pipeline {
namespace {

template <class Item>
void upload(GLenum target, GLuint buffer, const std::vector<Item>& items)
{
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(), GL_STATIC_DRAW);
}

/// Feeds an attribute from the buffer that is bound: three floats a vertex, one vertex right behind the other.
void feed(GLuint location)
{
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    glEnableVertexAttribArray(location);
}

class DeferredDrawing : public IndexedDrawing {
public:
    explicit DeferredDrawing(const ColoredMesh& mesh) : index_count_(static_cast<GLsizei>(mesh.indices.size()))
    {
        glGenVertexArrays(1, &vertex_array_);
        glGenBuffers(3, buffers_);
        // The vertex array notes what follows: which buffer feeds each attribute, and where the indices are.
        glBindVertexArray(vertex_array_);
        upload(GL_ARRAY_BUFFER, buffers_[0], mesh.positions);
        feed(0);
        upload(GL_ARRAY_BUFFER, buffers_[1], mesh.colors);
        feed(1);
        upload(GL_ELEMENT_ARRAY_BUFFER, buffers_[2], mesh.indices);
        // The index buffer is part of the vertex array, so that one must go first; GL_ARRAY_BUFFER is nobody's part.
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }

    DeferredDrawing(const DeferredDrawing&) = delete;
    DeferredDrawing& operator=(const DeferredDrawing&) = delete;

    ~DeferredDrawing() override
    {
        glDeleteVertexArrays(1, &vertex_array_);
        glDeleteBuffers(3, buffers_);
    }

    void draw() override
    {
        glBindVertexArray(vertex_array_);
        glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
        glBindVertexArray(0);
    }

private:
    GLuint vertex_array_ = 0;
    GLuint buffers_[3] = {0, 0, 0};  // positions, colours, indices
    GLsizei index_count_;
};

}

std::unique_ptr<IndexedDrawing> make_indexed_drawing(const ColoredMesh& mesh)
{
    return std::make_unique<DeferredDrawing>(mesh);
}

}
