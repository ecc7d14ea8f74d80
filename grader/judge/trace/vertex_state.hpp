#pragma once

#include <map>
#include <optional>
#include <vector>

#include "judge/trace/gl_calls.hpp"

namespace umbral::grader {

/// How a vertex array feeds one attribute.
struct FedAttribute {
    std::optional<bool> enabled{};  ///< nothing: never said
    bool is_fed = false;            ///< glVertexAttribPointer was called for it
    double numbers = 0;             ///< a vertex
    double bytes = 0;               ///< of what is taken for a vertex
    double stride = 0;              ///< bytes from one vertex to the next
    std::optional<double> offset{};
    std::optional<double> buffer_bytes{};  ///< of the buffer it is fed from
    bool is_instanced = false;

    /// So many vertices its buffer holds; nothing if that is not known.
    [[nodiscard]] std::optional<double> vertices() const;
};

/// What one draw call takes its vertices from.
struct DrawnFrom {
    const GlCall* call = nullptr;  ///< glDrawArrays..., glDrawElements... or glDrawRangeElements...
    std::map<int, FedAttribute> attributes;
    std::optional<double> index_buffer_bytes{};
    std::optional<double> first_vertices{};  ///< of glDrawArrays: first + count

    /// Of a call that takes indices: how many, of how many bytes, and where the first lies in the buffer. Nothing if it
    /// takes none, or that is not known.
    struct Indices {
        double count = 0;
        double size = 0;
        double offset = 0;
    };
    std::optional<Indices> indices{};
};

/// Follows buffers and vertex arrays through a trace, up to its first call that sets them by other ways than
/// glBufferData, glVertexAttribPointer and their like. What the trace does not set is not known.
[[nodiscard]] std::vector<DrawnFrom> drawn_from(const GlTrace& trace);

}
