#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <umbral/core/not_implemented.hpp>
#include <vector>

namespace umbral::interaction {

/// The matrix P' such that P' * projection shows nothing but a square of `size` x `size` pixels round the centre of
/// `pixel` (column from the left, row from the **top**), as large as the whole picture: what is not clipped by it
/// appears in the square.
///
/// `picture` is the picture's size in pixels, both sides > 0; `size` > 0. The square may leave the picture, and `pixel`
/// may lie outside. Guarantee of the reference: every entry is the exact one, rounded to float once. Course:
/// FijarViewFrustumSel, gluPickMatrix.
[[nodiscard]] glm::mat4 pick_matrix(const glm::ivec2& pixel, float size, const glm::ivec2& picture);

/// One record of a selection buffer (bloque): something with these names lies in the view volume.
struct SelectionRecord {
    std::uint32_t min_depth = 0;       ///< of its nearest point: 0 at the near plane, 2^32 - 1 at the far one
    std::uint32_t max_depth = 0;       ///< of its farthest point
    std::vector<std::uint32_t> names;  ///< the name stack as it was, from its bottom up; may be empty
};

/// The first `count` records of a selection buffer, in their order. Each begins with three words: the number of its
/// names, its least depth and its greatest; the names follow.
///
/// `count` is what glRenderMode(GL_RENDER) returned. Nothing if it is negative, which says that the buffer was too
/// small, or if the buffer ends before the last of these records does. What stands behind them is not looked at.
/// Course: contenido del buffer de selección.
[[nodiscard]] std::optional<std::vector<SelectionRecord>> parse_selection(std::span<const std::uint32_t> buffer,
                                                                          int count);

/// The place in the list of the record with the smallest min_depth; of several, of the first. Nothing if there are
/// none. Course: BufferSeleccion::finModoSel.
[[nodiscard]] std::optional<std::size_t> nearest_record(std::span<const SelectionRecord> records);

/// What OpenGL keeps from glRenderMode(GL_SELECT) to glRenderMode(GL_RENDER): the name stack and the selection buffer.
///
/// A record is written late: before a command to the names that is carried out, even if it leaves them as they are, and
/// at the end; and only if a primitive was noted since the last record. It has the names as they were then, and the
/// depths of all primitives that were noted since. A command that is refused changes nothing and writes nothing.
/// Course: modo selección, pila de nombres.
class SelectionBuffer {
public:
    static constexpr std::size_t most_names = 64;

    virtual ~SelectionBuffer() = default;

    /// Empties the stack.
    virtual void init_names() = 0;
    /// Replaces the name on top. False, and refused, if the stack is empty.
    virtual bool load_name(std::uint32_t name) = 0;
    /// Puts a name on top. False, and refused, if there are `most_names` already.
    virtual bool push_name(std::uint32_t name) = 0;
    /// Takes the top name away. False, and refused, if the stack is empty.
    virtual bool pop_name() = 0;

    /// Notes a primitive of which a part lies in the view volume, with the depths of the nearest and the farthest point
    /// of that part: 0 <= min_depth <= max_depth <= 1. A depth d is written as d (2^32 - 1), rounded to the nearest
    /// whole number.
    virtual void note_primitive(double min_depth, double max_depth) = 0;

    /// Ends the selection: the number of records, or -1 if one of them had no room in the buffer. Then all begins anew,
    /// with no names and an empty buffer.
    virtual int finish() = 0;

    /// What the last `finish` left: its records, one behind the other. To be asked for right after it: from the next
    /// command on, and if it returned -1, it may be anything.
    [[nodiscard]] virtual std::span<const std::uint32_t> words() const = 0;
};

/// A new one with room for `words` words. It shares nothing with others.
[[nodiscard]] std::unique_ptr<SelectionBuffer> make_selection_buffer(std::size_t words);

}
