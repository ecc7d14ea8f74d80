#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <umbral/gl/program.hpp>

namespace umbral::gl {

/// Triangles in the memory of the graphics card. Needs a current context.
class Mesh {
public:
    /// `normals` has one entry for each position, or none; `indices` are triples into `positions`.
    /// Throws std::invalid_argument that says which size or index is wrong.
    Mesh(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
         std::span<const std::uint32_t> indices);
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;
    ~Mesh();

    /// Draws all triangles with a program whose attributes are called "position" and "normal" (vec3); one that it does
    /// not use, or that the mesh lacks, is not fed. Their places are asked for at every draw, so that a shader may
    /// choose them by itself.
    void draw(const Program& program) const;

    /// The same, but draws each index as a point of glPointSize pixels: no interpolation, and every point counts as
    /// front-facing.
    void draw_points(const Program& program) const;

private:
    void draw_as(unsigned primitive, const Program& program) const;
    /// The attribute's place, or -1 if it is not fed.
    static int feed(const Program& program, const char* name, unsigned buffer);

    unsigned vertex_array_ = 0;
    unsigned positions_ = 0;
    unsigned normals_ = 0;
    unsigned indices_ = 0;
    int index_count_ = 0;
};

}
