#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <umbral/core/not_implemented.hpp>
#include <umbral/meshes/polygons.hpp>

namespace umbral::meshes {

/// How the data after a PLY file's header are written.
enum class PlyFormat { ascii, little_endian, big_endian };

/// Why a file is refused. If a file has several faults, the first one met when it is read from its beginning counts.
enum class PlyProblem {
    not_ply = 1,  ///< the first line is not "ply"
    header = 2,   ///< a line of the header cannot be understood, contradicts an earlier one, or is missing (format,
                  ///< end_header)
    missing_property = 3,  ///< no element vertex with single numbers x, y and z, or an element face without a list
                           ///< vertex_index or vertex_indices
    truncated = 4,         ///< the data end before all elements are there
    left_over = 5,         ///< more data follow after the last element
    number = 6,            ///< a word is no number of its property's type, or a list has a negative length
    line_length = 7,       ///< ASCII: a line holds fewer or more numbers than its element has
    index = 8,  ///< a corner of a face is no vertex: negative, not whole, or not less than the number of vertices
};

/// What `read_ply` throws. The text says what was expected, what came, and where: of a number in ASCII data that cannot
/// be used, it holds that number and `place()` in digits.
class PlyError : public std::runtime_error {
public:
    PlyError(PlyProblem problem, std::size_t place, const std::string& text)
        : std::runtime_error("PLY: " + text), problem_(problem), place_(place)
    {
    }

    [[nodiscard]] PlyProblem problem() const noexcept { return problem_; }

    /// In the header and in ASCII data: the line, counted from 1. In binary data: the byte of the file, counted from 0,
    /// at which the value begins that cannot be used (of a list: its length, or the corner); of `left_over`, the first
    /// byte too many. Not defined where something is missing (`missing_property`, `truncated`, a header without its end
    /// or format, an empty file).
    [[nodiscard]] std::size_t place() const noexcept { return place_; }

private:
    PlyProblem problem_;
    std::size_t place_;
};

/// The mesh of a PLY file, ASCII or binary, as G. Turk's format 1.0 has it.
///
/// **Header.** Lines end in "\n" or "\r\n"; words are separated by spaces and tabs. `ply` is the first line; `format`,
/// `element`, `property`, `comment`, `obj_info` and `end_header` are the only keywords; `format` stands once, anywhere.
/// Types are char, uchar, short, ushort, int, uint, float, double, and int8, uint8, int16, uint16, int32, uint32,
/// float32, float64; a list's length has an integer type. Counts are at most 2^63 - 1. No two elements, and no two
/// properties of an element, share a name.
///
/// **Elements** come in the header's order, faces may be first. Whatever is not x, y, z of `vertex`, or the first list
/// called vertex_index or vertex_indices of `face`, is read over. There may be no element `face`. Elements without
/// properties take no room at all.
///
/// **ASCII data**: one line an element; blank lines do not count. Integers are decimal; numbers of type float or double
/// are decimal with an optional exponent, or inf, or nan; all may have a sign, + too. What is too large for its type is
/// refused; what is too small becomes zero, of either sign. The program's locale has no influence.
///
/// **Numbers.** A decimal of type float is rounded to the nearest float, one of type double to the nearest double.
/// Coordinates of other types than float are then rounded to float once; a double beyond float's range becomes
/// infinite.
///
/// Guarantees: takes time and memory in proportion to the file, whatever counts the file claims. Throws PlyError, and
/// nothing else but std::bad_alloc. Course: "formato PLY".
[[nodiscard]] PolygonMesh read_ply(std::span<const std::byte> file);

/// The mesh as a PLY file: `vertex` with float x, y, z, then `face` with a list vertex_indices, and nothing else.
///
/// `read_ply` gives back the same mesh, bit for bit (a NaN comes back as some NaN), also faces of more than 255
/// corners. In ASCII each coordinate has no more digits than such a decimal needs, in whatever notation: "0.1", not
/// "0.100000001"; zeros before and behind do not count, nor does the exponent. Whole numbers from 2^24 on may have all
/// of their digits. `std::to_chars` writes such decimals. The program's locale has no influence.
[[nodiscard]] std::string write_ply(const PolygonMesh& mesh, PlyFormat format);

}
