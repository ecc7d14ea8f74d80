// alternative: two classes without a common base, bindings apart from formats
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/outlined.hpp>

namespace umbral::pipeline {
namespace {

void feed_places()
{
    glVertexAttribFormat(0, 2, GL_FLOAT, GL_FALSE, 0);
    glVertexAttribBinding(0, 0);
    glEnableVertexAttribArray(0);
}

struct Polygon final : OutlinedDrawing {
    GLuint vao = 0;
    GLuint vbo = 0;
    int count;

    explicit Polygon(const std::vector<glm::vec2>& corners) : count(static_cast<int>(corners.size()))
    {
        glGenBuffers(1, &vbo);
        glBindBuffer(GL_ARRAY_BUFFER, vbo);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size()) * 8, nullptr, GL_DYNAMIC_DRAW);
        glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(corners.size()) * 8, corners.data());
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glGenVertexArrays(1, &vao);
        glBindVertexArray(vao);
        glBindVertexBuffer(0, vbo, 0, 8);
        feed_places();
        glBindVertexArray(0);
    }
    Polygon(const Polygon&) = delete;
    Polygon& operator=(const Polygon&) = delete;
    ~Polygon() override
    {
        glDeleteVertexArrays(1, &vao);
        glDeleteBuffers(1, &vbo);
    }
    void draw(const glm::vec3& fill, const glm::vec3& edges) override
    {
        glVertexAttrib4f(1, fill.r, fill.g, fill.b, 1);
        glBindVertexArray(vao);
        glDrawArrays(GL_POLYGON, 0, count);
        glVertexAttrib4f(1, edges.r, edges.g, edges.b, 1);
        glDrawArrays(GL_LINE_LOOP, 0, count);
        glBindVertexArray(0);
    }
};

struct Triangles final : OutlinedDrawing {
    GLuint vao = 0;
    GLuint vbo = 0;
    GLuint ibo = 0;
    GLsizei count;

    Triangles(const std::vector<glm::vec2>& positions, const std::vector<std::uint32_t>& indices)
        : count(static_cast<GLsizei>(indices.size()))
    {
        glGenVertexArrays(1, &vao);
        glBindVertexArray(vao);
        for (GLuint* const name : {&ibo, &vbo}) glGenBuffers(1, name);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, ibo);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * indices.size()), indices.data(),
                     GL_STATIC_DRAW);
        glBindBuffer(GL_ARRAY_BUFFER, vbo);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(8 * positions.size()), positions.data(), GL_STATIC_DRAW);
        glBindVertexBuffer(0, vbo, 0, 8);
        feed_places();
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBindVertexArray(0);
    }
    Triangles(const Triangles&) = delete;
    Triangles& operator=(const Triangles&) = delete;
    ~Triangles() override
    {
        const GLuint buffers[] = {ibo, vbo};
        glDeleteBuffers(2, buffers);
        glDeleteVertexArrays(1, &vao);
    }
    void draw(const glm::vec3& fill, const glm::vec3& edges) override
    {
        glBindVertexArray(vao);
        for (const bool net : {false, true}) {
            if (net) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            glVertexAttrib3fv(1, net ? &edges.r : &fill.r);
            glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
            if (net) glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        }
        glBindVertexArray(0);
    }
};

}

void send_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges)
{
    for (const bool inside : {true, false}) {
        const glm::vec3& color = inside ? fill : edges;
        glVertexAttrib3f(1, color.r, color.g, color.b);
        glBegin(inside ? GL_TRIANGLE_FAN : GL_LINE_LOOP);
        for (std::size_t i = 0; i < corners.size(); ++i) glVertex2d(corners[i].x, corners[i].y);
        glEnd();
    }
}

std::unique_ptr<OutlinedDrawing> make_outlined_polygon(const std::vector<glm::vec2>& corners)
{
    return std::unique_ptr<OutlinedDrawing>(new Polygon(corners));
}

std::unique_ptr<OutlinedDrawing> make_outlined_triangles(const std::vector<glm::vec2>& positions,
                                                         const std::vector<std::uint32_t>& indices)
{
    return std::unique_ptr<OutlinedDrawing>(new Triangles(positions, indices));
}

}
