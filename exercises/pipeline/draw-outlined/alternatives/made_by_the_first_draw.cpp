// alternative: tables kept until the first draw makes the objects; immutable storage; indices as small as they may be
#include <algorithm>
#include <array>
#include <umbral/gl/opengl.hpp>
#include <umbral/pipeline/outlined.hpp>

namespace umbral::pipeline {
namespace {

GLuint stored(GLenum target, std::size_t bytes, const void* data)
{
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    if (bytes > 0) glBufferStorage(target, static_cast<GLsizeiptr>(bytes), data, 0);
    return name;
}

class Lazy final : public OutlinedDrawing {
public:
    Lazy(std::vector<glm::vec2> positions, std::vector<std::uint32_t> indices, bool indexed)
        : positions_(std::move(positions)), indices_(std::move(indices)), indexed_(indexed)
    {
    }
    Lazy(const Lazy&) = delete;
    Lazy& operator=(const Lazy&) = delete;
    ~Lazy() override
    {
        if (array_ == 0) return;
        glDeleteBuffers(indexed_ ? 2 : 1, buffers_.data());
        glDeleteVertexArrays(1, &array_);
    }

    void draw(const glm::vec3& fill, const glm::vec3& edges) override
    {
        if (positions_.empty() && array_ == 0) return;
        if (array_ == 0)
            make();
        else
            glBindVertexArray(array_);
        glVertexAttrib3f(1, fill.x, fill.y, fill.z);
        pass(GL_TRIANGLE_FAN);
        if (indexed_) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glVertexAttrib3f(1, edges.x, edges.y, edges.z);
        pass(GL_LINE_LOOP);
        if (indexed_) glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        glBindVertexArray(0);
    }

private:
    void make()
    {
        glGenVertexArrays(1, &array_);
        glBindVertexArray(array_);
        buffers_[0] = stored(GL_ARRAY_BUFFER, 8 * positions_.size(), positions_.data());
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        count_ = static_cast<GLsizei>(indexed_ ? indices_.size() : positions_.size());
        if (!indexed_) return;
        bytes_ = positions_.size() <= 256;
        const std::vector<std::uint8_t> small(indices_.begin(), indices_.end());
        buffers_[1] = bytes_ ? stored(GL_ELEMENT_ARRAY_BUFFER, small.size(), small.data())
                             : stored(GL_ELEMENT_ARRAY_BUFFER, 4 * indices_.size(), indices_.data());
    }

    void pass(GLenum type) const
    {
        if (indexed_)
            glDrawElements(GL_TRIANGLES, count_, bytes_ ? GL_UNSIGNED_BYTE : GL_UNSIGNED_INT, nullptr);
        else
            glDrawArrays(type, 0, count_);
    }

    std::vector<glm::vec2> positions_;
    std::vector<std::uint32_t> indices_;
    bool indexed_;
    bool bytes_ = false;
    GLsizei count_ = 0;
    GLuint array_ = 0;
    std::array<GLuint, 2> buffers_{};
};

}

void send_polygon(const std::vector<glm::vec2>& corners, const glm::vec3& fill, const glm::vec3& edges)
{
    if (corners.empty()) return;
    glBegin(GL_POLYGON);
    glVertexAttrib3fv(1, &fill.x);
    std::for_each(corners.begin(), corners.end(), [](const glm::vec2& p) { glVertex2fv(&p.x); });
    glEnd();
    glBegin(GL_LINE_LOOP);
    glVertexAttrib3fv(1, &edges.x);
    std::for_each(corners.rbegin(), corners.rend(), [](const glm::vec2& p) { glVertex4f(p.x, p.y, 0, 1); });
    glEnd();
}

std::unique_ptr<OutlinedDrawing> make_outlined_polygon(const std::vector<glm::vec2>& corners)
{
    return std::make_unique<Lazy>(corners, std::vector<std::uint32_t>{}, false);
}

std::unique_ptr<OutlinedDrawing> make_outlined_triangles(const std::vector<glm::vec2>& positions,
                                                         const std::vector<std::uint32_t>& indices)
{
    return std::make_unique<Lazy>(positions, indices, true);
}

}
