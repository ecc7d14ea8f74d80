#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <vector>

namespace umbral {

/// The numbers of one attribute of all vertices, while they live.
struct Attribute {
    template <int size>
    Attribute(const char* its_name, const std::vector<glm::vec<size, float>>& items)
        : name(its_name),
          components(size),
          bytes(static_cast<GLsizeiptr>(items.size() * sizeof(items[0]))),
          data(items.data())
    {
    }

    const char* name;
    int components;
    GLsizeiptr bytes;
    const void* data;
};

/// Triangles in the memory of the graphics card whose vertices have any attributes, for one program. A context must
/// be current while it lives.
class AttributeMesh {
public:
    /// Attributes that the program does not use are passed over.
    AttributeMesh(const gl::Program& program, const std::vector<std::uint32_t>& indices,
                  std::initializer_list<Attribute> attributes)
        : program_(program), count_(static_cast<GLsizei>(indices.size()))
    {
        glGenVertexArrays(1, &array_);
        glBindVertexArray(array_);
        fill(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(4 * indices.size()), indices.data());
        for (const Attribute& attribute : attributes) {
            const int location = program.attribute_location(attribute.name);
            if (location < 0) continue;
            fill(GL_ARRAY_BUFFER, attribute.bytes, attribute.data);
            glVertexAttribPointer(static_cast<GLuint>(location), attribute.components, GL_FLOAT, GL_FALSE, 0, nullptr);
            glEnableVertexAttribArray(static_cast<GLuint>(location));
        }
    }
    AttributeMesh(const AttributeMesh&) = delete;
    AttributeMesh& operator=(const AttributeMesh&) = delete;
    ~AttributeMesh()
    {
        glDeleteVertexArrays(1, &array_);
        glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    }

    /// Draws all of it with the program, several times in one call.
    void draw(int instances = 1) const
    {
        program_.use();
        glBindVertexArray(array_);
        glDrawElementsInstanced(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr, instances);
    }

private:
    void fill(GLenum target, GLsizeiptr bytes, const void* data)
    {
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        buffers_.push_back(buffer);
        glBindBuffer(target, buffer);
        glBufferData(target, bytes, data, GL_STATIC_DRAW);
    }

    const gl::Program& program_;
    GLsizei count_;
    GLuint array_ = 0;
    std::vector<GLuint> buffers_;
};

}
