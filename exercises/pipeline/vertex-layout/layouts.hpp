#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <umbral/record/ask.hpp>

#include "buffers.hpp"

/// Layouts that the unit gives, as rows of numbers, and questions at the ends of what they may be asked.
namespace umbral::pipeline {

/// A row for each attribute, or one where there is none. The size of it all stands in each of them, so that whoever
/// gets it wrong has no right row of the layout.
inline void record_layout(Recorder& out, const char* name, const VertexLayout& layout, std::size_t attributes)
{
    out.columns(name, "offset, stride, bytes of all");
    const std::size_t places = layout.places.size();
    const auto number = [](std::uint64_t value) { return static_cast<double>(value); };
    for (std::size_t i = 0; i < std::max<std::size_t>(attributes, 1); ++i) {
        if (places != attributes) {
            out.refused(name, "expected a place for each of " + std::to_string(attributes) + " attributes, got " +
                                  std::to_string(places) + " places");
            out.append(name, std::optional<glm::dvec3>());
            continue;
        }
        const AttributePlace place = attributes == 0 ? AttributePlace{} : layout.places[i];
        out.append(name, std::optional(glm::dvec3(number(place.offset), number(place.stride), number(layout.bytes))));
    }
}

inline void record_layouts(Recorder& out, const std::vector<VertexAttribute>& attributes, std::uint64_t vertices)
{
    record_layout(out, "interleaved", ask<interleaved_layout>(out, attributes, vertices), attributes.size());
    record_layout(out, "separate", ask<separate_layout>(out, attributes, vertices), attributes.size());
}

// Without attributes, without vertices, and with both, which the two functions for layouts and repack must all survive.
inline void record_nothing(Random& random, Recorder& out)
{
    out.columns("repacked", "bytes, zero bytes among them");
    for (const std::uint64_t vertices : {0U, 1U, 7U})
        for (const std::vector<VertexAttribute>& attributes : {{}, {floats(3)}, course_vertex}) {
            record_layout(out, "layouts", ask<interleaved_layout>(out, attributes, vertices), attributes.size());
            record_layout(out, "layouts", ask<separate_layout>(out, attributes, vertices), attributes.size());
            VertexLayout from = some_layout(random, attributes, vertices, 1, false);
            VertexLayout to = some_layout(random, attributes, vertices, 1, false);
            (vertices == 1 ? from : to).bytes += 5;
            const std::vector<std::byte> result =
                ask<repack>(out, random_bytes(random, from.bytes), from, to, attributes, vertices);
            const auto zeros = std::count(result.begin(), result.end(), std::byte{0});
            out.append("repacked", glm::dvec2(static_cast<double>(result.size()), static_cast<double>(zeros)));
        }
}

// More than 4 GiB, and of every other two more vertices than 32 bits count: sizes still below 2^53, which a double
// holds exactly.
inline void record_large(Random& random, Recorder& out)
{
    for (int i = 0; i < 12; ++i) {
        std::uint64_t vertices = 200'000'000 + std::uint64_t{4} * random.below(1'000'000'000);
        if (i % 4 < 2) vertices += std::uint64_t{1 + random.below(8)} << 32U;
        record_layouts(out, i % 2 == 0 ? course_vertex : random_attributes(random, 5), vertices);
    }
}

// Sizes of 2^53 to 2^64 bytes, three of four of them above 2^62: no double holds them, nor a signed number the largest.
// They are recorded in two parts, which a double does hold.
inline void record_huge(Random& random, Recorder& out)
{
    out.columns("bytes", "thousands of millions of bytes, and bytes beyond them");
    const auto record = [&](const VertexLayout& layout) {
        constexpr std::uint64_t unit = 1'000'000'000;
        out.append("bytes",
                   glm::dvec2(static_cast<double>(layout.bytes / unit), static_cast<double>(layout.bytes % unit)));
    };
    for (int i = 0; i < 16; ++i) {
        const std::vector<VertexAttribute> attributes = i % 4 == 1 ? course_vertex : random_attributes(random, 5);
        // Before each attribute there is a gap of less than a number of its own, and at the end of less than the
        // largest: all that is asked for is below 2^64.
        std::uint64_t most = 0;
        std::uint64_t largest = 1;
        for (const VertexAttribute& attribute : attributes) {
            const std::uint64_t size = tuple_bytes(attribute) / attribute.components;
            most += tuple_bytes(attribute) + size - 1;
            largest = std::max(largest, size);
        }
        const std::uint64_t vertices = ~std::uint64_t{0} / (most + largest - 1) - random.below(1'000'000'000);
        const std::uint64_t asked = i % 4 == 0 ? vertices >> (1 + random.below(8)) : vertices;
        record(ask<interleaved_layout>(out, attributes, asked));
        record(ask<separate_layout>(out, attributes, asked));
    }
}

}
