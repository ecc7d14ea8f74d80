#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::gl {

/// One call of an OpenGL function.
struct TracedCall {
    std::string_view name;          ///< "glDrawArrays"; lives as long as the library
    std::vector<double> arguments;  ///< numbers as passed, enumerants too, and pointers as forward.hpp says
    std::uint64_t bytes =
        0;  ///< bytes read from the application by glBufferData, glTexImage2D and their relatives, else 0
};

/// The OpenGL calls between two marks.
struct Trace {
    static constexpr std::size_t maximum_calls = 65536;

    std::vector<TracedCall> calls;                             ///< in order, the first `maximum_calls` of them
    std::map<std::string, std::uint64_t, std::less<>> counts;  ///< how often each function was called, complete
    std::uint64_t uploaded_bytes = 0;                          ///< of all calls, complete
    bool truncated = false;                                    ///< there were more than `maximum_calls`

    /// How often a function was called.
    [[nodiscard]] std::uint64_t count(std::string_view name) const
    {
        const auto found = counts.find(name);
        return found == counts.end() ? 0 : found->second;
    }
};

/// Starts recording every OpenGL call of the process; calls of this library's own classes are seen too, so mark only
/// what shall count. Throws std::logic_error if a trace is already running.
void begin_trace();

/// Stops recording and returns what was seen. Throws std::logic_error if no trace is running.
[[nodiscard]] Trace end_trace();

/// Bytes that a call reads from the application's memory: 0 for functions that upload nothing, for a null pointer and
/// for an unknown format. Rows of pictures are counted without padding. `arguments` as in TracedCall.
[[nodiscard]] std::uint64_t upload_size(std::string_view name, const std::vector<double>& arguments);

}
