#include <algorithm>
#include <array>
#include <umbral/gl/client_memory.hpp>
#include <umbral/gl/direct.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/pixel_size.hpp>

namespace umbral::gl {
namespace {

/// A fixed-function array: what enables it, and what tells its size (0: always `components`), type (0: a byte) and
/// buffer.
struct FixedArray {
    GLenum enabled;
    GLenum size;
    unsigned components;
    GLenum type;
    GLenum buffer;
};
constexpr std::array fixed_arrays = {
    FixedArray{GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_SIZE, 0, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_BUFFER_BINDING},
    FixedArray{GL_NORMAL_ARRAY, 0, 3, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_BUFFER_BINDING},
    FixedArray{GL_COLOR_ARRAY, GL_COLOR_ARRAY_SIZE, 0, GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_BUFFER_BINDING},
    FixedArray{GL_SECONDARY_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY_SIZE, 0, GL_SECONDARY_COLOR_ARRAY_TYPE,
               GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING},
    FixedArray{GL_INDEX_ARRAY, 0, 1, GL_INDEX_ARRAY_TYPE, GL_INDEX_ARRAY_BUFFER_BINDING},
    FixedArray{GL_EDGE_FLAG_ARRAY, 0, 1, 0, GL_EDGE_FLAG_ARRAY_BUFFER_BINDING},
    FixedArray{GL_FOG_COORD_ARRAY, 0, 1, GL_FOG_COORD_ARRAY_TYPE, GL_FOG_COORD_ARRAY_BUFFER_BINDING}};
constexpr FixedArray texture_array = {GL_TEXTURE_COORD_ARRAY, GL_TEXTURE_COORD_ARRAY_SIZE, 0,
                                      GL_TEXTURE_COORD_ARRAY_TYPE, GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING};

std::uint64_t bytes_of(const FixedArray& array)
{
    if (!direct(&glIsEnabled, "glIsEnabled")(array.enabled) || integer(array.buffer) != 0) return 0;
    const auto components = array.size == 0 ? array.components : static_cast<unsigned>(integer(array.size));
    return std::uint64_t{components} * (array.type == 0 ? 1 : type_size(static_cast<GLenum>(integer(array.type))));
}

/// Of one vertex, in all arrays that lie in no buffer.
std::uint64_t vertex_bytes()
{
    std::uint64_t bytes = 0;
    for (const FixedArray& array : fixed_arrays) bytes += bytes_of(array);
    const auto client_active = direct(&glClientActiveTexture, "glClientActiveTexture");
    const auto chosen = static_cast<GLenum>(integer(GL_CLIENT_ACTIVE_TEXTURE));
    for (int unit = 0; unit < integer(GL_MAX_TEXTURE_COORDS); ++unit) {
        client_active(GL_TEXTURE0 + static_cast<GLenum>(unit));
        bytes += bytes_of(texture_array);
    }
    client_active(chosen);
    const auto attribute = [](int index, GLenum what) {
        GLint value = 0;
        direct(&glGetVertexAttribiv, "glGetVertexAttribiv")(static_cast<GLuint>(index), what, &value);
        return value;
    };
    for (int i = 0; i < integer(GL_MAX_VERTEX_ATTRIBS); ++i) {
        if (attribute(i, GL_VERTEX_ATTRIB_ARRAY_ENABLED) == 0 ||
            attribute(i, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING) != 0)
            continue;
        const auto size = static_cast<unsigned>(attribute(i, GL_VERTEX_ATTRIB_ARRAY_SIZE));
        bytes += std::uint64_t{size == GL_BGRA ? 4 : size} *
                 type_size(static_cast<GLenum>(attribute(i, GL_VERTEX_ATTRIB_ARRAY_TYPE)));
    }
    return bytes;
}

std::uint64_t sum_of(const void* counts, double how_many)
{
    constexpr double most = 65536;
    std::uint64_t sum = 0;
    const auto* count = static_cast<const GLsizei*>(counts);
    if (count == nullptr) return 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::clamp(how_many, 0.0, most)); ++i)
        sum += count[i] > 0 ? static_cast<std::uint64_t>(count[i]) : 0;
    return sum;
}

/// Where a draw says how many vertices it draws, and of what type its indices are (0: it has none).
struct DrawArguments {
    std::string_view beginning;
    std::size_t count;
    std::size_t type;
    std::size_t draws;  ///< 0: there is one; else `count` is an array of so many numbers, or with `indirect` commands
    bool indirect = false;
};
constexpr std::array draw_arguments = {DrawArguments{"glMultiDrawArraysIndirect", 1, 0, 2, true},
                                       DrawArguments{"glMultiDrawElementsIndirect", 2, 1, 3, true},
                                       DrawArguments{"glDrawArraysIndirect", 1, 0, 0, true},
                                       DrawArguments{"glDrawElementsIndirect", 2, 1, 0, true},
                                       DrawArguments{"glMultiDrawArrays", 2, 0, 3},
                                       DrawArguments{"glMultiDrawElements", 1, 2, 4},
                                       DrawArguments{"glDrawArrays", 2, 0, 0},
                                       DrawArguments{"glDrawRangeElements", 3, 4, 0},
                                       DrawArguments{"glDrawElements", 1, 2, 0}};

}

std::uint64_t client_bytes(std::string_view draw, const CallArguments& arguments)
{
    const auto found = std::ranges::find_if(
        draw_arguments, [&](const DrawArguments& each) { return draw.starts_with(each.beginning); });
    if (found == draw_arguments.end()) return 0;
    if (found->indirect) {
        constexpr std::uint64_t command = 20;
        const std::uint64_t draws = found->draws == 0 ? 1 : whole(arguments.number(found->draws));
        return integer(GL_DRAW_INDIRECT_BUFFER_BINDING) == 0 ? draws * (command + vertex_bytes()) : 0;
    }
    const std::uint64_t vertices = found->draws == 0
                                       ? whole(arguments.number(found->count))
                                       : sum_of(arguments.pointer(found->count), arguments.number(found->draws));
    const bool own_indices = found->type != 0 && integer(GL_ELEMENT_ARRAY_BUFFER_BINDING) == 0;
    return vertices *
           (vertex_bytes() + (own_indices ? type_size(static_cast<GLenum>(arguments.number(found->type))) : 0));
}

bool unpacks_from_a_buffer() { return integer(GL_PIXEL_UNPACK_BUFFER_BINDING) != 0; }

}
