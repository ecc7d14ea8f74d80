// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 4.5, Compatibility Profile).
// 2017.

#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/outlined.hpp>

namespace umbral::pipeline {
namespace {

// Attribute 1 has no array: all vertices get its current value.
void use_color(const glm::vec3& color) { glVertexAttrib3f(1, color.r, color.g, color.b); }

template <class Item>
void upload(GLenum target, GLuint buffer, const std::vector<Item>& items)
{
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(), GL_STATIC_DRAW);
}

/// A vertex array of positions, with indices or without.
class Drawing : public OutlinedDrawing {
public:
    Drawing(const std::vector<glm::vec2>& positions, const std::vector<std::uint32_t>* indices)
        : buffer_count_(indices == nullptr ? 1 : 2),
          count_(static_cast<GLsizei>(indices == nullptr ? positions.size() : indices->size()))
    {
        glGenVertexArrays(1, &vertex_array_);
        glGenBuffers(buffer_count_, buffers_);
        glBindVertexArray(vertex_array_);
        upload(GL_ARRAY_BUFFER, buffers_[0], positions);
        glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
        glEnableVertexAttribArray(0);
        if (indices != nullptr) upload(GL_ELEMENT_ARRAY_BUFFER, buffers_[1], *indices);
        glBindVertexArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;
    ~Drawing() override
    {
        glDeleteVertexArrays(1, &vertex_array_);
        glDeleteBuffers(buffer_count_, buffers_);
    }

    void draw(const glm::vec3& fill, const glm::vec3& edges) override
    {
        glBindVertexArray(vertex_array_);
        use_color(fill);
        draw_fill(count_);
        use_color(edges);
        draw_edges(count_);
        glBindVertexArray(0);
    }

private:
    virtual void draw_fill(GLsizei count) = 0;
    virtual void draw_edges(GLsizei count) = 0;

    GLuint vertex_array_ = 0;
    GLuint buffers_[2] = {0, 0};
    GLsizei buffer_count_;
    GLsizei count_;
};

class PolygonDrawing final : public Drawing {
public:
    explicit PolygonDrawing(const std::vector<glm::vec2>& corners) : Drawing(corners, nullptr) {}

private:
    void draw_fill(GLsizei count) override { glDrawArrays(GL_TRIANGLE_FAN, 0, count); }
    void draw_edges(GLsizei count) override { glDrawArrays(GL_LINE_LOOP, 0, count); }
};

class TriangleDrawing final : public Drawing {
public:
    TriangleDrawing(const std::vector<glm::vec2>& positions, const std::vector<std::uint32_t>& indices)
        : Drawing(positions, &indices)
    {
    }

private:
    void draw_fill(GLsizei count) override { glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr); }
    void draw_edges(GLsizei count) override
    {
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        draw_fill(count);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
};

}

void send_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges)
{
    const auto send = [&](GLenum type, const glm::vec3& color) {
        use_color(color);
        glBegin(type);
        for (const glm::vec2& corner : corners) glVertex2f(corner.x, corner.y);
        glEnd();
    };
    send(GL_TRIANGLE_FAN, fill);
    send(GL_LINE_LOOP, edges);
}

std::unique_ptr<OutlinedDrawing> make_outlined_polygon(const std::vector<glm::vec2>& corners)
{
    return std::make_unique<PolygonDrawing>(corners);
}

std::unique_ptr<OutlinedDrawing> make_outlined_triangles(const std::vector<glm::vec2>& positions,
                                                         const std::vector<std::uint32_t>& indices)
{
    return std::make_unique<TriangleDrawing>(positions, indices);
}

}
