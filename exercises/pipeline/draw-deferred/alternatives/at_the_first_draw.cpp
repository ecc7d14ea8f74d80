// alternative: keeps a copy of the tables, and makes everything at the first draw, as the course's ArrayVertices does
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/draw.hpp>

namespace umbral::pipeline {
namespace {

/// DescrTabla: a table that is sent the first time it is activated.
struct Table {
    GLenum target;
    const void* data;
    std::size_t bytes;
    GLuint buffer = 0;

    void activate()
    {
        if (buffer != 0) {
            glBindBuffer(target, buffer);
            return;
        }
        glGenBuffers(1, &buffer);
        glBindBuffer(target, buffer);
        glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    }
};

class VertexArrays final : public IndexedDrawing {
public:
    explicit VertexArrays(const ColoredMesh& mesh) : mesh_(mesh) {}
    VertexArrays(const VertexArrays&) = delete;
    VertexArrays& operator=(const VertexArrays&) = delete;

    ~VertexArrays() override
    {
        for (const Table& table : {positions_, colors_, indices_})
            if (table.buffer != 0) glDeleteBuffers(1, &table.buffer);
        if (name_ != 0) glDeleteVertexArrays(1, &name_);
    }

    void draw() override
    {
        if (name_ == 0) {
            glGenVertexArrays(1, &name_);
            glBindVertexArray(name_);
            attribute(positions_, 0);
            attribute(colors_, 1);
            indices_.activate();
        } else {
            glBindVertexArray(name_);
        }
        glDrawElements(GL_TRIANGLES, static_cast<int>(mesh_.indices.size()), GL_UNSIGNED_INT, nullptr);
        glBindVertexArray(0);
    }

private:
    static void attribute(Table& table, GLuint location)
    {
        table.activate();
        glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glEnableVertexAttribArray(location);
    }

    ColoredMesh mesh_;
    GLuint name_ = 0;
    Table positions_{GL_ARRAY_BUFFER, mesh_.positions.data(), mesh_.positions.size() * sizeof(glm::vec3)};
    Table colors_{GL_ARRAY_BUFFER, mesh_.colors.data(), mesh_.colors.size() * sizeof(glm::vec3)};
    Table indices_{GL_ELEMENT_ARRAY_BUFFER, mesh_.indices.data(), mesh_.indices.size() * sizeof(std::uint32_t)};
};

}

std::unique_ptr<IndexedDrawing> make_indexed_drawing(const ColoredMesh& mesh)
{
    return std::make_unique<VertexArrays>(mesh);
}

}
