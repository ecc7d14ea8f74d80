#include "judge/trace/vertex_state.hpp"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace umbral::grader {
namespace {

/// More draw calls say nothing new.
constexpr std::size_t most_draws = 64;
constexpr double most_attributes = 64;

// What sets the same state by other ways, or takes objects away, whose numbers a trace does not hold.
constexpr std::array other_ways{std::string_view("glVertexArray"),         std::string_view("glVertexAttribFormat"),
                                std::string_view("glVertexAttribIFormat"), std::string_view("glVertexAttribBinding"),
                                std::string_view("glBindVertexBuffer"),    std::string_view("glNamedBuffer"),
                                std::string_view("glEnableVertexArray"),   std::string_view("glDisableVertexArray"),
                                std::string_view("glDeleteBuffers"),       std::string_view("glDeleteVertexArrays"),
                                std::string_view("glPushClientAttrib"),    std::string_view("glPopClientAttrib")};

/// 0 if it is none.
double size_of_type(double type)
{
    if (!(type >= 0 && type < 0x10000)) return 0;
    switch (static_cast<std::int64_t>(type)) {
        case GL_BYTE:
        case GL_UNSIGNED_BYTE: return 1;
        case GL_SHORT:
        case GL_UNSIGNED_SHORT:
        case GL_HALF_FLOAT: return 2;
        case GL_INT:
        case GL_UNSIGNED_INT:
        case GL_FLOAT:
        case GL_FIXED: return 4;
        case GL_DOUBLE: return 8;
        default: return 0;
    }
}

std::optional<double> offset_of(double pointer)
{
    return pointer == some_address ? std::nullopt : std::optional(pointer);
}

/// The number of an object; 0, which is none, for what cannot be one.
std::uint32_t object_of(double number)
{
    constexpr double largest = std::numeric_limits<std::uint32_t>::max();
    return number >= 0 && number <= largest ? static_cast<std::uint32_t>(number) : 0;
}

struct VertexArray {
    std::map<int, FedAttribute> attributes;
    std::optional<std::uint32_t> index_buffer;
};

class State {
public:
    /// False if what is drawn from is not known from here on.
    bool take(const GlCall& call)
    {
        if (std::ranges::any_of(other_ways, [&](std::string_view one) { return call.name.starts_with(one); }))
            return false;
        const auto argument = [&](std::size_t i) { return i < call.arguments.size() ? call.arguments[i] : 0; };
        if (call.name == "glBindVertexArray") {
            vertex_array_ = object_of(argument(0));
        } else if (call.name == "glBindBuffer" && argument(0) == GL_ARRAY_BUFFER) {
            array_buffer_ = object_of(argument(1));
        } else if (call.name == "glBindBuffer" && argument(0) == GL_ELEMENT_ARRAY_BUFFER) {
            arrays_[vertex_array_].index_buffer = object_of(argument(1));
        } else if (call.name == "glBufferData" || call.name == "glBufferStorage") {
            if (const auto bound = bound_to(argument(0))) bytes_[*bound] = argument(1);
        } else if (!(argument(0) >= 0 && argument(0) < most_attributes)) {
            return true;
        } else if (call.name == "glVertexAttribPointer") {
            feed(argument(0), argument(1), argument(2), argument(4), argument(5));
        } else if (call.name == "glVertexAttribIPointer" || call.name == "glVertexAttribLPointer") {
            feed(argument(0), argument(1), argument(2), argument(3), argument(4));
        } else if (call.name == "glEnableVertexAttribArray" || call.name == "glDisableVertexAttribArray") {
            attribute(argument(0)).enabled = call.name.starts_with("glEnable");
        } else if (call.name == "glVertexAttribDivisor") {
            attribute(argument(0)).is_instanced = argument(1) != 0;
        }
        return true;
    }

    /// Of a call whose count is the argument at `count`.
    [[nodiscard]] DrawnFrom at(const GlCall& call, std::size_t count) const
    {
        DrawnFrom from;
        from.call = &call;
        const auto found = arrays_.find(vertex_array_);
        if (found == arrays_.end()) return from;
        from.attributes = found->second.attributes;
        if (const auto buffer = found->second.index_buffer) from.index_buffer_bytes = bytes_of(*buffer);
        const auto& given = call.arguments;
        if (call.name.starts_with("glDrawArrays") && given.size() > count) {
            from.first_vertices = given[count - 1] + given[count];
        } else if (given.size() > count + 2) {
            const auto offset = offset_of(given[count + 2]);
            const double size = size_of_type(given[count + 1]);
            if (offset && size > 0) from.indices = DrawnFrom::Indices{given[count], size, *offset};
        }
        return from;
    }

private:
    FedAttribute& attribute(double location) { return arrays_[vertex_array_].attributes[static_cast<int>(location)]; }

    void feed(double location, double numbers, double type, double stride, double pointer)
    {
        FedAttribute& one = attribute(location);
        one.is_fed = true;
        one.numbers = numbers == GL_BGRA ? 4 : numbers;
        one.bytes = one.numbers * size_of_type(type);
        one.stride = stride == 0 ? one.bytes : stride;
        one.offset = offset_of(pointer);
        one.buffer_bytes = bytes_of(array_buffer_);
    }

    [[nodiscard]] std::optional<std::uint32_t> bound_to(double target) const
    {
        if (target == GL_ARRAY_BUFFER) return array_buffer_;
        const auto found = arrays_.find(vertex_array_);
        return target == GL_ELEMENT_ARRAY_BUFFER && found != arrays_.end() ? found->second.index_buffer : std::nullopt;
    }

    [[nodiscard]] std::optional<double> bytes_of(std::uint32_t buffer) const
    {
        const auto found = bytes_.find(buffer);
        return buffer == 0 || found == bytes_.end() ? std::nullopt : std::optional(found->second);
    }

    std::uint32_t vertex_array_ = 0;
    std::uint32_t array_buffer_ = 0;
    std::map<std::uint32_t, VertexArray> arrays_;
    std::map<std::uint32_t, double> bytes_;
};

}

std::optional<double> FedAttribute::vertices() const
{
    if (!is_fed || !offset || !buffer_bytes || bytes <= 0 || stride <= 0) return std::nullopt;
    const double behind = *buffer_bytes - *offset - bytes;
    return behind < 0 ? 0 : std::floor(behind / stride) + 1;
}

std::vector<DrawnFrom> drawn_from(const GlTrace& trace)
{
    std::vector<DrawnFrom> all;
    State state;
    for (const GlCall& call : trace.calls) {
        if (!state.take(call) || all.size() == most_draws) break;
        if (const auto count = place_of_count(call)) all.push_back(state.at(call, *count));
    }
    return all;
}

}
