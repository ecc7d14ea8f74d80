#include "judge/trace/draw_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "judge/rows/tensor_view.hpp"
#include "judge/trace/vertex_state.hpp"

namespace umbral::grader {
namespace {

using Attribute = std::pair<const int, FedAttribute>;

std::optional<DrawFault> past_the_indices(const DrawnFrom& drawn)
{
    if (!drawn.indices || !drawn.index_buffer_bytes) return std::nullopt;
    const auto& [count, size, offset] = *drawn.indices;
    if (offset + count * size <= *drawn.index_buffer_bytes) return std::nullopt;
    return DrawFault{"reads past the index buffer",
                     fmt::format("Your draw call reads past the end of the index buffer: {} takes {} indices of {} "
                                 "bytes from byte {} on, and the buffer has {} bytes. Look at the number of indices, "
                                 "their type, the offset, and the size that the buffer was given.",
                                 in_cpp(*drawn.call), count_text(count), size, count_text(offset),
                                 count_text(*drawn.index_buffer_bytes))};
}

std::optional<DrawFault> without_a_buffer(const Attribute& one)
{
    const auto& [location, fed] = one;
    if (fed.is_fed || fed.enabled != true) return std::nullopt;
    return DrawFault{"an attribute without data",
                     fmt::format("Attribute {0} is enabled, and nothing says where its data are: glVertexAttribPointer "
                                 "was not called for location {0} while this vertex array was bound.",
                                 location)};
}

std::optional<DrawFault> not_enabled(const Attribute& one)
{
    const auto& [location, fed] = one;
    if (!fed.is_fed || fed.enabled == true) return std::nullopt;
    return DrawFault{"an attribute that is not enabled",
                     fmt::format("Attribute {0} has a buffer and is not enabled, so all vertices get the same value: "
                                 "call glEnableVertexAttribArray({0}) while this vertex array is bound.",
                                 location)};
}

/// `wanted` vertices are drawn from.
std::optional<DrawFault> past_the_vertices(const Attribute& one, std::optional<double> wanted)
{
    const auto& [location, fed] = one;
    const auto held = fed.vertices();
    if (fed.enabled != true || fed.is_instanced || !held || !wanted || *held >= *wanted) return std::nullopt;
    return DrawFault{
        "reads past a vertex buffer",
        fmt::format("Your draw call reads past the end of a buffer: attribute {} takes {} numbers ({} bytes) every {} "
                    "bytes, from byte {} on, so its buffer of {} bytes holds {} vertices; {} are needed. Look at the "
                    "arguments of glVertexAttribPointer, and at the size that the buffer was given.",
                    location, fed.numbers, fed.bytes, fed.stride, count_text(*fed.offset),
                    count_text(*fed.buffer_bytes), count_text(*held), count_text(*wanted))};
}

/// What the expected draw call's buffer holds for the attribute.
std::optional<double> expected_vertices(const DrawnFrom& expected, int location)
{
    const auto found = expected.attributes.find(location);
    return found == expected.attributes.end() || found->second.enabled != true ? std::nullopt
                                                                               : found->second.vertices();
}

}

std::vector<DrawFault> draw_faults(const GlTrace& yours, const GlTrace& expected)
{
    std::vector<DrawFault> faults;
    const auto add = [&](std::optional<DrawFault> one) {
        if (one && std::ranges::find(faults, one->name, &DrawFault::name) == faults.end())
            faults.push_back(*std::move(one));
    };
    const std::vector<DrawnFrom> mine = drawn_from(yours);
    const std::vector<DrawnFrom> theirs = drawn_from(expected);
    for (std::size_t i = 0; i < mine.size(); ++i) {
        for (const Attribute& one : mine[i].attributes) {
            add(not_enabled(one));
            add(without_a_buffer(one));
        }
        add(past_the_indices(mine[i]));
        for (const Attribute& one : mine[i].attributes) {
            auto wanted = mine[i].first_vertices;
            if (!wanted && mine.size() == theirs.size()) wanted = expected_vertices(theirs[i], one.first);
            add(past_the_vertices(one, wanted));
        }
    }
    return faults;
}

}
