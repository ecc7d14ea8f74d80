#include <umbral/pipeline/layout.hpp>

namespace umbral::pipeline {

VertexLayout interleaved_layout(std::span<const VertexAttribute> attributes, std::uint64_t vertices)
{
    // TODO: one offset after the other, each a multiple of its component's size; then the common stride.
    return not_implemented<VertexLayout>(attributes, vertices);
}

VertexLayout separate_layout(std::span<const VertexAttribute> attributes, std::uint64_t vertices)
{
    // TODO: one table after the other; the stride is the size of a tuple.
    return not_implemented<VertexLayout>(attributes, vertices);
}

std::vector<std::byte> repack(std::span<const std::byte> source, const VertexLayout& from, const VertexLayout& to,
                              std::span<const VertexAttribute> attributes, std::uint64_t vertices)
{
    // TODO: copy the tuple of every attribute of every vertex from its old place to its new one.
    return not_implemented<std::vector<std::byte>>(source, from, to, attributes, vertices);
}

glm::vec4 fetch_attribute(std::span<const std::byte> buffer, const VertexAttribute& attribute,
                          const AttributePlace& place, std::uint64_t vertex)
{
    // TODO: read the components by their type (std::memcpy), begin with (0, 0, 0, 1) for those that are missing.
    return not_implemented<glm::vec4>(buffer, attribute, place, vertex);
}

}
