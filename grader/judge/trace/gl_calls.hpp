#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbral::grader {

/// What stands for a pointer that is no offset, in a trace.
inline constexpr double some_address = 1;

/// One call of OpenGL in a recorded trace.
struct GlCall {
    std::string_view name;          ///< "glDrawArrays"; lives as long as the trace's text
    std::vector<double> arguments;  ///< enumerants as numbers; an offset below 64 KiB as it is, else some_address
    std::uint64_t bytes = 0;        ///< uploaded
};

struct GlTrace {
    std::vector<GlCall> calls;
    bool truncated = false;  ///< there were more calls than a trace holds
};

/// Reads what umbral::gl::record_trace wrote: a call a line, "glDrawArrays 4 0 3", with " | 128" behind it where 128
/// bytes were uploaded, and a last line "..." where calls are left out. Believes nothing: any other line makes it
/// nothing.
[[nodiscard]] std::optional<GlTrace> parse_gl_trace(std::string_view text);

/// glDraw..., glMultiDraw..., glBegin, glCallList and the like: does it draw?
[[nodiscard]] bool draws(const GlCall& call);

/// Vertices that the call draws, instances counted each; 1 for glVertex...; 0 where they cannot be told from the
/// arguments.
[[nodiscard]] double vertices_of(const GlCall& call);

/// Where a draw call says how many vertices or indices it takes: the place of that argument. Nothing of other calls.
[[nodiscard]] std::optional<std::size_t> place_of_count(const GlCall& call);

/// Objects that glGen... and glCreate..., or glDelete..., make or delete, by the count they are given.
[[nodiscard]] double objects_created(const GlCall& call);
[[nodiscard]] double objects_deleted(const GlCall& call);

/// Does it set state that draws depend on (enables, bindings, programs, attribute pointers, blending, viewport ...)?
[[nodiscard]] bool changes_state(const GlCall& call);

/// What the core profile has instead of a function that it lacks, as half a sentence; null for a function that it has.
[[nodiscard]] const char* instead_of_deprecated(std::string_view name);

/// The call as C++ has it, as "glDrawArrays(GL_TRIANGLES, 0, 3)": enumerants by name where it is known which argument
/// is one.
[[nodiscard]] std::string in_cpp(const GlCall& call);

/// The same call but for the numbers of objects, which each program gets as they come, and for places in buffers.
[[nodiscard]] bool same_call(const GlCall& a, const GlCall& b);

}
