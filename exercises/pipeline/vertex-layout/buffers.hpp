#pragma once

#include <cstring>
#include <numeric>
#include <umbral/core/random.hpp>
#include <umbral/pipeline/layout.hpp>
#include <utility>

/// Vertices, and buffers of them in layouts that the driver chooses.
namespace umbral::pipeline {

inline constexpr VertexAttribute floats(std::uint32_t components) { return {ComponentType::float32, components}; }

/// The course's vertex: position, colour, normal, texture coordinates; 11 floats.
inline const std::vector<VertexAttribute> course_vertex = {floats(3), floats(3), floats(3), floats(2)};

inline std::uint64_t tuple_bytes(const VertexAttribute& attribute)
{
    constexpr std::uint64_t sizes[] = {1, 2, 4, 4, 8};
    return sizes[static_cast<std::size_t>(attribute.type)] * attribute.components;
}

inline std::vector<VertexAttribute> random_attributes(Random& random, std::uint32_t most)
{
    std::vector<VertexAttribute> attributes(1 + random.below(most));
    for (VertexAttribute& attribute : attributes) {
        attribute.type = static_cast<ComponentType>(random.below(5));
        attribute.components = 1 + random.below(4);
        attribute.normalized = random.below(2) == 0;
    }
    return attributes;
}

inline std::vector<std::byte> random_bytes(Random& random, std::uint64_t count)
{
    std::vector<std::byte> bytes(count);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(1 + random.below(255));
    return bytes;
}

/// Some layout of these attributes, in any order, with gaps of up to `gap` - 1 bytes; if `zeros`, strides of separate
/// tables are written as 0.
inline VertexLayout some_layout(Random& random, const std::vector<VertexAttribute>& attributes, std::uint64_t vertices,
                                std::uint32_t gap, bool zeros)
{
    std::vector<std::size_t> order(attributes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    const bool separate = zeros || random.below(2) == 0;
    VertexLayout layout{std::vector<AttributePlace>(attributes.size()), 0};
    for (const std::size_t i : order) {
        const std::uint64_t size = tuple_bytes(attributes[i]);
        layout.places[i] = {layout.bytes + random.below(gap), zeros ? 0 : size};
        layout.bytes = layout.places[i].offset + size * (separate ? vertices : 1);
    }
    if (separate) return layout;
    layout.bytes += random.below(gap);
    for (AttributePlace& place : layout.places) place.stride = layout.bytes;
    layout.bytes *= vertices;
    return layout;
}

template <class Number>
void put(std::vector<std::byte>& bytes, std::uint64_t place, Number number)
{
    std::memcpy(bytes.data() + place, &number, sizeof number);
}

}
