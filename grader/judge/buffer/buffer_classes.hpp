#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "judge/buffer/buffer_cells.hpp"

namespace umbral::grader {

/// What a buffer holds, by the type and the number of its components. It decides the words, never the points.
enum class BufferKind { coverage, ids, depth, normals, texture, cells };
[[nodiscard]] BufferKind kind_of(const Tensor& expected, const BufferCells& cells);

/// "depths", "normals": what its cells are called. Whole numbers are "ids" where the recording calls them so ("ids",
/// "face id"), else "cells".
[[nodiscard]] const char* cells_of(BufferKind kind, std::string_view recorded);

/// Cells of a part of a buffer, both ends included.
struct Box {
    std::size_t left, top, right, bottom;
};

/// Where the wrong cells lie, and whose values they hold.
struct BufferClasses {
    std::size_t wrong = 0;
    std::size_t at_edge =
        0;  ///< within one pixel of an edge of the expected buffer: between ids, between content and background
    std::size_t neighbour_value = 0;  ///< what is expected in one of the 8 neighbours: another owner of the pixel
    std::size_t unknown_value = 0;    ///< a name (id) that the expected buffer holds nowhere
    std::size_t groups = 0;           ///< connected by edges or corners
    std::size_t largest_group = 0;    ///< cells of the largest …
    Box group{};                      ///< … and where it lies
    std::string lines;  ///< "rows 3 to 7": where whole rows or columns are wrong and nothing else is; else empty
};
[[nodiscard]] BufferClasses classify(const Check& check, const BufferCells& cells, BufferKind kind);

/// A rule that the wrong values follow, with what it can be measured by.
struct BufferPattern {
    std::string sentence;  ///< "the shapes are right, but named otherwise: 2 for 1, 1 for 2"; empty if no rule fits
    std::map<std::string, double> metrics;
};
[[nodiscard]] BufferPattern find_pattern(const BufferCells& cells, BufferKind kind);

/// What is wrong as a teacher would say it: the pattern, whole rows, edge or inside, the largest group. "" if nothing
/// is wrong.
[[nodiscard]] std::string in_words(const BufferClasses& classes, const BufferPattern& pattern);

/// 7 x 7 cells round `centre`, yours beside the expected ones, with a legend below; wrong cells are marked by '>'.
[[nodiscard]] std::string buffer_sketch(const BufferCells& cells, BufferKind kind, std::size_t centre);

}
