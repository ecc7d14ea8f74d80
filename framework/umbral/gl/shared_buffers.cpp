#include <algorithm>
#include <array>
#include <umbral/gl/direct.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/shared_buffers.hpp>

namespace umbral::gl {
namespace {

/// Where a buffer is bound, and what asks for it.
struct Target {
    GLenum target;
    GLenum binding;
};
constexpr std::array targets = {Target{GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING},
                                Target{GL_ELEMENT_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER_BINDING},
                                Target{GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
                                Target{GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING},
                                Target{GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING},
                                Target{GL_TEXTURE_BUFFER, GL_TEXTURE_BUFFER},
                                Target{GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING},
                                Target{GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER},
                                Target{GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER},
                                Target{GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING},
                                Target{GL_DISPATCH_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER_BINDING},
                                Target{GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING},
                                Target{GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER_BINDING},
                                Target{GL_QUERY_BUFFER, GL_QUERY_BUFFER_BINDING},
                                Target{GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD, GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD}};

/// The buffer that the call is about; 0 for none.
unsigned buffer_of(std::string_view function, const CallArguments& arguments)
{
    if (function.find("Named") != std::string_view::npos) return arguments.name(0);
    const auto found = std::ranges::find(targets, arguments.name(0), &Target::target);
    return found == targets.end() ? 0 : static_cast<unsigned>(integer(found->binding));
}

std::uint64_t parameter_of(unsigned buffer, GLenum what)
{
    GLint64 value = 0;
    if (direct(&glIsBuffer, "glIsBuffer")(buffer))
        direct(&glGetNamedBufferParameteri64v, "glGetNamedBufferParameteri64v")(buffer, what, &value);
    return value > 0 ? static_cast<std::uint64_t>(value) : 0;
}

}

std::uint64_t SharedBuffers::moved_by(std::string_view function, const CallArguments& arguments)
{
    const bool pins = arguments.name(0) == GL_EXTERNAL_VIRTUAL_MEMORY_BUFFER_AMD;
    if ((function == "glBufferData" || function == "glBufferStorage") && !pins) return 0;
    const unsigned buffer = buffer_of(function, arguments);
    if (buffer == 0) return 0;
    if (function.starts_with("glUnmap")) {
        const auto found = shared_.find(buffer);
        if (found == shared_.end()) return 0;
        const std::uint64_t bytes = found->second.counted ? 0 : found->second.bytes;
        shared_.erase(found);
        return bytes;
    }
    if (function.starts_with("glBuffer")) {
        shared_[buffer] = {static_cast<std::uint64_t>(std::max(arguments.number(1), 0.0)), true, true};
        return 0;  // counted as any data
    }
    if (!function.starts_with("glMap")) return 0;
    const bool range = function.ends_with("Range");
    const unsigned access = arguments.name(range ? 3 : 1);
    if (range ? (access & GL_MAP_WRITE_BIT) == 0 : access == GL_READ_ONLY) return 0;
    const std::uint64_t whole = parameter_of(buffer, GL_BUFFER_SIZE);
    const std::uint64_t bytes =
        range ? std::min(whole, static_cast<std::uint64_t>(std::max(arguments.number(2), 0.0))) : whole;
    shared_[buffer] = {bytes, false, true};
    return bytes;
}

std::uint64_t SharedBuffers::moved_before_a_draw()
{
    std::uint64_t bytes = 0;
    std::erase_if(shared_, [&](const auto& entry) {
        const auto& [buffer, shared] = entry;
        return shared.pinned ? parameter_of(buffer, GL_BUFFER_SIZE) == 0 : parameter_of(buffer, GL_BUFFER_MAPPED) == 0;
    });
    for (auto& [buffer, shared] : shared_) {
        if (!shared.counted) bytes += shared.bytes;
        shared.counted = false;
    }
    return bytes;
}

void SharedBuffers::begin_trace()
{
    for (auto& [buffer, shared] : shared_) shared.counted = false;
}

}
