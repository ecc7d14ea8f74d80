#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <umbral/gl/forward.hpp>

/// Buffers whose memory the application shares. Private to libumbral-gl.
namespace umbral::gl {

#pragma GCC visibility push(hidden)

/// Which buffers the application can write to without a call, from the one that maps or pins them until they are
/// unmapped or gone.
///
/// What is mapped for writing counts whole when it is mapped, or when it is unmapped if the trace began in between.
/// Parts that the application flushes by itself are no less: drawn by the processor, what was never flushed is seen
/// too. What is still mapped when something is drawn counts again for each later draw and when it is unmapped, since
/// nothing tells what was written in between.
class SharedBuffers {
public:
    /// Takes note of a call that is about to be made, if it maps, unmaps or pins; the bytes that it moves.
    std::uint64_t moved_by(std::string_view function, const CallArguments& arguments);

    /// The bytes that may have been written since the last draw.
    std::uint64_t moved_before_a_draw();

    /// From now on nothing has been counted.
    void begin_trace();

private:
    struct Shared {
        std::uint64_t bytes = 0;
        bool pinned = false;   ///< the application's memory itself: never unmapped
        bool counted = false;  ///< and not drawn from since
    };
    std::map<unsigned, Shared> shared_;  // by the buffer's name
};

#pragma GCC visibility pop

}
