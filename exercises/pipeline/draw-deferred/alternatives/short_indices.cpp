// alternative: 16-bit indices where they suffice, which halves that table
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/draw.hpp>

namespace umbral::pipeline {
namespace {

class CompactDrawing : public IndexedDrawing {
public:
    explicit CompactDrawing(const ColoredMesh& mesh)
        : type_(mesh.positions.size() <= 65536 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT), count_(mesh.indices.size())
    {
        glGenVertexArrays(1, &array_);
        glBindVertexArray(array_);
        const std::vector<std::uint16_t> narrow(mesh.indices.begin(), mesh.indices.end());
        const void* indices =
            type_ == GL_UNSIGNED_SHORT ? static_cast<const void*>(narrow.data()) : mesh.indices.data();
        buffers_[2] = filled(GL_ELEMENT_ARRAY_BUFFER, indices, count_ * (type_ == GL_UNSIGNED_SHORT ? 2 : 4));
        for (GLuint location = 0; location < 2; ++location) {
            const std::vector<glm::vec3>& table = location == 0 ? mesh.positions : mesh.colors;
            buffers_[location] = filled(GL_ARRAY_BUFFER, table.data(), table.size() * 12);
            glEnableVertexAttribArray(location);
            glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 12, nullptr);
        }
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBindVertexArray(0);
    }
    CompactDrawing(const CompactDrawing&) = delete;
    CompactDrawing& operator=(const CompactDrawing&) = delete;
    ~CompactDrawing() override
    {
        for (const GLuint& buffer : buffers_) glDeleteBuffers(1, &buffer);
        glDeleteVertexArrays(1, &array_);
    }

    void draw() override
    {
        if (count_ == 0) return;
        glBindVertexArray(array_);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count_), type_, nullptr);
        glBindVertexArray(0);
    }

private:
    static GLuint filled(GLenum target, const void* data, std::size_t bytes)
    {
        GLuint name = 0;
        glGenBuffers(1, &name);
        glBindBuffer(target, name);
        glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
        return name;
    }

    GLenum type_;
    std::size_t count_;
    GLuint array_ = 0;
    GLuint buffers_[3] = {};
};

}

std::unique_ptr<IndexedDrawing> make_indexed_drawing(const ColoredMesh& mesh)
{
    return std::make_unique<CompactDrawing>(mesh);
}

}
