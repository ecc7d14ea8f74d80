#pragma once

#include <string>
#include <vector>

#include "judge/trace/gl_calls.hpp"

namespace umbral::grader {

/// A draw call that takes its data from where there is none.
struct DrawFault {
    std::string name;      ///< "reads past the index buffer"
    std::string sentence;  ///< what the call does, and where to look
};

/// What the calls alone show of buffers and vertex arrays, each kind of fault once, at its first draw call, the
/// plainest first: an attribute that has a buffer and is not enabled, or is enabled and has none; more indices than the
/// index buffer holds; a buffer that holds fewer vertices, as an attribute takes them, than are drawn, or than the
/// expected draw call's does. Nothing is said of what was made before the trace begins, of memory of the application's,
/// nor once functions are called that set the same by other ways (glVertexAttribFormat, direct state access).
[[nodiscard]] std::vector<DrawFault> draw_faults(const GlTrace& yours, const GlTrace& expected);

}
