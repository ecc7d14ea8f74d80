// alternative: copies vertex by vertex and byte by byte; one switch that calls a generic function with a number of the
// right type
#include <cstring>
#include <limits>
#include <type_traits>
#include <umbral/pipeline/layout.hpp>

namespace umbral::pipeline {
namespace {

template <class Visit>
auto with_type(ComponentType type, Visit visit)
{
    switch (type) {
        case ComponentType::unsigned_byte: return visit(std::uint8_t{});
        case ComponentType::unsigned_short: return visit(std::uint16_t{});
        case ComponentType::unsigned_int: return visit(std::uint32_t{});
        case ComponentType::float32: return visit(float{});
        default: return visit(double{});
    }
}

std::uint64_t size_of(ComponentType type)
{
    return with_type(type, [](auto zero) { return sizeof zero; });
}

std::uint64_t stride_of(const VertexAttribute& attribute, const AttributePlace& place)
{
    return place.stride != 0 ? place.stride : attribute.components * size_of(attribute.type);
}

std::uint64_t up_to(std::uint64_t offset, std::uint64_t size)
{
    return offset % size == 0 ? offset : offset + size - offset % size;
}

}

VertexLayout interleaved_layout(std::span<const VertexAttribute> attributes, std::uint64_t vertices)
{
    if (attributes.empty()) return {};
    VertexLayout vertex = separate_layout(attributes, 1);
    std::uint64_t largest = 1;
    for (const VertexAttribute& attribute : attributes) largest = std::max(largest, size_of(attribute.type));
    const std::uint64_t stride = up_to(vertex.bytes, largest);
    for (AttributePlace& place : vertex.places) place.stride = stride;
    return {vertex.places, stride * vertices};
}

VertexLayout separate_layout(std::span<const VertexAttribute> attributes, std::uint64_t vertices)
{
    VertexLayout layout;
    for (const auto& [type, components, normalized] : attributes) {
        layout.places.push_back({up_to(layout.bytes, size_of(type)), components * size_of(type)});
        layout.bytes = layout.places.back().offset + vertices * layout.places.back().stride;
    }
    return layout;
}

std::vector<std::byte> repack(std::span<const std::byte> source, const VertexLayout& from, const VertexLayout& to,
                              std::span<const VertexAttribute> attributes, std::uint64_t vertices)
{
    std::vector<std::byte> result(to.bytes, std::byte{0});
    for (std::uint64_t vertex = 0; vertex < vertices; ++vertex)
        for (std::size_t i = 0; i < attributes.size(); ++i)
            for (std::uint64_t byte = 0; byte < attributes[i].components * size_of(attributes[i].type); ++byte)
                result[to.places[i].offset + vertex * stride_of(attributes[i], to.places[i]) + byte] =
                    source[from.places[i].offset + vertex * stride_of(attributes[i], from.places[i]) + byte];
    return result;
}

glm::vec4 fetch_attribute(std::span<const std::byte> buffer, const VertexAttribute& attribute,
                          const AttributePlace& place, std::uint64_t vertex)
{
    return with_type(attribute.type, [&](auto zero) {
        using Number = decltype(zero);
        Number numbers[4] = {};
        std::memcpy(numbers, &buffer[place.offset + vertex * stride_of(attribute, place)],
                    attribute.components * sizeof zero);
        glm::vec4 result(0, 0, 0, 1);
        for (int i = 0; i < static_cast<int>(attribute.components); ++i) {
            result[i] = static_cast<float>(numbers[i]);
            if (std::is_integral_v<Number> && attribute.normalized)
                result[i] /= static_cast<float>(std::numeric_limits<Number>::max());
        }
        return result;
    });
}

}
