#pragma once

#include <cmath>
#include <limits>
#include <umbral/record/ask.hpp>
#include <umbral/record/not_finite.hpp>

#include "buffers.hpp"

/// Attributes fetched from buffers of all kinds.
namespace umbral::pipeline {

/// A number of any size; every other one near 1. Doubles also too small for a float, or too large.
inline double any_real(Random& random, ComponentType type, bool is_near)
{
    const double smallest = type == ComponentType::float64 ? -60 : -30;
    const double largest = type == ComponentType::float64 ? 50 : 38;
    const double exponent = is_near ? 2 : smallest + (largest - smallest) * random.uniform_double();
    return std::pow(10.0, exponent) * (random.uniform_double() - 0.5);
}

/// Too small for a float to hold with all its digits.
inline double subnormal(Random& random)
{
    const double digits = 1 + random.below((1U << 23U) - 2);
    return (random.below(2) == 0 ? -1 : 1) * std::ldexp(digits, -149);
}

/// Larger than every float.
inline double beyond_floats(Random& random)
{
    return (random.below(2) == 0 ? -1 : 1) * std::pow(10.0, 39 + 260 * random.uniform_double());
}

inline double not_finite(Random& random)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double numbers[] = {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};
    return numbers[random.below(3)];
}

inline void record_fetch(Recorder& out, const std::vector<std::byte>& buffer, const VertexAttribute& attribute,
                         const AttributePlace& place, std::uint64_t vertex)
{
    out.append("values", recordable(ask<fetch_attribute>(out, buffer, attribute, place, vertex)));
}

/// A buffer with a number of this type at each place of a layout, and every vertex fetched from it. Places are
/// multiples of nothing, and tuples may overlap.
inline void record_fetched(Random& random, Recorder& out, const VertexAttribute& attribute, bool zero_stride)
{
    constexpr std::uint64_t vertices = 8;
    const std::uint64_t tuple = tuple_bytes(attribute);
    const std::uint64_t size = tuple / attribute.components;
    const std::uint64_t stride =
        zero_stride ? tuple : size + random.below(static_cast<std::uint32_t>(tuple + 2 * size));
    const std::uint64_t offset = random.below(static_cast<std::uint32_t>(5 * size));
    std::vector<std::byte> buffer = random_bytes(random, offset + stride * (vertices - 1) + tuple);
    for (std::uint64_t vertex = 0; vertex < vertices; ++vertex)
        for (std::uint64_t i = 0; i < attribute.components; ++i) {
            const std::uint64_t place = offset + vertex * stride + i * size;
            const std::uint32_t whole = vertex == 0 ? std::numeric_limits<std::uint32_t>::max() : random.bits();
            const double real = vertex > 5 && i % 2 == 0 ? not_finite(random)
                                : vertex == 3            ? subnormal(random)
                                : vertex == 1 && attribute.type == ComponentType::float64
                                    ? beyond_floats(random)
                                    : any_real(random, attribute.type, vertex % 2 == 0);
            switch (attribute.type) {
                case ComponentType::unsigned_byte: put(buffer, place, static_cast<std::uint8_t>(whole)); break;
                case ComponentType::unsigned_short: put(buffer, place, static_cast<std::uint16_t>(whole)); break;
                case ComponentType::unsigned_int: put(buffer, place, whole); break;
                case ComponentType::float64: put(buffer, place, real); break;
                default: put(buffer, place, static_cast<float>(real));
            }
        }
    for (std::uint64_t vertex = 0; vertex < vertices; ++vertex)
        record_fetch(out, buffer, attribute, {offset, zero_stride ? 0 : stride}, vertex);
}

inline void record_fetches(Random& random, Recorder& out, bool whole, bool zero_stride)
{
    using enum ComponentType;
    for (const ComponentType type : {unsigned_byte, unsigned_short, unsigned_int, float32, float64})
        for (std::uint32_t components = 1; components <= 4; ++components)
            for (const bool normalized : {false, true}) {
                const bool real = type == float32 || type == float64;
                if ((real && whole) || (!real && !whole && !zero_stride)) continue;
                record_fetched(random, out, {type, components, normalized}, zero_stride);
            }
}

}
