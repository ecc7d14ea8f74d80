// Based on: M. Segal, K. Akeley. The OpenGL Graphics System: A Specification (Version 4.5, Core Profile). 2017,
// sections 2.3.5 (normalized numbers), 10.2 and 10.3 (offsets and strides of arrays).

#include <algorithm>
#include <cstring>
#include <limits>
#include <umbral/pipeline/layout.hpp>

namespace umbral::pipeline {
namespace {

std::uint64_t component_size(ComponentType type)
{
    switch (type) {
        case ComponentType::unsigned_byte: return 1;
        case ComponentType::unsigned_short: return 2;
        case ComponentType::float64: return 8;
        default: return 4;
    }
}

std::uint64_t tuple_size(const VertexAttribute& attribute)
{
    return component_size(attribute.type) * attribute.components;
}

/// The first multiple of `size` from `offset` on.
std::uint64_t aligned(std::uint64_t offset, std::uint64_t size) { return (offset + size - 1) / size * size; }

std::uint64_t place_of(const VertexAttribute& attribute, const AttributePlace& place, std::uint64_t vertex)
{
    return place.offset + vertex * (place.stride == 0 ? tuple_size(attribute) : place.stride);
}

// Through memcpy: a place need not be a multiple of the number's size.
template <class Number>
Number number_at(const std::byte* place)
{
    Number number;
    std::memcpy(&number, place, sizeof number);
    return number;
}

template <class Whole>
double whole_at(const std::byte* place, bool normalized)
{
    const double value = number_at<Whole>(place);
    return normalized ? value / std::numeric_limits<Whole>::max() : value;
}

double component_at(const std::byte* place, const VertexAttribute& attribute)
{
    switch (attribute.type) {
        case ComponentType::unsigned_byte: return whole_at<std::uint8_t>(place, attribute.normalized);
        case ComponentType::unsigned_short: return whole_at<std::uint16_t>(place, attribute.normalized);
        case ComponentType::unsigned_int: return whole_at<std::uint32_t>(place, attribute.normalized);
        case ComponentType::float64: return number_at<double>(place);
        default: return number_at<float>(place);
    }
}

}

VertexLayout interleaved_layout(std::span<const VertexAttribute> attributes, std::uint64_t vertices)
{
    VertexLayout layout;
    std::uint64_t end = 0;
    std::uint64_t largest = 1;
    for (const VertexAttribute& attribute : attributes) {
        const std::uint64_t size = component_size(attribute.type);
        const std::uint64_t offset = aligned(end, size);
        layout.places.push_back({offset, 0});
        end = offset + tuple_size(attribute);
        largest = std::max(largest, size);
    }
    const std::uint64_t stride = aligned(end, largest);
    for (AttributePlace& place : layout.places) place.stride = stride;
    layout.bytes = stride * vertices;
    return layout;
}

VertexLayout separate_layout(std::span<const VertexAttribute> attributes, std::uint64_t vertices)
{
    VertexLayout layout;
    for (const VertexAttribute& attribute : attributes) {
        const std::uint64_t offset = aligned(layout.bytes, component_size(attribute.type));
        layout.places.push_back({offset, tuple_size(attribute)});
        layout.bytes = offset + tuple_size(attribute) * vertices;
    }
    return layout;
}

std::vector<std::byte> repack(std::span<const std::byte> source, const VertexLayout& from, const VertexLayout& to,
                              std::span<const VertexAttribute> attributes, std::uint64_t vertices)
{
    std::vector<std::byte> result(to.bytes);
    for (std::size_t i = 0; i < attributes.size(); ++i)
        for (std::uint64_t vertex = 0; vertex < vertices; ++vertex)
            std::memcpy(result.data() + place_of(attributes[i], to.places[i], vertex),
                        source.data() + place_of(attributes[i], from.places[i], vertex), tuple_size(attributes[i]));
    return result;
}

glm::vec4 fetch_attribute(std::span<const std::byte> buffer, const VertexAttribute& attribute,
                          const AttributePlace& place, std::uint64_t vertex)
{
    const std::byte* tuple = buffer.data() + place_of(attribute, place, vertex);
    glm::vec4 value(0, 0, 0, 1);
    for (std::uint32_t i = 0; i < attribute.components; ++i)
        value[static_cast<int>(i)] =
            static_cast<float>(component_at(tuple + i * component_size(attribute.type), attribute));
    return value;
}

}
