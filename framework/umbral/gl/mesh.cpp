#include <stdexcept>
#include <string>
#include <umbral/gl/context.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>

namespace umbral::gl {
namespace {

template <class Item>
GLuint upload(GLenum target, std::span<const Item> items)
{
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(items.size_bytes()), items.data(), GL_STATIC_DRAW);
    return buffer;
}

void check(std::size_t positions, std::size_t normals, std::span<const std::uint32_t> indices)
{
    if (normals != 0 && normals != positions)
        throw std::invalid_argument("gl::Mesh: expected as many normals as positions (" + std::to_string(positions) +
                                    ") or none, got " + std::to_string(normals));
    if (indices.size() % 3 != 0)
        throw std::invalid_argument("gl::Mesh: expected three indices a triangle, got " +
                                    std::to_string(indices.size()) + " in all");
    for (const std::uint32_t index : indices)
        if (index >= positions)
            throw std::invalid_argument("gl::Mesh: expected indices below " + std::to_string(positions) +
                                        " (the positions), got " + std::to_string(index));
}

}

Mesh::Mesh(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
           std::span<const std::uint32_t> indices)
    : index_count_(static_cast<int>(indices.size()))
{
    check(positions.size(), normals.size(), indices);
    glGenVertexArrays(1, &vertex_array_);
    glBindVertexArray(vertex_array_);
    positions_ = upload(GL_ARRAY_BUFFER, positions);
    if (!normals.empty()) normals_ = upload(GL_ARRAY_BUFFER, normals);
    indices_ = upload(GL_ELEMENT_ARRAY_BUFFER, indices);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

Mesh::~Mesh()
{
    if (!has_context()) return;
    glDeleteVertexArrays(1, &vertex_array_);
    for (const GLuint buffer : {positions_, normals_, indices_}) glDeleteBuffers(1, &buffer);
}

void Mesh::draw(const Program& program) const { draw_as(GL_TRIANGLES, program); }

void Mesh::draw_points(const Program& program) const { draw_as(GL_POINTS, program); }

void Mesh::draw_as(unsigned primitive, const Program& program) const
{
    program.use();
    glBindVertexArray(vertex_array_);
    const int position = feed(program, "position", positions_);
    const int normal = feed(program, "normal", normals_);
    glDrawElements(primitive, index_count_, GL_UNSIGNED_INT, nullptr);
    // Another program may have other places: leave none behind.
    for (const int place : {position, normal})
        if (place >= 0) glDisableVertexAttribArray(static_cast<GLuint>(place));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

int Mesh::feed(const Program& program, const char* name, unsigned buffer)
{
    const int place = program.attribute_location(name);
    if (place < 0 || buffer == 0) return -1;
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glVertexAttribPointer(static_cast<GLuint>(place), 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(static_cast<GLuint>(place));
    return place;
}

}
