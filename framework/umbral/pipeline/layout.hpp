#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::pipeline {

/// What one number of an attribute is: OpenGL's GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_FLOAT and
/// GL_DOUBLE. They take 1, 2, 4, 4 and 8 bytes, in the byte order of this machine.
enum class ComponentType { unsigned_byte, unsigned_short, unsigned_int, float32, float64 };

/// One attribute of a vertex: a tuple of 1 to 4 numbers of one type.
struct VertexAttribute {
    ComponentType type = ComponentType::float32;
    std::uint32_t components = 3;
    bool normalized =
        false;  ///< whole numbers stand for [0, 1]: 255 of an unsigned_byte is 1. Means nothing for floats
};

/// Where an attribute's tuples stand in a buffer, in bytes: that of vertex i begins at offset + i * stride.
/// A stride of 0 means that the tuples follow each other without gaps, as it does for glVertexPointer.
struct AttributePlace {
    std::uint64_t offset = 0;
    std::uint64_t stride = 0;
};

/// A buffer of vertices: one place for each attribute, in their order, and how large it all is.
struct VertexLayout {
    std::vector<AttributePlace> places;
    std::uint64_t bytes = 0;
};

/// Array of structures: all attributes of vertex 0, then all of vertex 1, …
///
/// The attributes stand in their order, as the members of a C++ struct do: each begins at the first multiple of its
/// component's size that is free, and the stride is rounded up to a multiple of the largest of these sizes, so that all
/// vertices are alike. `bytes` is stride times vertices, below 2^64. All is 0 where there are no attributes. Course:
/// "array de estructuras (AOS)".
[[nodiscard]] VertexLayout interleaved_layout(std::span<const VertexAttribute> attributes, std::uint64_t vertices);

/// Structure of arrays in one buffer: the whole table of the first attribute, then that of the second, …
///
/// Tables have no gaps inside: the stride is the size of a tuple, written as such, never as 0. Each table begins at the
/// first multiple of its component's size after the one before. `bytes` is where the last table ends. Course:
/// "estructura de arrays (SOA)"; a VBO may hold several tables.
[[nodiscard]] VertexLayout separate_layout(std::span<const VertexAttribute> attributes, std::uint64_t vertices);

/// The same vertices in another layout: a buffer of `to.bytes` bytes. Bytes that belong to no attribute are 0.
///
/// Both layouts have a place for each attribute, inside their buffers; places of one layout do not overlap. Places need
/// not be multiples of anything.
[[nodiscard]] std::vector<std::byte> repack(std::span<const std::byte> source, const VertexLayout& from,
                                            const VertexLayout& to, std::span<const VertexAttribute> attributes,
                                            std::uint64_t vertices);

/// What a vertex shader receives as a vec4: the attribute of one vertex, as floats.
///
/// Components that the attribute lacks are taken from (0, 0, 0, 1). Doubles and whole numbers are rounded to float;
/// normalized whole numbers of b bits are divided by 2^b - 1. The tuple lies inside the buffer.
[[nodiscard]] glm::vec4 fetch_attribute(std::span<const std::byte> buffer, const VertexAttribute& attribute,
                                        const AttributePlace& place, std::uint64_t vertex);

}
